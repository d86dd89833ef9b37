// Shaders written for use elsewhere: every preset's compiles by itself and gives the host's
// colours.
#include "app/export/emit.h"
#include "app/recipe/edit/recipe_json.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/base/embedded.h"
#include "app/bench/meshes.h"
#include "app/pipeline/pipeline.h"
#include "procedural/maps/point_map.h"
#include "tests/app/export/emitted_shader.h"
#include "tests/app/programs/run_program.h"
#include "tests/procedural/graph/cases.h"

namespace burl {
namespace {

using test::Outcome;
using test::run_burl;
using test::Scratch;
using testing::HasSubstr;
using testing::Not;

class GlEmitTest : public EmittedShaderTest {
  protected:
    /// Texels of a torus whose colours are further than 1e-4 from the host's.
    int texels_away(const Recipe& recipe) {
        Pipeline pipeline(torus(300));
        pipeline.set_recipe(recipe);
        const Image<RgbF> expected = pipeline.synthesize<RgbF>();
        const Affine3 map = texture_from_solid(recipe);
        const Vec3d base = solid_base(pipeline.solid(), map);
        const auto side = std::uint32_t(expected.width());
        const std::vector<float> colors =
            draw(emit_glsl(recipe, solid_from_mesh(pipeline.mesh(), recipe.solid.space)).text,
                 fill_solid_map(pipeline.solid(), map, base, {0, 0, side, side}, 1), base);
        int away = 0;
        for (std::size_t i = 0; i < expected.pixels().size(); ++i) {
            const RgbF& c = expected.pixels()[i];
            const double error = std::max({std::abs(double(c.r) - double(colors[4 * i])),
                                           std::abs(double(c.g) - double(colors[4 * i + 1])),
                                           std::abs(double(c.b) - double(colors[4 * i + 2]))});
            away += error <= 1e-4 ? 0 : 1;
        }
        return away;
    }
};

std::vector<std::string> presets() {
    std::vector<std::string> names;
    for (const EmbeddedFile& preset : embedded_recipes())
        names.emplace_back(preset.name.substr(0, preset.name.rfind('.')));
    return names;
}

class GlEmitPresetTest : public GlEmitTest, public testing::WithParamInterface<std::string> {};

TEST_P(GlEmitPresetTest, GivesTheHostsColours) {
    // A shader is of points: a preset's filter is left out.
    const Recipe recipe =
        load_recipe(GetParam(), {"atlas.size=64", "atlas.kind=area", "filter.kind=none"});
    // Where rounding takes a texel over a jump.
    EXPECT_LE(texels_away(recipe), GetParam() == "checker-floor" ? 200 : 20);
}

TEST(GlEmit, TellsOfTheFilterThatItLeavesOut) {
    EXPECT_THAT(
        emit_glsl(load_recipe("stripes"), {}).notes,
        testing::Contains("filter trapezoid is left out: the shader gives the colour at a point"));
    for (const std::string& note :
         emit_glsl(load_recipe("stripes", {"filter.kind=none"}), {}).notes)
        EXPECT_THAT(note, testing::Not(HasSubstr("filter")));
}

TEST(GlEmit, TellsOfThePaintThatItLeavesOut) {
    Recipe recipe = load_recipe("marble");
    recipe.paint.resize(1);
    EXPECT_THAT(emit_glsl(recipe, {}).notes, testing::Contains(HasSubstr("paint is left out")));
}

TEST_F(GlEmitTest, ColourMapsOfManyStopsBecomeConstants) {
    Recipe recipe = load_recipe("marble", {"atlas.size=64", "atlas.kind=area"});
    std::vector<ColorStop>& stops = plain_texture(recipe.texture)->colors.stops;
    stops.clear();
    for (int i = 0; i < 300; ++i)
        stops.push_back({i / 300.0, {std::uint8_t(i % 2), std::uint8_t(i / 2), 100}});
    EXPECT_THAT(emit_glsl(recipe, {}).text, HasSubstr("const vec4 color_map"));
    EXPECT_LE(texels_away(recipe), 20);
}

INSTANTIATE_TEST_SUITE_P(Presets, GlEmitPresetTest, testing::ValuesIn(presets()),
                         [](const auto& test) {
                             std::string name = test.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

Recipe recipe_of(const char* texture) {
    return parse_recipe(fmt::format(R"({{"burl": 1, "name": "test", "texture": {}}})", texture),
                        "test");
}

TEST(GlEmit, SaysWhatItIsAndHoldsNothingElse) {
    const Affine3 map{Mat3d(0.25), Vec3d(1, 2, 3)};
    const std::string text =
        emit_glsl(recipe_of(R"({"node": "checkerboard_3d", "a": "#ff0000", "b": "#ffffff"})"), map)
            .text;
    EXPECT_TRUE(text.starts_with("#version 330 core\n"));
    for (const char* part : {"texture test", "vec3 texture_color(vec3 solid)", "void main()",
                             "uniform sampler2D solid_map", "vec3(1.0, 2.0, 3.0)"})
        EXPECT_THAT(text, HasSubstr(part));
    for (const char* part : {"real", "double", "exact", "sine", "mix_bits", "#if"})
        EXPECT_THAT(text, Not(HasSubstr(part)));
}

TEST(GlEmit, SaysWhichImageIsAnAlpha) {
    Recipe recipe;
    recipe.texture = graph_from_json(
        nlohmann::ordered_json::parse(R"({"node": "layer_over", "base": "#ffffff",
            "top": {"node": "image", "file": "leaf.png"}})"),
        [](const std::string&, ImageWrap wrap) {
            return std::make_shared<const MipImage>(Image<Rgba8>(4, 4, {9, 9, 9, 99}), wrap);
        });
    const std::string text = emit_glsl(recipe, {}).text;
    EXPECT_THAT(text, HasSubstr("image leaf.png, decoded to linear light (an sRGB texture) and "
                                "multiplied by its alpha"));
    EXPECT_THAT(text, HasSubstr("is the alpha of the image leaf.png"));
}

/// OpenGL drivers forgive what the language does not have, so the reference compiler reads them.
TEST(GlEmit, PresetsAndNodesAreValidGlsl) {
    if (std::system("command -v glslangValidator >/dev/null") != 0)
        GTEST_SKIP() << "glslangValidator (package glslang-tools) is not installed";
    const Scratch scratch;
    std::string files;
    const auto add = [&](std::string_view name, const Recipe& recipe) {
        files +=
            " '" + scratch.write(fmt::format("{}.frag", name), emit_glsl(recipe, {}).text) + "'";
    };
    for (const std::string& name : presets()) add("preset-" + name, load_recipe(name));
    for (const GraphCase& one : graph_cases) {
        Recipe recipe;
        recipe.texture = graph_of(one.json);
        add(fmt::format("node-{}", one.node), recipe);
    }
    const std::string log = scratch / "log.txt";
    const int status = std::system(("glslangValidator" + files + " >'" + log + "'").c_str());
    EXPECT_EQ(status, 0) << test::slurp(log);
    // It names each file that it has read.
    EXPECT_THAT(test::slurp(log), HasSubstr("preset-zoneplate.frag"));
}

TEST(GlEmit, BakesWriteIt) {
    const Scratch scratch;
    const std::string bake = "bake sample:cube --quiet -s 64 -o '" + scratch / "t.png" + "' ";
    const std::string report = scratch / "t.json";
    const Outcome outcome =
        run_burl(scratch, bake + "--recipe windy --emit-glsl '" + scratch / "t.frag" +
                              "' --report '" + report + "'");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string text = test::slurp(scratch / "t.frag");
    EXPECT_TRUE(text.starts_with("#version 330 core\n// Solid texture windy,"));
    EXPECT_THAT(text, HasSubstr("// windy (node "));
    EXPECT_THAT(test::slurp(report), HasSubstr("t.frag"));
}

TEST(GlEmit, BakesThatCannotWriteItWriteNothing) {
    const Scratch scratch;
    const std::string bake = "bake sample:cube --quiet -s 64 -o '" + scratch / "t.png" + "' ";
    const Outcome same = run_burl(scratch, bake + "--emit-glsl '" + scratch / "t.png" + "'");
    EXPECT_EQ(same.exit_code, int(ExitCode::io));
    const std::string scene = "bake sample:cube --quiet -s 64 --levels 2 -o '" + scratch / "t.obj" +
                              "' --solid-map '" + scratch / "s.exr" + "' ";
    for (const char* taken : {"t.mtl", "t.png", "t.1.png", "s.exr"})
        EXPECT_EQ(run_burl(scratch, scene + "--emit-glsl '" + scratch / taken + "'").exit_code,
                  int(ExitCode::io))
            << taken;
    EXPECT_EQ(scratch.files(), 0u);
}

TEST(GlEmit, NamesStayInTheirComment) {
    Recipe recipe = load_recipe("marble");
    recipe.name = "a\n#error x\\";
    EXPECT_THAT(emit_glsl(recipe, {}).text, HasSubstr("// Solid texture a?#error x?, written"));
}

TEST(GlEmit, SlopesBecomeFunctionsWithGradients) {
    const std::string text =
        emit_glsl(recipe_of(R"({"node": "slope", "input": {"node": "fbm"}})"), {}).text;
    for (const char* part : {"vec4 gradient0(vec3 solid)", "perlin_sample", "dual_at"})
        EXPECT_THAT(text, HasSubstr(part));
    for (const char* part : {"real", "exact", "dual_sin", "simplex"})
        EXPECT_THAT(text, Not(HasSubstr(part)));
}

}  // namespace
}  // namespace burl
