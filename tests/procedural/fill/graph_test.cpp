#include "procedural/fill/graph.h"

#include <cmath>

#include <gtest/gtest.h>

#include "procedural/color/srgb.h"
#include "procedural/fill/synthesize.h"
#include "tests/procedural/graph/cases.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

const char* const busy = R"({"node": "layer_over", "top": {"node": "scale", "a": "#ffffff80",
    "b": {"node": "checkerboard_3d", "aa": "supersample"}},
    "base": {"node": "color_map", "stops": [[0, "#000000"], [1, "#ff8040"]],
    "input": {"node": "warp", "input": {"node": "add", "a": {"node": "wrinkled"},
    "b": {"node": "dots"}}}}})";

TEST(GraphEvaluator, BatchesEqualSinglePoints) {
    const std::vector<Vec3d> points = random_points(700, 5.0, 2);
    const std::vector<Footprint> footprints(points.size(), {{0.02, 0.01, 0}, {0, -0.03, 0.01}});
    for (const GraphCase& graph : graph_cases) {
        const GraphEvaluator evaluate(graph_of(graph.json));
        expect_batches_equal_points(evaluate, points, footprints, graph.node);
    }
}

TEST(SynthesizeGraph, BytesDoNotDependOnThreads) {
    const SolidAtlas solid = SyntheticAtlas{}.make(3);
    const TextureGraph graph = graph_of(busy);
    for (const Filter filter :
         {Filter{}, Filter{FilterKind::trapezoid}, Filter{FilterKind::supersample, 5}}) {
        const auto one = synthesize_graph<Rgb8>(solid, graph, {}, filter, 1);
        const auto precise = synthesize_graph<RgbF>(solid, graph, {}, filter, 1);
        for (const int threads : {2, 3, 0}) {
            EXPECT_EQ(synthesize_graph<Rgb8>(solid, graph, {}, filter, threads), one);
            EXPECT_EQ(synthesize_graph<RgbF>(solid, graph, {}, filter, threads), precise);
        }
    }
}

TEST(SynthesizeGraph, FillsTexelsWithTheirOwnPoints) {
    const SolidAtlas solid = SyntheticAtlas{}.make(5);
    const TextureGraph graph = graph_of(busy);
    const GraphEvaluator evaluate(graph);
    const Affine3 map{Mat3d(3.0), Vec3d(0.1, 0.2, 0.3)};
    const auto points =
        synthesize_graph<RgbF>(solid, graph, map, Filter{}, 2, PrecisionKind::float64);
    const auto areas = synthesize_graph<Rgb16>(solid, graph, map, Filter{FilterKind::trapezoid}, 2,
                                               PrecisionKind::float64);
    const SrgbEncoder<std::uint16_t> encode;
    int owned = 0;
    for (std::size_t y = 0; y < solid.size; y += 3)
        for (const Span& span : solid.row(y)) {
            const TexelMap& texel = solid.maps[span.map];
            const Vec3d p = map(texel(span.x, std::int64_t(y)));
            EXPECT_EQ(points(span.x, y).g, float(evaluate(p).color().y));
            const Footprint footprint{3.0 * texel.step_x, 3.0 * texel.step_y};
            EXPECT_EQ(areas(span.x, y).r, encode(evaluate(p, footprint).color().x));
            ++owned;
        }
    EXPECT_GT(owned, 50);
    // What no triangle owns has the colour at the origin.
    SolidAtlas bare;
    bare.size = 2;
    bare.row_begin = {0, 0, 0};
    EXPECT_EQ(synthesize_graph<RgbF>(bare, graph, map, Filter{}, 1, PrecisionKind::float64)(1, 1).r,
              float(evaluate(Vec3d(0.0)).color().x));
}

double largest_difference(const Image<RgbF>& a, const Image<RgbF>& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const RgbF &p = a.pixels()[i], &q = b.pixels()[i];
        for (const float d : {p.r - q.r, p.g - q.g, p.b - q.b})
            largest = std::max(largest, std::abs(double(d)));
    }
    return largest;
}

TEST(SynthesizeGraph, AMapOverAFieldFiltersAsItDoesOutsideOfAGraph) {
    // As a node of a larger graph, inside `mix`, and as the two that have kernels of their own.
    const std::string map = R"({"node": "color_map", "wrap": "clamp",
        "stops": [[0, "#102030"], [0.4, "#f0e0d0"], [0.4, "#4080c0"], [1, "#102030"]],
        "input": {"node": "field", "quadric": {"D": 0.8},
                  "noise": [{"kind": "value", "frequency": [3, 3, 3], "octaves": 4,
                             "amplitude": 0.5}]}})";
    const TextureGraph graph = graph_of(R"({"node": "mix", "amount": 1, "b": )" + map + "}");
    ASSERT_EQ(graph.textures.size(), 2u);  // of color_map and of field
    Texture texture = graph.textures[0];
    for (const Texture& part : graph.textures) {
        if (!part.noise.empty()) texture.noise = part.noise, texture.quadric = part.quadric;
        if (!part.colors.stops.empty()) texture.colors = part.colors;
    }
    const SolidAtlas solid = SyntheticAtlas{64, 16, 0.0, 0.05, false}.make(11);
    using enum FilterKind;
    const auto points = synthesize_model<RgbF>(solid, texture, {}, 1);
    for (const FilterKind kind : {table_mip, table_sat, table_sat3, exact, trapezoid})
        for (const bool fade : {false, true}) {
            const Filter filter{kind, 1, fade};
            const auto field = synthesize_model<RgbF>(solid, texture, {}, 1, filter);
            EXPECT_LT(
                largest_difference(synthesize_graph<RgbF>(solid, graph, {}, filter, 1), field),
                1e-4)
                << int(kind);
            EXPECT_GT(largest_difference(points, field), 0.1);
        }
}

TEST(SynthesizeGraph, SupersamplingApproachesWhatNodesKnow) {
    // Stripes a quarter of a texel to four texels wide: the box's mean against many samples.
    const SolidAtlas solid = SyntheticAtlas{64, 16, 0.0, 0.3, false}.make(7);
    const TextureGraph graph = graph_of(R"({"node": "stripes", "period": 0.4})");
    const auto nodes = synthesize_graph<RgbF>(solid, graph, {}, {FilterKind::trapezoid}, 2);
    const auto many = synthesize_graph<RgbF>(solid, graph, {}, {FilterKind::supersample, 64}, 2);
    const auto one = synthesize_graph<RgbF>(solid, graph, {}, {}, 2);
    double error = 0.0, unfiltered = 0.0;
    for (std::size_t i = 0; i < many.pixels().size(); ++i) {
        error += std::pow(nodes.pixels()[i].r - many.pixels()[i].r, 2);
        unfiltered += std::pow(one.pixels()[i].r - many.pixels()[i].r, 2);
    }
    EXPECT_LT(std::sqrt(error / unfiltered), 0.25);
}

}  // namespace
}  // namespace burl
