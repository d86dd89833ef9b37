// Texture graphs through OpenGL against the host's synthesis: the same bytes in float64, nearly the
// same colours in float32.
#include "app/gl/fill/synthesize.h"
#include "app/recipe/edit/recipe_json.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/base/embedded.h"
#include "app/bench/meshes.h"
#include "app/gl/fill/synthesizer.h"
#include "app/pipeline/pipeline.h"
#include "atlas/base/json.h"
#include "procedural/fill/graph.h"
#include "procedural/glsl/functions.h"
#include "procedural/graph/table.h"
#include "procedural/noise/names.h"
#include "tests/app/gl/device/fixture.h"
#include "tests/app/gl/fill/graph_pictures.h"
#include "tests/procedural/graph/cases.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

using testing::HasSubstr;
using GlGraphTest = GlTest;

TextureGraph map_of(int stops) {
    std::string json = R"({"node": "color_map", "input": {"node": "coordinate"}, "stops": [)";
    for (int i = 0; i < stops; ++i)
        json += fmt::format(R"({}[{}, "#{:06x}"])", i == 0 ? "" : ", ", double(i) / stops,
                            i * 977 % 0xffffff);
    return graph_of(json + "]}");
}

TEST_F(GlGraphTest, ColourMapsMayHaveManyStops) {
    GlSynthesis gl(*context);
    const SolidAtlas solid = SyntheticAtlas{}.make(2);
    for (const int stops : {int(most_compared_pieces) - 2, int(most_compared_pieces) + 1, 5000}) {
        EXPECT_EQ(gl.problem(map_of(stops)), "");
        expect_equal(gl, fmt::format("{} stops", stops), map_of(stops), solid);
    }
    const Filter exact{FilterKind::exact};
    EXPECT_EQ(gl.problem(map_of(int(most_sloped_stops)), exact), "");
    EXPECT_THAT(gl.problem(map_of(int(most_sloped_stops) + 1), exact), HasSubstr("257 stops"));
}

TEST_F(GlGraphTest, ManyStopsInFloat32) {
    GlSynthesisLimits limits;
    limits.float64 = false;
    GlSynthesis gl(*context, limits);
    const SolidAtlas solid = SyntheticAtlas{}.make(2);
    const TextureGraph graph = map_of(500);
    const Image<RgbF> expected = on_host<RgbF>(solid, graph, graph_somewhere),
                      image = drawn<RgbF>(gl, solid, graph, graph_somewhere);
    for (std::size_t i = 0; i < image.pixels().size(); ++i)
        EXPECT_NEAR(image.pixels()[i].r, expected.pixels()[i].r, 2e-4f);
}

TEST_F(GlGraphTest, CasesAreOfAllNodes) {
    std::set<std::string_view> nodes;
    for (const GraphCase& graph : graph_cases) nodes.insert(graph.node);
    const auto is_shaded = [](const NodeType& type) {
        return type.mask.components == 0 && !on_the_host_alone(type);
    };
    EXPECT_EQ(std::ptrdiff_t(nodes.size()), std::ranges::count_if(graph_table(), is_shaded));
}

/// Tests of one shader each: compiling one takes a fifth of a second.
class GlGraphNodeTest : public GlTest, public testing::WithParamInterface<GraphCase> {};

TEST_P(GlGraphNodeTest, HasTheHostsBits) {
    GlSynthesis gl(*context);
    expect_equal(gl, GetParam().node, graph_of(GetParam().json),
                 SyntheticAtlas{64, 16, 0.4, 0.03}.make(7));
}

class GlGraphNoiseTest : public GlTest, public testing::WithParamInterface<Named<NoiseKind>> {};

/// Slopes of all kinds of nodes: the host's own gradients, in float64 where they are not noise.
class GlGraphSlopeTest : public GlTest, public testing::WithParamInterface<GraphCase> {};

TEST_P(GlGraphSlopeTest, HasTheHostsBits) {
    GlSynthesis gl(*context);
    const TextureGraph graph = graph_of(fmt::format(
        R"({{"node": "slope", "direction": [0.3, -0.2, 0.25], "input": {}}})", GetParam().json));
    const SolidAtlas solid = SyntheticAtlas{64, 16, 0.4, 0.03}.make(7);
    const Image<RgbF> expected = on_host<RgbF>(solid, graph, graph_somewhere),
                      image = drawn<RgbF>(gl, solid, graph, graph_somewhere);
    EXPECT_GT(colors_of(expected), 1u);
    EXPECT_EQ(differing(image, expected), 0u);
}

/// Inputs that vary, by every node that gives a number.
constexpr std::array slope_cases{
    GraphCase{"coordinate", R"({"node": "power", "exponent": 2, "input": {"node": "coordinate",
        "direction": [0.5, -2, 1.5], "offset": 0.3}})"},
    GraphCase{"add", R"({"node": "add", "a": {"node": "fbm"}, "b": {"node": "coordinate"}})"},
    GraphCase{"subtract",
              R"({"node": "subtract", "a": {"node": "fbm"}, "b": {"node": "coordinate"}})"},
    GraphCase{"multiply",
              R"({"node": "multiply", "a": {"node": "fbm"}, "b": {"node": "coordinate"}})"},
    GraphCase{"divide", R"({"node": "divide", "a": {"node": "coordinate"},
        "b": {"node": "add", "a": {"node": "fbm"}, "b": 3}})"},
    GraphCase{"min", R"({"node": "min", "a": {"node": "fbm"}, "b": {"node": "fbm", "seed": 9}})"},
    GraphCase{"max", R"({"node": "max", "a": {"node": "fbm"}, "b": {"node": "fbm", "seed": 9}})"},
    GraphCase{"clamp", R"({"node": "clamp", "low": -0.2, "high": 0.1, "input": {"node": "fbm"}})"},
    GraphCase{"remap", R"({"node": "remap", "in_low": -0.3, "in_high": 0.25, "out_low": 2,
        "out_high": -1, "input": {"node": "fbm"}})"},
    GraphCase{"abs", R"({"node": "abs", "input": {"node": "fbm", "octaves": 2}})"},
    GraphCase{"power", R"({"node": "power", "exponent": 2.5,
        "input": {"node": "add", "a": 0.5, "b": {"node": "fbm"}}})"},
    GraphCase{"sin", R"({"node": "sin", "input": {"node": "multiply", "a": 5,
        "b": {"node": "fbm", "octaves": 2}}})"},
    GraphCase{"slope", R"({"node": "multiply", "a": {"node": "fbm"}, "b": {"node": "slope",
        "direction": [1, -2, 3], "input": {"node": "fbm", "seed": 4}}})"},
    GraphCase{"floor", R"({"node": "multiply", "a": {"node": "floor",
        "input": {"node": "coordinate"}}, "b": {"node": "fbm"}})"},
    GraphCase{"fract", R"({"node": "fract", "input": {"node": "multiply", "a": 3,
        "b": {"node": "fbm"}}})"},
    GraphCase{"smoothstep", R"({"node": "smoothstep", "low": -0.4, "high": 0.6,
        "input": {"node": "fbm"}})"},
    GraphCase{"length", R"({"node": "length", "x": {"node": "fbm"}, "z": {"node": "coordinate"}})"},
    GraphCase{"distance", R"({"node": "distance", "point": [0.3, -0.2, 0.5]})"},
    GraphCase{"dot", R"({"node": "dot", "x": {"node": "fbm"}, "y": {"node": "fbm", "seed": 9},
        "direction": [1, -2, 0.5]})"},
    GraphCase{"split", R"({"node": "split", "channel": "green", "input": {"node": "mix",
        "a": {"node": "color_map", "stops": [[0, "#102030"], [1, "#f0e0d0"]],
              "input": {"node": "fbm"}}, "b": {"node": "marble"}}})"},
    GraphCase{"hsv", R"({"node": "split", "channel": "red", "input": {"node": "hsv", "hue": 0.2,
        "saturation": 2, "input": {"node": "map_uv", "scale": [0.3, 0.2],
        "input": {"node": "image", "file": "image.png"}}}})"},
    GraphCase{"levels",
              R"({"node": "levels", "in_black": -0.5, "gamma": 2.2, "input": {"node": "fbm"}})"},
    GraphCase{"mix", R"({"node": "mix", "a": {"node": "fbm"}, "b": {"node": "coordinate"},
        "amount": {"node": "fbm", "seed": 3}})"},
    GraphCase{"bilerp", R"({"node": "bilerp", "v00": 0.1, "v01": {"node": "fbm"}, "v10": 0.7,
        "v11": 2})"},
    GraphCase{"blend", R"({"node": "blend", "mode": "overlay", "top": {"node": "fbm"},
        "base": {"node": "add", "a": 0.5, "b": {"node": "fbm", "seed": 9}}, "mask": 0.7})"},
    GraphCase{"checkerboard", R"({"node": "checkerboard", "a": {"node": "fbm"}, "b": 0.5})"},
    GraphCase{"checkerboard_3d",
              R"({"node": "checkerboard_3d", "a": {"node": "fbm"}, "aa": "trapezoid"})"},
    GraphCase{"stripes", R"({"node": "stripes", "direction": [1, 2, -1], "period": 0.7,
        "a": {"node": "fbm"}})"},
    GraphCase{"ramp", R"({"node": "ramp", "direction": [1, 2, -1], "period": 0.7, "a": 0.3,
        "b": {"node": "fbm"}})"},
    GraphCase{"sine", R"({"node": "sine", "direction": [1, 2, -1], "period": 0.7})"},
    GraphCase{"rings", R"({"node": "rings", "spacing": 0.4, "a": {"node": "fbm"}})"},
    GraphCase{"wood_grain", R"({"node": "wood_grain", "spacing": 0.4, "wobble": 0.3, "wobbles": 4,
        "twist": 1.5, "profile": "ramp"})"},
    GraphCase{"tiles", R"({"node": "tiles", "gives": "v", "a": {"node": "fbm"}})"},
    GraphCase{"bricks", R"({"node": "bricks", "gives": "edge", "depth": 0.8, "offset": 0.3})"},
    GraphCase{"planks", R"({"node": "planks", "gives": "edge"})"},
    GraphCase{"hexagons", R"({"node": "hexagons", "gives": "edge", "width": 0.7})"},
    GraphCase{"herringbone", R"({"node": "herringbone", "gives": "v", "a": {"node": "fbm"}})"},
    GraphCase{"cells", R"({"node": "cells", "jitter": 0.9, "a": {"node": "fbm"}})"},
    GraphCase{"scatter", R"({"node": "scatter", "shape": "leaf", "gives": "edge"})"},
    GraphCase{"field", R"({"node": "field", "quadric": {"A": 1, "F": -0.5, "I": 2, "J": 3},
        "noise": [{"kind": "perlin", "octaves": 3, "range": "unit",
        "matrix": [1, 2, 0, 0.1, 0, 1, -1, 0.2, 0.5, 0, 3, 0.3]},
        {"kind": "worley", "feature": "f2-f1", "octaves": 2},
        {"kind": "value", "fade": "quintic", "shape": "ridged", "frequency": [2, 3, 1]}]})"},
    GraphCase{"fbm", R"({"node": "fbm", "octaves": 5, "lacunarity": 1.9, "gain": 0.6})"},
    GraphCase{"wrinkled", R"({"node": "wrinkled", "octaves": 3, "seed": 5})"},
    GraphCase{"windy", R"({"node": "windy", "octaves": 4})"},
    GraphCase{"bumps", R"({"node": "bumps", "frequency": [3, 2, 1], "a": {"node": "fbm"}})"},
    GraphCase{"dots", R"({"node": "dots", "a": {"node": "fbm"}})"},
    GraphCase{"transform", R"({"node": "transform", "scale": [2, 0.5, 1], "rotate": [30, 40, -50],
        "translate": [1, 2, 3], "matrix": [1, 0.5, 0, 1, 0, 2, 0.3, 0, -0.5, 0, 1, 2],
        "input": {"node": "fbm", "octaves": 2}})"},
    GraphCase{"warp",
              R"({"node": "warp", "strength": 0.4, "octaves": 2, "input": {"node": "fbm"}})"},
    GraphCase{"simplex_nd", R"({"node": "simplex_nd", "dimensions": 8, "signal": "value",
        "octaves": 2, "x4": {"node": "fbm", "octaves": 2}, "x7": {"node": "coordinate"}})"},
    GraphCase{"fibre", R"({"node": "fibre", "direction": [1, 2, -1], "length": 1.5, "width": 0.3,
        "wave": 0.2})"},
    GraphCase{"curl", R"({"node": "curl", "strength": 0.4, "steps": 2, "octaves": 2,
        "input": {"node": "fbm"}})"},
    GraphCase{"map_uv", R"({"node": "map_uv", "scale": [2, 3], "input": {"node": "fbm"}})"},
    GraphCase{"map_spherical", R"({"node": "map_spherical", "input": {"node": "fbm"}})"},
    GraphCase{"map_cylindrical",
              R"({"node": "map_cylindrical", "height": "normalized", "input": {"node": "fbm"}})"},
    GraphCase{"map_planar",
              R"({"node": "map_planar", "vs": [1, 2, 3], "input": {"node": "fbm"}})"}};

INSTANTIATE_TEST_SUITE_P(Nodes, GlGraphSlopeTest, testing::ValuesIn(slope_cases),
                         [](const auto& test) { return std::string(test.param.node); });

/// Nodes of the graph that the slope's input does not read, colours among them.
TEST_F(GlGraphTest, SlopesStandBesideColours) {
    GlSynthesis gl(*context);
    expect_equal(gl, "beside colours", graph_of(R"({"node": "layer_over",
        "base": {"node": "color_map", "stops": [[0, "#102030"], [1, "#f0e0d0"]],
                 "input": {"node": "fbm"}},
        "top": {"node": "marble"},
        "opacity": {"node": "slope", "input": {"node": "fbm", "seed": 5}}})"),
                 SyntheticAtlas{}.make(5));
}

TEST_P(GlGraphNoiseTest, SlopesHaveTheHostsBits) {
    GlSynthesis gl(*context);
    const SolidAtlas solid = SyntheticAtlas{64, 16, 3.0, 0.04}.make(3);
    const auto& [name, kind, text] = GetParam();
    const auto slope = [&](const char* more) {
        return graph_of(fmt::format(
            R"({{"node": "add", "a": {{"node": "coordinate"}}, "b": {{"node": "slope",
                "direction": [0.3, 0.1, -0.2], "input": {{"node": "wrinkled", "kind": "{}",
                "seed": 77, {}}}}}}})",
            name, more));
    };
    expect_equal(gl, name, slope(R"("octaves": 3, "lacunarity": 2.1)"), solid);
    if (!has_dimensions(kind, 4)) return;
    expect_equal(
        gl, name,
        slope(kind == NoiseKind::simplex ? R"("octaves": 2, "time": 0.4)"
                                         : R"("octaves": 2, "time": 0.4, "time_period": 3)"),
        solid);
}

TEST_P(GlGraphNoiseTest, HasTheHostsBits) {
    GlSynthesis gl(*context);
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

TEST_F(GlGraphTest, SimplexNoisesHaveTheHostsBits) {
    GlSynthesis gl(*context);
    const SolidAtlas solid = SyntheticAtlas{64, 16, 3.0, 0.04}.make(3);
    for (int dimensions = 2; dimensions <= 8; ++dimensions) {
        const char* signals[] = {"gradient", "value", "wave"};
        const std::string name = fmt::format("{} dimensions", dimensions);
        expect_equal(gl, name,
                     graph_of(fmt::format(R"({{"node": "simplex_nd", "octaves": 2,
            "dimensions": {}, "signal": "{}", "seed": 9, "x4": {{"node": "coordinate"}}, "x5": -2.3,
            "x8": 0.7}})",
                                          dimensions, signals[dimensions % 3])),
                     solid);
    }
}

TEST_F(GlGraphTest, FieldsHaveTheHostsBits) {
    GlSynthesis gl(*context);
    const SolidAtlas solid = SyntheticAtlas{64, 16, 1e4, 0.04}.make(9);
    expect_equal(gl, "shapes, periods and far away", graph_of(R"({"node": "field", "noise": [
        {"kind": "perlin", "shape": "ridged", "octaves": 10, "frequency": [3, 3, 3]},
        {"kind": "worley", "feature": "f2-f1", "period": [4, 0, 6], "octaves": 2},
        {"kind": "value", "fade": "linear", "seed": 4294967295, "octaves": 2},
        {"kind": "value", "fade": "smooth", "period": [5, 5, 5]}]})"),
                 solid);
}

TEST_F(GlGraphTest, TilesHaveTheHostsBits) {
    GlSynthesis gl(*context);
    const SolidAtlas solid = SyntheticAtlas{64, 16, 3.0, 0.04}.make(9);
    std::string all = R"({"node": "cells", "gives": "id"})";
    const auto add = [&](const std::string& keys) {
        all = fmt::format(R"({{"node": "add", "a": {{"seed": 5, {}}}, "b": {}}})", keys, all);
    };
    for (const char* gives : {R"("gives": "tile")", R"("gives": "edge")", R"("gives": "id")"})
        for (const char* node : {"tiles", "bricks", "planks", "hexagons", "herringbone"})
            add(fmt::format(R"({}, "node": "{}")", gives, node));
    for (const char* gives : {R"("gives": "shape")", R"("gives": "edge")", R"("gives": "id")"})
        for (const char* shape : {"disk", "square", "ring", "star", "leaf"})
            add(fmt::format(R"({}, "node": "scatter", "shape": "{}")", gives, shape));
    expect_equal(gl, "tiles", graph_of(all), solid);
}

TEST_F(GlGraphTest, ImagesHaveTheHostsBitsWhateverLiesBeyond) {
    GlSynthesis gl(*context);
    const SolidAtlas solid = SyntheticAtlas{}.make(5);
    for (const char* wrap : {"repeat", "black", "clamp"})
        expect_equal(gl, wrap,
                     graph_of(fmt::format(R"({{"node": "image", "file": "image.png",
            "wrap": "{}"}})",
                                          wrap)),
                     solid);
}

TEST_F(GlGraphTest, EveryImageIsReadWhereItIsNamed) {
    const auto image = [](const std::string& file, ImageWrap wrap) {
        Image<Rgb8> pixels = case_image(file);
        if (file == "turned.png")
            for (std::size_t y = 0; y < pixels.height(); ++y) std::ranges::reverse(pixels.row(y));
        return std::make_shared<const MipImage>(pixels, wrap);
    };
    const TextureGraph graph = graph_from_json(nlohmann::ordered_json::parse(R"({"node": "mix",
        "a": {"node": "image", "file": "image.png"}, "b": {"node": "image", "file": "turned.png"},
        "amount": {"node": "coordinate", "direction": [1, 1, 0]}})"),
                                               image);
    GlSynthesis gl(*context);
    expect_equal(gl, "two images", graph, SyntheticAtlas{}.make(5));
}

TEST_F(GlGraphTest, CodesAreTheHosts) {
    GlSynthesis gl(*context);
    const SolidAtlas solid = SyntheticAtlas{}.make(6);
    const TextureGraph graph = graph_of(R"({"node": "mix", "a": "#20ff40", "b": {"node": "marble"},
        "amount": {"node": "coordinate", "direction": [1, 1, 0]}})");
    EXPECT_EQ(differing(drawn<Rgb8>(gl, solid, graph, graph_somewhere),
                        on_host<Rgb8>(solid, graph, graph_somewhere)),
              0u);
    EXPECT_EQ(differing(drawn<Rgb16>(gl, solid, graph, graph_somewhere),
                        on_host<Rgb16>(solid, graph, graph_somewhere)),
              0u);
}

TEST_F(GlGraphTest, TilesLeaveNoTrace) {
    const SolidAtlas solid = SyntheticAtlas{}.make(6);
    const TextureGraph graph = graph_of(R"({"node": "wrinkled", "octaves": 2})");
    GlSynthesisLimits limits;
    limits.tile = 24;
    GlSynthesis gl(*context, limits);
    EXPECT_EQ(differing(drawn<Rgb8>(gl, solid, graph, graph_somewhere),
                        on_host<Rgb8>(solid, graph, graph_somewhere)),
              0u);
    EXPECT_EQ(gl.work().passes, 9);
}

std::vector<std::string> graph_presets() {
    std::vector<std::string> names;
    for (const EmbeddedFile& preset : embedded_recipes()) {
        const std::string name(preset.name.substr(0, preset.name.rfind('.')));
        if (!plain_texture(load_recipe(name).texture)) names.push_back(name);
    }
    return names;
}

class GlGraphPresetTest : public GlTest, public testing::WithParamInterface<std::string> {};

TEST_P(GlGraphPresetTest, HasTheHostsBytes) {
    GlSynthesis gl(*context);
    Pipeline pipeline(torus(300));
    const Recipe recipe = load_recipe(GetParam(), {"atlas.size=64", "atlas.kind=area"});
    pipeline.set_recipe(recipe);
    const Affine3 map = texture_from_solid(recipe);
    EXPECT_EQ(differing(drawn<Rgb8>(gl, pipeline.solid(), recipe.texture, map),
                        on_host<Rgb8>(pipeline.solid(), recipe.texture, map)),
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
    const std::shared_ptr<TextureSynthesizer> gl = make_gl_synthesizer(create_test_context());
    EXPECT_EQ(gl->problem(pipeline.recipe()), "");
    pipeline.set_synthesizer(gl);
    EXPECT_EQ(differing(pipeline.synthesize<Rgb8>(), expected), 0u);
    EXPECT_EQ(gl->report()["passes"], 1);
}

TEST_P(GlGraphNodeTest, StaysCloseInFloat32) {
    GlSynthesisLimits limits;
    limits.float64 = false;
    GlSynthesis gl(*context, limits);
    const SolidAtlas solid = SyntheticAtlas{64, 16, 0.0, 0.01}.make(7);
    const TextureGraph graph = graph_of(GetParam().json);
    const Image<RgbF> expected = on_host<RgbF>(solid, graph, {});
    // Where a node jumps, a texel may fall on the other side.
    EXPECT_LE(share_beyond(drawn<RgbF>(gl, solid, graph, {}), expected, 2e-6), 0.002);
}

INSTANTIATE_TEST_SUITE_P(Nodes, GlGraphNodeTest, testing::ValuesIn(graph_cases),
                         [](const auto& test) { return std::string(test.param.node); });

}  // namespace
}  // namespace burl
