// Texture graphs through OpenGL against the host's synthesis: the same bytes in float64, nearly the
// same colours in float32.
#include "app/gl_graph.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/bench_meshes.h"
#include "app/embedded.h"
#include "app/gl_synthesizer.h"
#include "app/pipeline.h"
#include "procedural/graph_table.h"
#include "procedural/noise_names.h"
#include "procedural/synthesize_graph.h"
#include "tests/app/gl_fixture.h"
#include "tests/procedural/graph_cases.h"
#include "tests/procedural/synthetic_atlas.h"

namespace burl {
namespace {

using testing::HasSubstr;
using GlGraphTest = GlTest;

const Affine3 somewhere{Mat3d(1.7), Vec3d(0.3, -0.2, 0.1)};

template <class Pixel>
Image<Pixel> on_host(const SolidAtlas& solid, const TextureGraph& graph, const Affine3& map) {
    if constexpr (std::is_same_v<Pixel, Rgb8>)
        return synthesize_graph_rgb8(solid, graph, map, Filter{}, 1);
    else if constexpr (std::is_same_v<Pixel, Rgb16>)
        return synthesize_graph_rgb16(solid, graph, map, Filter{}, 1);
    else
        return synthesize_graph_rgbf(solid, graph, map, Filter{}, 1);
}

template <class Pixel>
Image<Pixel> drawn(GlGraphSynthesis& gl, const SolidAtlas& solid, const TextureGraph& graph,
                   const Affine3& map) {
    Image<Pixel> image;
    gl.synthesize(solid, graph, map, 1, image);
    return image;
}

std::size_t colors_of(const Image<RgbF>& image) {
    std::set<std::array<float, 3>> colors;
    for (const RgbF& c : image.pixels()) colors.insert({c.r, c.g, c.b});
    return colors.size();
}

/// Linear light, which 8- and 16-bit codes follow from.
void expect_equal(GlGraphSynthesis& gl, std::string_view name, const TextureGraph& graph,
                  const SolidAtlas& solid) {
    const Image<RgbF> expected = on_host<RgbF>(solid, graph, somewhere);
    EXPECT_EQ(differing(drawn<RgbF>(gl, solid, graph, somewhere), expected), 0u) << name;
    if (name != "constant") {
        EXPECT_GT(colors_of(expected), 1u) << name;
    }
}

TEST_F(GlGraphTest, ColourMapsMayHaveManyStops) {
    const auto colors = [](int stops) {
        std::string json = R"({"node": "color_map", "input": {"node": "coordinate"}, "stops": [)";
        for (int i = 0; i < stops; ++i)
            json += fmt::format(R"({}[{}, "#{:06x}"])", i == 0 ? "" : ", ", double(i) / stops,
                                i * 977 % 0xffffff);
        return graph_of(json + "]}");
    };
    GlGraphSynthesis gl(*context);
    expect_equal(gl, "many stops", colors(int(most_glsl_stops)), SyntheticAtlas{}.make(2));
    EXPECT_THAT(gl.problem(colors(int(most_glsl_stops) + 1)), HasSubstr("257 stops"));
}

TEST_F(GlGraphTest, CasesAreOfAllNodes) {
    std::set<std::string_view> nodes;
    for (const GraphCase& graph : graph_cases) nodes.insert(graph.node);
    EXPECT_EQ(nodes.size(), graph_table().size());
}

/// Tests of one shader each: compiling one takes a fifth of a second.
class GlGraphNodeTest : public GlTest, public testing::WithParamInterface<GraphCase> {};

TEST_P(GlGraphNodeTest, HasTheHostsBits) {
    GlGraphSynthesis gl(*context);
    expect_equal(gl, GetParam().node, graph_of(GetParam().json),
                 SyntheticAtlas{64, 16, 0.4, 0.03}.make(7));
}

TEST_F(GlGraphTest, SlopesAreRefusedWithOneSentence) {
    GlGraphSynthesis gl(*context);
    const SolidAtlas solid = SyntheticAtlas{}.make(1);
    try {
        drawn<Rgb8>(gl, solid, graph_of(R"({"node": "slope", "input": {"node": "fbm"}})"), {});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::unsupported);
        EXPECT_THAT(error.what(), HasSubstr("slope"));
    }
}

class GlGraphNoiseTest : public GlTest, public testing::WithParamInterface<Named<NoiseKind>> {};

TEST_P(GlGraphNoiseTest, HasTheHostsBits) {
    GlGraphSynthesis gl(*context);
    const SolidAtlas solid = SyntheticAtlas{64, 16, 3.0, 0.04}.make(3);
    const auto& [name, kind, text] = GetParam();
    expect_equal(gl, name,
                 graph_of(fmt::format(R"({{"node": "wrinkled", "kind": "{}",
        "octaves": 3, "lacunarity": 2.1, "seed": 77}})",
                                      name)),
                 solid);
    if (!has_dimensions(kind, 4)) return;
    expect_equal(gl, name,
                 graph_of(fmt::format(R"({{"node": "fbm", "kind": "{}",
        "octaves": 2, "time": 0.4, "time_period": {}}})",
                                      name, kind == NoiseKind::simplex ? 0 : 3)),
                 solid);
}

INSTANTIATE_TEST_SUITE_P(Kinds, GlGraphNoiseTest, testing::ValuesIn(noise_kinds),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_F(GlGraphTest, FieldsHaveTheHostsBits) {
    GlGraphSynthesis gl(*context);
    const SolidAtlas solid = SyntheticAtlas{64, 16, 1e4, 0.04}.make(9);
    expect_equal(gl, "shapes, periods and far away", graph_of(R"({"node": "field", "noise": [
        {"kind": "perlin", "shape": "ridged", "octaves": 10, "frequency": [3, 3, 3]},
        {"kind": "worley", "feature": "f2-f1", "period": [4, 0, 6], "octaves": 2},
        {"kind": "value", "fade": "linear", "seed": 4294967295, "octaves": 2},
        {"kind": "value", "fade": "smooth", "period": [5, 5, 5]}]})"),
                 solid);
}

TEST_F(GlGraphTest, ImagesHaveTheHostsBitsWhateverLiesBeyond) {
    GlGraphSynthesis gl(*context);
    const SolidAtlas solid = SyntheticAtlas{}.make(5);
    for (const char* wrap : {"repeat", "black", "clamp"})
        expect_equal(gl, wrap,
                     graph_of(fmt::format(R"({{"node": "image", "file": "image.png",
            "wrap": "{}"}})",
                                          wrap)),
                     solid);
}

TEST_F(GlGraphTest, EveryImageIsReadWhereItIsNamed) {
    const auto image = [](const std::string& file) {
        Image<Rgb8> pixels = case_image(file);
        if (file == "turned.png")
            for (std::size_t y = 0; y < pixels.height(); ++y) std::ranges::reverse(pixels.row(y));
        return pixels;
    };
    const TextureGraph graph = graph_from_json(nlohmann::ordered_json::parse(R"({"node": "mix",
        "a": {"node": "image", "file": "image.png"}, "b": {"node": "image", "file": "turned.png"},
        "amount": {"node": "coordinate", "direction": [1, 1, 0]}})"),
                                               image);
    GlGraphSynthesis gl(*context);
    expect_equal(gl, "two images", graph, SyntheticAtlas{}.make(5));
}

TEST_F(GlGraphTest, CodesAreTheHosts) {
    GlGraphSynthesis gl(*context);
    const SolidAtlas solid = SyntheticAtlas{}.make(6);
    const TextureGraph graph = graph_of(R"({"node": "mix", "a": "#20ff40", "b": {"node": "marble"},
        "amount": {"node": "coordinate", "direction": [1, 1, 0]}})");
    EXPECT_EQ(
        differing(drawn<Rgb8>(gl, solid, graph, somewhere), on_host<Rgb8>(solid, graph, somewhere)),
        0u);
    EXPECT_EQ(differing(drawn<Rgb16>(gl, solid, graph, somewhere),
                        on_host<Rgb16>(solid, graph, somewhere)),
              0u);
}

TEST_F(GlGraphTest, TilesLeaveNoTrace) {
    const SolidAtlas solid = SyntheticAtlas{}.make(6);
    const TextureGraph graph = graph_of(R"({"node": "wrinkled", "octaves": 2})");
    GlSynthesisLimits limits;
    limits.tile = 24;
    GlGraphSynthesis gl(*context, limits);
    EXPECT_EQ(
        differing(drawn<Rgb8>(gl, solid, graph, somewhere), on_host<Rgb8>(solid, graph, somewhere)),
        0u);
    EXPECT_EQ(gl.work().passes, 9);
}

std::vector<std::string> graph_presets() {
    std::vector<std::string> names;
    for (const EmbeddedFile& preset : embedded_recipes()) {
        const std::string name(preset.name.substr(0, preset.name.rfind('.')));
        if (!load_recipe(name).graph.empty() && name != "noise-slope") names.push_back(name);
    }
    return names;
}

class GlGraphPresetTest : public GlTest, public testing::WithParamInterface<std::string> {};

TEST_P(GlGraphPresetTest, HasTheHostsBytes) {
    GlGraphSynthesis gl(*context);
    Pipeline pipeline(torus(300));
    const Recipe recipe = load_recipe(GetParam(), {"atlas.size=64", "atlas.kind=area"});
    pipeline.set_recipe(recipe);
    const Affine3 map = texture_from_solid(recipe);
    EXPECT_EQ(differing(drawn<Rgb8>(gl, pipeline.solid(), recipe.graph, map),
                        on_host<Rgb8>(pipeline.solid(), recipe.graph, map)),
              0u);
}

INSTANTIATE_TEST_SUITE_P(Presets, GlGraphPresetTest, testing::ValuesIn(graph_presets()),
                         [](const auto& test) {
                             std::string name = test.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST_F(GlGraphTest, BakesThroughOpenGlHaveTheHostsBytes) {
    Pipeline pipeline(torus(300));
    pipeline.set_recipe(load_recipe("checks", {"atlas.size=64"}));
    const Image<Rgb8> expected = pipeline.synthesize<Rgb8>();
    const std::shared_ptr<TextureSynthesizer> gl = make_gl_synthesizer(create_osmesa_context());
    EXPECT_EQ(gl->problem(pipeline.recipe()), "");
    EXPECT_THAT(gl->problem(load_recipe("noise-slope")), HasSubstr("slope"));
    pipeline.set_synthesizer(gl);
    EXPECT_EQ(differing(pipeline.synthesize<Rgb8>(), expected), 0u);
    EXPECT_EQ(gl->report()["passes"], 1);
}

/// Share of texels that are further apart than `error` in some channel.
double share_beyond(const Image<RgbF>& a, const Image<RgbF>& b, double error) {
    double beyond = 0.0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const RgbF &p = a.pixels()[i], &q = b.pixels()[i];
        const double away =
            std::max({std::abs(double(p.r) - double(q.r)), std::abs(double(p.g) - double(q.g)),
                      std::abs(double(p.b) - double(q.b))});
        beyond += away <= error ? 0.0 : 1.0;
    }
    return beyond / double(a.pixels().size());
}

TEST_P(GlGraphNodeTest, StaysCloseInFloat32) {
    GlSynthesisLimits limits;
    limits.float64 = false;
    GlGraphSynthesis gl(*context, limits);
    const SolidAtlas solid = SyntheticAtlas{64, 16, 0.0, 0.01}.make(7);
    const TextureGraph graph = graph_of(GetParam().json);
    const Image<RgbF> expected = on_host<RgbF>(solid, graph, {});
    // Where a node jumps, a texel may fall on the other side.
    EXPECT_LE(share_beyond(drawn<RgbF>(gl, solid, graph, {}), expected, 2e-6), 0.002);
}

std::vector<GraphCase> drawable_cases() {
    std::vector<GraphCase> cases(graph_cases.begin(), graph_cases.end());
    std::erase_if(cases, [](const GraphCase& graph) { return graph.node == "slope"; });
    return cases;
}

INSTANTIATE_TEST_SUITE_P(Nodes, GlGraphNodeTest, testing::ValuesIn(drawable_cases()),
                         [](const auto& test) { return std::string(test.param.node); });

}  // namespace
}  // namespace burl
