// Alpha of colour maps in graphs: with footprints, without, and as the pictures of a material.
#include <cmath>

#include <gtest/gtest.h>

#include "atlas/base/json.h"
#include "procedural/color/srgb.h"
#include "procedural/graph/planes.h"
#include "procedural/graph/values.h"
#include "tests/procedural/graph/cases.h"

namespace burl {
namespace {

using Json = nlohmann::ordered_json;

/// Two stops over the first coordinate.
const char* const fade = R"({"node": "color_map", "wrap": "clamp",
    "stops": [[0, "#ff800033"], [1, "#0a3cc8cc"]],
    "input": {"node": "coordinate", "direction": [1, 0, 0]}})";

std::array<double, 4> fade_at(double t) {
    const auto between = [&](double low, double high) { return (1.0 - t) * low + t * high; };
    const double a = 51 / 255.0, b = 204 / 255.0;
    return {between(a, b * srgb_decode(10 / 255.0)),
            between(a * srgb_decode(128 / 255.0), b * srgb_decode(60 / 255.0)),
            between(0.0, b * srgb_decode(200 / 255.0)), between(a, b)};
}

TEST(GraphAlpha, ColourMapsGiveColoursTimesAlpha) {
    const GraphEvaluator evaluate(graph_of(fade));
    for (const double x : {0.0, 0.125, 0.5, 0.7, 1.0}) {
        const GraphSample sample = evaluate({x, 3, 4});
        for (std::size_t c = 0; c < 4; ++c)
            EXPECT_NEAR(sample.channels[c].value, fade_at(x)[c], 1e-15) << x << " " << c;
    }
}

TEST(GraphAlpha, EveryFilterAveragesAlphaAsItDoesColours) {
    // From -1/2 to 1/2 the mean is that of a half at 0 and of a half from 0 to 1/2.
    const Footprint footprint{{1, 0, 0}, {0, 0, 0}};
    for (const FilterKind kind : {FilterKind::exact, FilterKind::trapezoid, FilterKind::table_sat,
                                  FilterKind::table_sat3}) {
        const GraphSample sample = GraphEvaluator(graph_of(fade), {kind})({0, 0, 0}, footprint);
        for (std::size_t c = 0; c < 4; ++c)
            EXPECT_NEAR(sample.channels[c].value, 0.5 * fade_at(0.0)[c] + 0.5 * fade_at(0.25)[c],
                        1e-6)
                << int(kind) << " " << c;
    }
    const Footprint narrow{{0.25, 0, 0}, {0, 0, 0}};
    const GraphSample mip =
        GraphEvaluator(graph_of(fade), {FilterKind::table_mip})({0.5, 0, 0}, narrow);
    EXPECT_NEAR(mip.channels[3].value, fade_at(0.5)[3], 1e-6);
}

TEST(GraphAlpha, AlphaHasItsGradient) {
    const GraphSample sample = GraphEvaluator(graph_of(fade))({0.3, 0, 0});
    EXPECT_NEAR(sample.channels[3].slope.x, 0.6, 1e-12);
    EXPECT_EQ(sample.channels[3].slope.y, 0.0);
}

TEST(GraphAlpha, ValuesAloneHaveTheAlphaOfTheReference) {
    const TextureGraph graph = graph_of(R"({"node": "color_map", "wrap": "repeat",
        "stops": [[0.1, "#ffffff00"], [0.5, "#204060"], [0.5, "#ff000080"], [0.9, "#00ff0010"]],
        "input": {"node": "field", "quadric": {"A": 1, "F": 2, "I": 0.3}}})");
    const GraphValues values(graph, nullptr, GraphOutput::planes);
    ASSERT_EQ(values.results().size(), 4u);
    GraphValues::Scratch scratch = values.make_scratch();
    double least = 1.0, most = 0.0;
    for (const Vec3d& p : random_points(300, 4.0, 8)) {
        for (int axis = 0; axis < 3; ++axis) scratch[Register(axis)][0] = p[axis];
        values.program().run(1, scratch);
        const GraphSample sample = GraphEvaluator(graph)(p);
        for (std::size_t c = 0; c < 4; ++c)
            EXPECT_NEAR(*scratch[values.results()[c]], sample.channels[c].value, 1e-12);
        least = std::min(least, sample.channels[3].value);
        most = std::max(most, sample.channels[3].value);
    }
    EXPECT_LT(least, 0.1);
    EXPECT_GT(most, 0.9);
}

TEST(GraphAlpha, AMapIsALayerThatShowsWhatLiesBelow) {
    const GraphSample sample = GraphEvaluator(graph_of(std::string(R"({"node": "layer_over",
        "base": "#ffffff", "top": )") + fade + "}"))({0.5, 0, 0});
    const auto top = fade_at(0.5);
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(sample.channels[c].value, top[c] + 1.0 - top[3], 1e-15);
    EXPECT_DOUBLE_EQ(sample.channels[3].value, 1.0);
}

TEST(GraphAlpha, MapsWithTransparentStopsAreNoPlainTextures) {
    const auto json = Json::parse(
        R"({"node": "color_map", "wrap": "clamp", "stops": [[0.0, "#ffffff00"], [1.0, "#ffffff"]],
            "input": {"node": "field", "quadric": {"D": 0.5}, "noise": []}})");
    TextureGraph graph = graph_from_json(json);
    EXPECT_EQ(plain_texture(graph), nullptr);
    EXPECT_FALSE(is_opaque(graph, graph.result));
    EXPECT_EQ(graph_from_json(graph_to_json(graph)), graph);
    EXPECT_EQ(graph_to_json(graph)["stops"][0][1], "#ffffff00");
    EXPECT_EQ(graph_to_json(graph)["stops"][1][1], "#ffffff");
    EXPECT_NEAR(GraphEvaluator(graph)({0.25, 0, 0}).channels[3].value, 0.25, 1e-15);
    graph.textures[0].colors.stops[0].alpha = 255;
    EXPECT_NE(plain_texture(graph), nullptr);
    EXPECT_TRUE(is_opaque(graph, graph.result));
}

}  // namespace
}  // namespace burl
