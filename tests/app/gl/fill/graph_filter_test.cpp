// Graphs whose nodes filter, through OpenGL against the host's graph evaluator.
#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/base/embedded.h"
#include "app/bench/meshes.h"
#include "app/gl/fill/synthesize.h"
#include "app/pipeline/pipeline.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/json.h"
#include "procedural/fill/graph.h"
#include "tests/app/gl/device/fixture.h"
#include "tests/paths.h"
#include "tests/procedural/graph/cases.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

using testing::HasSubstr;

const Affine3 somewhere{Mat3d(1.7), Vec3d(0.3, -0.2, 0.1)};
constexpr Filter trapezoid{FilterKind::trapezoid, 16, false};

/// Largest difference of a channel; infinite where something is no number.
double distance(const Image<RgbF>& a, const Image<RgbF>& b) {
    double most = 0.0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const RgbF &p = a.pixels()[i], &q = b.pixels()[i];
        for (const double away :
             {double(p.r) - double(q.r), double(p.g) - double(q.g), double(p.b) - double(q.b)})
            most = std::max(most, std::isfinite(away) ? std::abs(away) : INFINITY);
    }
    return most;
}

class GlGraphFilterTest : public GlTest {
  protected:
    Image<RgbF> drawn(const SolidAtlas& solid, const TextureGraph& graph, const Filter& filter) {
        if (!gl_) gl_.emplace(*context);
        Image<RgbF> image;
        gl_->forget_atlas();
        gl_->synthesize(solid, graph, somewhere, 1, image, filter);
        return image;
    }
    static Image<RgbF> on_host(const SolidAtlas& solid, const TextureGraph& graph,
                               const Filter& filter) {
        return synthesize_graph<RgbF>(solid, graph, somewhere, filter, 1);
    }
    /// Small footprints and wide ones, which octaves fade in, in blocks with borders between pixels
    /// that are drawn together. `error` 0: bit for bit.
    void expect_hosts(const TextureGraph& graph, const Filter& filter, double error) {
        for (const double step : {0.02, 0.3}) {
            const SolidAtlas solid = SyntheticAtlas{64, 13, 0.4, step}.make(7);
            const Image<RgbF> expected = on_host(solid, graph, filter);
            EXPECT_LE(distance(drawn(solid, graph, filter), expected), error) << step;
        }
    }
    /// Filtered pictures repeat, and are the host's.
    void expect_hosts(const Recipe& recipe) {
        Pipeline pipeline(torus(300));
        pipeline.set_recipe(recipe);
        const Affine3 map = texture_from_solid(recipe);
        const SolidAtlas& solid = pipeline.solid();
        GlSynthesis gl(*context);
        Image<RgbF> first, second;
        gl.synthesize(solid, recipe.texture, map, 1, first, trapezoid);
        gl.synthesize(solid, recipe.texture, map, 1, second, trapezoid);
        EXPECT_EQ(differing(first, second), 0u);
        EXPECT_EQ(
            differing(first, synthesize_graph<RgbF>(solid, recipe.texture, map, trapezoid, 1)), 0u);
    }

    std::optional<GlSynthesis> gl_;
};

class GlGraphFilterNodeTest : public GlGraphFilterTest,
                              public testing::WithParamInterface<GraphCase> {};

TEST_P(GlGraphFilterNodeTest, HasTheHostsMeans) {
    expect_hosts(graph_of(GetParam().json), trapezoid, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Nodes, GlGraphFilterNodeTest, testing::ValuesIn(graph_cases),
                         [](const auto& test) { return std::string(test.param.node); });

TEST_P(GlGraphFilterNodeTest, StaysCloseInFloat32) {
    GlSynthesisLimits limits;
    limits.float64 = false;
    GlSynthesis gl(*context, limits);
    const SolidAtlas solid = SyntheticAtlas{64, 16, 0.0, 0.02}.make(7);
    const TextureGraph graph = graph_of(GetParam().json);
    Image<RgbF> image;
    gl.synthesize(solid, graph, somewhere, 1, image, trapezoid);
    // Means of jumps lose most: float coordinates over narrow boxes.
    EXPECT_LE(distance(image, on_host(solid, graph, trapezoid)), 1e-4);
}

TEST_F(GlGraphFilterTest, BoardsHaveTheHostsMeans) {
    for (const char* board : {"checkerboard", "checkerboard_3d"})
        for (const char* aa : {"none", "supersample", "trapezoid"})
            expect_hosts(
                graph_of(fmt::format(
                    R"({{"node": "{}", "aa": "{}", "a": {{"node": "coordinate"}}}})", board, aa)),
                trapezoid, std::string_view(aa) == "supersample" ? 2e-6 : 0.0);
}

TEST_F(GlGraphFilterTest, ColourMapsHaveTheHostsMeans) {
    for (const char* wrap : {"repeat", "clamp"})
        for (const FilterKind kind : {FilterKind::exact, FilterKind::trapezoid2})
            expect_hosts(graph_of(fmt::format(R"({{"node": "color_map", "wrap": "{}",
                "stops": [[0, "#102030"], [0.3, "#f0e0d0"], [0.3, "#2040c0"], [1, "#10c030"]],
                "input": {{"node": "multiply", "a": 3, "b": {{"node": "coordinate",
                "direction": [1, 0.1, 0.001]}}}}}})",
                                              wrap)),
                         Filter{kind}, 0.0);
}

TEST_F(GlGraphFilterTest, ImagesHaveTheHostsMeans) {
    for (const char* wrap : {"repeat", "black", "clamp"})
        for (const char* lookup : {"trilinear", "ewa"})
            expect_hosts(graph_of(fmt::format(R"({{"node": "map_uv", "scale": [0.3, 0.02],
                "input": {{"node": "image", "file": "image.png", "wrap": "{}", "lookup": "{}",
                "anisotropy": 3}}}})",
                                              wrap, lookup)),
                         trapezoid, 0.0);
}

/// A hole in an image shows what lies below, by the image's alpha.
TEST_F(GlGraphFilterTest, ImagesMayBeTransparent) {
    const auto image = [](const std::string& file, ImageWrap wrap) {
        Image<Rgba8> pixels(12, 16);
        const Image<Rgb8> opaque = case_image(file);
        for (std::size_t y = 0; y < 16; ++y)
            for (std::size_t x = 0; x < 12; ++x) {
                const Rgb8& c = opaque(x, y);
                pixels(x, y) = {c.r, c.g, c.b, std::uint8_t(20 * x)};
            }
        return std::make_shared<const MipImage>(pixels, wrap);
    };
    const auto json = nlohmann::ordered_json::parse(R"({"node": "layer_over", "base": "#ffffff",
        "top": {"node": "image", "file": "image.png", "lookup": "ewa"}})");
    expect_hosts(graph_from_json(json, image), trapezoid, 0.0);
    expect_hosts(graph_from_json(json, image), Filter{}, 0.0);
}

TEST_F(GlGraphFilterTest, ImagesMayBeLong) {
    const auto image = [](const std::string&, ImageWrap wrap) {
        return std::make_shared<const MipImage>(random_image(40, 5), wrap);
    };
    const auto json =
        nlohmann::ordered_json::parse(R"({"node": "image", "file": "image.png", "lookup": "ewa"})");
    expect_hosts(graph_from_json(json, image), trapezoid, 0.0);
}

/// Its quads differ in size, so neighbouring texels read different levels.
TEST_F(GlGraphFilterTest, ImagesOnQuadsHaveTheHostsMeans) {
    for (const char* lookup : {"trilinear", "ewa"})
        expect_hosts(load_recipe(
            test::case_file("rg.json"),
            {"atlas.size=128", "atlas.kind=quad", fmt::format("texture.lookup={}", lookup)}));
}

TEST_F(GlGraphFilterTest, OctavesOfFieldsFade) {
    const TextureGraph graph = graph_of(R"({"node": "field", "quadric": {"A": 0.1}, "noise": [
        {"kind": "perlin", "shape": "ridged", "octaves": 4, "range": "unit"},
        {"kind": "worley", "octaves": 3, "frequency": [2, 1, 1]}]})");
    const Filter faded{FilterKind::trapezoid, 16, true};
    expect_hosts(graph, faded, 2e-6);
    const SolidAtlas solid = SyntheticAtlas{64, 16, 0.4, 0.1}.make(7);
    EXPECT_GT(distance(on_host(solid, graph, faded), on_host(solid, graph, trapezoid)), 0.01);
}

TEST_F(GlGraphFilterTest, WhatIsTheHostsAloneIsRefused) {
    GlSynthesis gl(*context);
    const TextureGraph map = graph_of(R"({"node": "color_map", "stops": [[0, "#000000"],
                           [1, "#ffffff"]], "input": {"node": "fbm"}})");
    EXPECT_THAT(gl.problem(map, {FilterKind::table_sat}), HasSubstr("colour tables"));
    EXPECT_EQ(gl.problem(map, trapezoid), "");
    EXPECT_EQ(gl.problem(graph_of(R"({"node": "fbm"})"), {FilterKind::table_sat}), "");
    Image<RgbF> pixels;
    EXPECT_THROW(
        gl.synthesize(SyntheticAtlas{}.make(1), map, somewhere, 1, pixels, {FilterKind::table_mip}),
        Error);
}

class GlGraphFilterPresetTest : public GlGraphFilterTest,
                                public testing::WithParamInterface<std::string> {};

/// On an atlas with gaps.
TEST_P(GlGraphFilterPresetTest, HasTheHostsMeans) {
    expect_hosts(load_recipe(GetParam(), {"atlas.size=64", "atlas.kind=area"}));
}

std::vector<std::string> filtered_presets() {
    std::vector<std::string> names;
    for (const EmbeddedFile& preset : embedded_recipes()) {
        const std::string name(preset.name.substr(0, preset.name.rfind('.')));
        if (!plain_texture(load_recipe(name).texture)) names.push_back(name);
    }
    return names;
}

INSTANTIATE_TEST_SUITE_P(Presets, GlGraphFilterPresetTest, testing::ValuesIn(filtered_presets()),
                         [](const auto& test) {
                             std::string name = test.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace burl
