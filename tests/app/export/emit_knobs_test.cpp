// Controls as uniforms of emitted shaders: with other values these give what --set gives.
#include "app/export/emit_knobs.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/bench/meshes.h"
#include "app/export/emit.h"
#include "app/export/knob.h"
#include "app/pipeline/pipeline.h"
#include "app/recipe/edit/leaves.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/presets.h"
#include "procedural/color/srgb.h"
#include "procedural/maps/point_map.h"
#include "procedural/model/texture_json.h"
#include "tests/app/export/emitted_shader.h"
#include "tests/app/programs/run_program.h"

namespace burl {
namespace {

using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

/// Values of controls, as --set takes them.
using KnobValues = std::map<std::string, std::string>;

std::vector<std::string> settings_of(const KnobValues& values) {
    std::vector<std::string> settings;
    for (const auto& [name, value] : values) settings.push_back(name + "=" + value);
    return settings;
}

/// A value of a control: at a share of its range, or a colour.
std::string value_at(const ControlState& state, double share, const char* color) {
    if (state.value.is_string()) return color;
    const auto [low, high] = *state.control.range;
    const double value = low > 0.0 ? low * std::pow(high / low, share) : low + share * (high - low);
    return fmt::format("{}", std::clamp(value, low, high));
}

KnobValues values_at(const Recipe& recipe, double share, const char* color) {
    KnobValues values;
    for (const ControlState& state : control_states(slider_json(recipe)))
        values[state.control.name] = value_at(state, share, color);
    return values;
}

/// A recipe in which controls reach numbers in many ways: as they are, by reciprocals, powers and
/// formulas, in sums and products of several, and through tables of colours.
const char* const many_laws =
    R"json({"burl": 1, "name": "laws", "atlas": {"size": 64, "kind": "area"},
    "solid": {"scale": 3, "rotate": [10, 20, 30], "translate": [0.5, -1, 0.2]},
    "define": {
        "grain": {"node": "fbm", "octaves": 3, "gain": 0.5, "seed": 2},
        "share": {"node": "remap", "input": "grain", "in_low": -0.7, "in_high": 0.7}},
    "material": {
        "base_color": {"node": "color_map", "input": "share",
            "stops": [[0, "#203040"], [0.4, "#c0a080"], [1, "#f0f0e0"]]},
        "roughness": {"node": "mix", "a": 0.2, "b": 0.9, "amount": "share"},
        "metallic": {"node": "multiply", "a": 0.25, "b": "share"},
        "emissive": "#804020", "emissive_strength": 2, "clearcoat": 0.308816178, "sheen_roughness": 0.9,
        "height": {"node": "fbm", "seed": 5}},
    "bump": {"height": 0.01},
    "controls": [
        {"name": "size", "range": [1, 9], "sets": ["solid.scale", "bump.height = 0.09 / x / x"]},
        {"name": "gain", "range": [0.2, 0.9], "sets": ["define.grain.gain"]},
        {"name": "contrast", "range": [0.5, 0.9],
         "sets": ["define.share.in_high", "define.share.in_low = -x"]},
        {"name": "middle", "sets": ["material.base_color.stops.1.1"]},
        {"name": "light", "sets": ["material.base_color.stops.2.1"]},
        {"name": "polish", "range": [0.05, 0.9],
         "sets": ["material.roughness.a", "material.sheen_roughness = min(1, x + 0.7)"]
},
        {"name": "sheen of metal", "range": [-1, 1],
         "sets": ["material.metallic.a", "material.clearcoat = pow((x + 1) / 2, 2.5)"]},
        {"name": "glow", "sets": ["material.emissive"]},
        {"name": "glow strength", "range": [0, 10], "sets": ["material.emissive_strength"]}]
})json";

class GlEmitKnobsTest : public EmittedShaderTest {
  protected:
    /// The uniforms with these values.
    static Uniforms uniforms(const KnobValues& values) {
        Uniforms all;
        for (const auto& [control, value] : values) {
            std::string name = "knob_" + control;
            std::ranges::replace(name, ' ', '_');
            if (!value.starts_with('#')) {
                all.push_back({name, {std::stof(value)}});
                continue;
            }
            const Rgb8 c = color_from_hex(value);
            const auto light = [](std::uint8_t code) { return float(srgb_decode(code / 255.0)); };
            all.push_back({name, {light(c.r), light(c.g), light(c.b)}});
        }
        return all;
    }

    std::string shader_of(const Recipe& recipe) {
        EmittedShader shader =
            emit_glsl(recipe, solid_from_mesh(pipeline_.mesh(), recipe.solid.space));
        EXPECT_THAT(shader.notes, IsEmpty());
        return shader.text;
    }

    /// Draws the shader at the texels of a torus, whose points are the recipe's.
    std::vector<float> drawn(const Recipe& recipe, const std::string& shader,
                             const Uniforms& values) {
        pipeline_.set_recipe(recipe);
        const Affine3 map = texture_from_solid(recipe);
        const Vec3d base = solid_base(pipeline_.solid(), map);
        const std::uint32_t side = pipeline_.solid().size;
        return draw(shader, fill_solid_map(pipeline_.solid(), map, base, {0, 0, side, side}, 1),
                    base, values);
    }

    std::vector<float> host_colors(const Recipe& recipe) {
        pipeline_.set_recipe(recipe);
        std::vector<float> colors;
        const Image<RgbF> image = pipeline_.synthesize<RgbF>();
        for (const RgbF& c : image.pixels()) colors.insert(colors.end(), {c.r, c.g, c.b, 1.0f});
        return colors;
    }

    /// The number of texels with a component further away than the bound.
    static int away(const std::vector<float>& a, const std::vector<float>& b, float bound) {
        int count = 0;
        for (std::size_t i = 0; i < a.size(); i += 4) {
            float error = 0.0f;
            for (std::size_t c = 0; c < 4; ++c)
                error = std::max(error, std::abs(a[i + c] - b[i + c]));
            count += error <= bound ? 0 : 1;
        }
        return count;
    }

    /// Expects that the recipe's shader with the uniforms' values has the host's colours of the
    /// recipe with these settings, which are others than its own.
    void expect_colors(const Recipe& recipe, const KnobValues& values, int most_away) {
        const std::vector<float> is = drawn(recipe, shader_of(recipe), uniforms(values));
        const std::vector<float> wanted = host_colors(with_numbers(recipe, settings_of(values)));
        EXPECT_LE(away(is, wanted, 1e-4f), most_away);
        EXPECT_GT(away(host_colors(recipe), wanted, 1e-4f), 1000);
    }

    /// Expects that an expression of the material at a point is what the shader of the recipe with
    /// these settings gives, and that no uniform leaves it as it is.
    void expect_same(const Recipe& recipe, const KnobValues& values, const std::string& shown) {
        const Recipe turned = with_numbers(recipe, settings_of(values));
        const std::string shader = showing(shader_of(recipe), shown);
        const std::vector<float> is = drawn(recipe, shader, uniforms(values));
        const std::vector<float> wanted = drawn(recipe, showing(shader_of(turned), shown), {});
        EXPECT_LE(away(is, wanted, 1e-5f), 5) << shown;
        EXPECT_GT(away(drawn(recipe, shader, {}), wanted, 1e-4f), 1000) << shown;
    }

    Pipeline pipeline_{torus(300)};
};

TEST_F(GlEmitKnobsTest, GiveTheHostsColours) {
    const Recipe recipe = parse_recipe(many_laws, "test");
    expect_colors(recipe, values_at(recipe, 0.9, "#3070b0"), 20);
    expect_colors(recipe, values_at(recipe, 0.0, "#ffffff"), 20);
}

TEST_F(GlEmitKnobsTest, GiveTheOtherChannels) {
    const Recipe recipe = parse_recipe(many_laws, "test");
    const KnobValues values = values_at(recipe, 0.9, "#3070b0");
    expect_same(recipe, values, "vec4(m.roughness, m.metallic, m.clearcoat, m.sheen_roughness)");
    expect_same(recipe, values, "vec4(m.emissive, 1.0)");
    expect_same(recipe, values, "vec4(texture_height(solid) * 100.0)");
    expect_same(recipe, values, "vec4(texture_normal(solid, normalize(solid)), 1.0)");
}

TEST_F(GlEmitKnobsTest, BeginAtTheRecipe) {
    const Recipe recipe = parse_recipe(many_laws, "test", {"contrast=0.6", "middle=#80ff00"});
    const std::vector<float> is = drawn(recipe, shader_of(recipe), {});
    EXPECT_LE(away(is, host_colors(recipe), 1e-4f), 20);
    EXPECT_THAT(shader_of(recipe), HasSubstr("uniform float knob_contrast = 0.6;"));
}

class GlEmitKnobsMaterialTest : public GlEmitKnobsTest,
                                public testing::WithParamInterface<const char*> {};

TEST_P(GlEmitKnobsMaterialTest, GiveTheHostsColours) {
    const Recipe recipe = load_recipe(GetParam(), {"atlas.size=64", "atlas.kind=area"});
    expect_colors(recipe, values_at(recipe, 0.0, "#3070b0"), 20);
    expect_colors(recipe, values_at(recipe, 0.6, "#102030"), 20);
}

INSTANTIATE_TEST_SUITE_P(Materials, GlEmitKnobsMaterialTest,
                         testing::Values("agate", "carrara", "rust", "terrazzo"));

using LongGlEmitKnobsTest = GlEmitKnobsTest;

/// At the ends of ranges float32 itself no longer tells a point: a thousand cells away the last bit
/// of a frequency moves it by more than colours tell. A shader without uniforms rounds a number
/// once, one with uniforms rounds every term and factor of its law: there a shader with uniforms is
/// off by at most four times as much.
TEST_F(LongGlEmitKnobsTest, EveryMaterialTurnsAllItsControls) {
    for (const std::string_view name : material_names()) {
        SCOPED_TRACE(name);
        const Recipe recipe = load_recipe(std::string(name), {"atlas.size=64", "atlas.kind=area"});
        for (const double share : {0.0, 0.5, 1.0}) {
            const KnobValues values = values_at(recipe, share, "#3070b0");
            const Recipe turned = with_numbers(recipe, settings_of(values));
            const std::vector<float> wanted = host_colors(turned);
            const int with_uniforms =
                away(drawn(recipe, shader_of(recipe), uniforms(values)), wanted, 4e-4f);
            const int without = away(drawn(turned, shader_of(turned), {}), wanted, 1e-4f);
            EXPECT_LE(with_uniforms, 3 * without / 2 + 20) << share;
        }
    }
}

TEST(LongGlEmitKnobs, EveryMaterialIsValidGlsl) {
    if (std::system("command -v glslangValidator >/dev/null") != 0)
        GTEST_SKIP() << "glslangValidator (package glslang-tools) is not installed";
    const test::Scratch scratch;
    std::string files;
    for (const std::string_view name : material_names()) {
        const EmittedShader shader = emit_glsl(load_recipe(std::string(name)), {});
        EXPECT_THAT(shader.notes, IsEmpty()) << name;
        files += " '" + scratch.write(fmt::format("{}.frag", name), shader.text) + "'";
    }
    const std::string log = scratch / "log.txt";
    const int status = std::system(("glslangValidator" + files + " >'" + log + "'").c_str());
    EXPECT_EQ(status, 0) << test::slurp(log);
    EXPECT_THAT(test::slurp(log), HasSubstr("walnut.frag"));
}

TEST(GlEmitKnobs, AreValidGlsl) {
    if (std::system("command -v glslangValidator >/dev/null") != 0)
        GTEST_SKIP() << "glslangValidator (package glslang-tools) is not installed";
    const test::Scratch scratch;
    const std::string file =
        scratch.write("laws.frag", emit_glsl(parse_recipe(many_laws, "test"), {}).text);
    const std::string log = scratch / "log.txt";
    const int status = std::system(("glslangValidator '" + file + "' >'" + log + "'").c_str());
    EXPECT_EQ(status, 0) << test::slurp(log);
}

/// A recipe of one noise with controls, given as JSON.
Recipe controlled(const std::string& controls, const std::vector<std::string>& settings = {}) {
    return parse_recipe(fmt::format(R"({{"texture": {{"node": "color_map", "stops": [[0, "#000000"],
                            [1, "#ffffff"]], "input": {{"noise": [{{"kind": "perlin",
                            "octaves": 3, "frequency": [2, 2, 2]}}]}}}}, "controls": [{}]}})",
                                    controls),
                        "test", settings);
}

TEST(GlEmitKnobs, UniformsSayWhatTheyAre) {
    const Recipe recipe = controlled(
        R"json({"name": "Spots (per m)", "about": "how many\nlie there", "range": [0.5, 8],
                "sets": ["texture.input.noise.0.frequency.0"]},
               {"name": "spots per-m", "sets": ["texture.stops.1.1"]},
               {"name": "\u00e9", "sets": ["texture.stops.0.1"]})json");
    const std::string text = emit_glsl(recipe, {}).text;
    EXPECT_THAT(text, HasSubstr("// Spots (per m), from 0.5 to 8: how many?lie there\n"
                                "uniform float knob_spots_per_m = 2.0;\n"));
    EXPECT_THAT(text, HasSubstr("#ffffff in sRGB\n"
                                "uniform vec3 knob_spots_per_m_2 = vec3(1.0, 1.0, 1.0);\n"));
    EXPECT_THAT(text, HasSubstr("uniform vec3 knob = vec3(0.0, 0.0, 0.0);\n"));
}

TEST(GlEmitKnobs, WhatNeedsAnotherShaderStaysAndIsNamed) {
    const Recipe recipe = controlled(
        R"({"name": "detail", "range": [1, 9], "sets": ["texture.input.noise.0.octaves"]},
                      {"name": "spots", "range": [0.5, 8], "sets": ["texture.input.noise.0.frequency.0"]})");
    const EmittedShader shader = emit_glsl(recipe, {});
    EXPECT_THAT(shader.notes,
                testing::ElementsAre("the shader's \"detail\" stays 3, since other values need "
                                     "another shader: emit it again with --set \"detail=VALUE\""));
    EXPECT_THAT(shader.text, HasSubstr("uniform float knob_spots = 2.0;"));
    EXPECT_THAT(shader.text, HasSubstr("// Constant: detail, 3\n"));
    EXPECT_THAT(shader.text, Not(HasSubstr("knob_detail")));
}

TEST(GlEmitKnobs, WhatFollowsNoLawStaysAndIsNamed) {
    // The shader has the difference of the two alone.
    const Recipe recipe = parse_recipe(
        R"json({"texture": {"node": "mix", "a": 0.2, "b": 0.8, "amount": {"node": "fbm"}},
            "controls": [{"name": "low", "range": [0, 1],
                          "sets": ["texture.a", "texture.b = min(1, x + 0.6)"]}]})json",
        "test");
    EXPECT_THAT(emit_glsl(recipe, {}).notes,
                testing::ElementsAre(HasSubstr("\"low\" stays 0.2, since other values")));
}

TEST(GlEmitKnobs, WhatWasSetApartStaysAndIsNamed) {
    const Recipe recipe = controlled(
        R"({"name": "spots", "range": [1, 8], "sets": ["texture.input.noise.0.frequency.0",
                                                       "texture.input.noise.0.amplitude = 1 / x"]})",
        {"texture.input.noise.0.amplitude=0.7"});
    EXPECT_THAT(emit_glsl(recipe, {}).notes,
                testing::ElementsAre(
                    "the shader's \"spots\" stays 2, since texture.input.noise.0.amplitude "
                    "has been set apart from it"));
}

TEST(GlEmitKnobs, WhatTheShaderDoesNotShowIsNamed) {
    const Recipe recipe =
        controlled(R"({"name": "cut", "range": [0, 1], "sets": ["material.alpha_cutoff"]})");
    EXPECT_THAT(emit_glsl(recipe, {}).notes,
                testing::ElementsAre("the shader's \"cut\" stays 0.5, since nothing in it depends "
                                     "on that"));
}

TEST(GlEmitKnobs, BakesTellWhatStays) {
    const test::Scratch scratch;
    const std::string recipe = scratch.write("r.json", R"({"texture": {"node": "fbm", "octaves": 3},
            "controls": [{"name": "detail", "range": [1, 9], "sets": ["texture.octaves"]}]})");
    const test::Outcome outcome = test::run_burl(
        scratch, "bake sample:cube -s 64 --recipe '" + recipe + "' -o '" + scratch / "t.png" +
                     "' --emit-glsl '" + scratch / "t.frag" + "'");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.err, HasSubstr("the shader's \"detail\" stays 3, since"));
}

}  // namespace
}  // namespace burl
