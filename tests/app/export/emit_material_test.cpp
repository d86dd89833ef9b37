// Whole materials in emitted shaders: every channel, the height and the bumped normal against the
// host's evaluator, in files that the reference compiler takes.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <functional>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/bench/meshes.h"
#include "app/export/emit.h"
#include "app/pipeline/pipeline.h"
#include "app/pipeline/texture_color.h"
#include "app/recipe/channel_texture.h"
#include "app/recipe/edit/recipe_json.h"
#include "procedural/maps/point_map.h"
#include "tests/app/export/emitted_shader.h"
#include "tests/app/programs/run_program.h"
#include "tests/procedural/graph/cases.h"

namespace burl {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A material of which most channels vary; `more` are further keys of it.
Recipe material(const std::string& more) {
    return parse_recipe(
        R"({"burl": 1, "name": "test", "atlas": {"size": 64, "kind": "area"},
        "solid": {"scale": 3, "rotate": [10, 20, 30], "translate": [0.5, -1, 0.2]},
        "define": {"grain": {"node": "smoothstep", "low": -1, "high": 1,
            "input": {"node": "fbm", "octaves": 2}}},
        "material": {)" +
            more +
            R"("roughness": {"node": "remap", "input": "grain", "out_low": 0.2, "out_high": 1.5},
            "metallic": {"node": "subtract", "a": 1, "b": "grain"}, "occlusion": 0.75,
            "emissive": {"node": "scale", "a": "#ff8020", "b": "grain"}, "emissive_strength": 3,
            "specular": {"node": "cells", "gives": "id"},
            "clearcoat": "grain", "clearcoat_roughness": 0.25, "sheen": "#204060",
            "sheen_roughness": {"node": "power", "exponent": 2, "input": "grain"},
            "transmission": {"node": "fbm", "seed": 3}, "ior": 1.4,
            "height": {"node": "add", "a": "grain", "b": {"node": "fbm", "seed": 5}}},
        "bump": {"height": 0.02}})",
        "test");
}

const std::string clear_colors =
    R"("base_color": {"node": "mix", "a": "#c9a06a80", "b": "#6e4722", "amount": "grain"},
       "opacity": {"node": "remap", "input": "grain", "in_low": 0.2, "in_high": 0.8},)";
const std::string opaque_colors =
    R"("base_color": {"node": "mix", "a": "#c9a06a", "b": "#6e4722", "amount": "grain"},)";

class GlEmitMaterialTest : public EmittedShaderTest {
  protected:
    using Host = std::function<Vec4d(const Vec3d& solid)>;

    /// Compares what the recipe's shader shows with the host's numbers at the points of a torus:
    /// all but a few, which lie at a jump, are within the bound, and all numbers that should vary
    /// do.
    void expect(const Recipe& recipe, const std::string& color, const Host& host, double bound,
                int varying) {
        pipeline_.set_recipe(recipe);
        const Affine3 map = texture_from_solid(recipe);
        const Vec3d base = solid_base(pipeline_.solid(), map);
        const std::uint32_t side = pipeline_.solid().size;
        const SolidMap points = fill_solid_map(pipeline_.solid(), map, base, {0, 0, side, side}, 1);
        const std::string shader =
            emit_glsl(recipe, solid_from_mesh(pipeline_.mesh(), recipe.solid.space)).text;
        const std::vector<float> shown = draw(showing(shader, color), points, base);
        int away = 0;
        Vec4d least(1e9), most(-1e9);
        for (std::size_t i = 0; i < points.owners.pixels().size(); ++i) {
            const Vec4f& local = points.local.pixels()[i];
            if (local.w == 0.0f) continue;
            const Vec4d expected = host(base + Vec3d(local));
            const Vec4d is(shown[4 * i], shown[4 * i + 1], shown[4 * i + 2], shown[4 * i + 3]);
            const Vec4d error = glm::abs(is - expected);
            away += std::max({error.x, error.y, error.z, error.w}) <= bound ? 0 : 1;
            least = glm::min(least, expected), most = glm::max(most, expected);
        }
        EXPECT_LE(away, 10) << color;
        for (int c = 0; c < varying; ++c)
            EXPECT_GT(most[c] - least[c], 100.0 * bound) << color << c;
    }

    /// Compares four channels that are numbers, of which the first `varying` vary.
    void expect_numbers(const Recipe& recipe, const std::array<const char*, 4>& names,
                        int varying) {
        std::deque<GraphEvaluator> graphs;
        for (const char* name : names) graphs.emplace_back(channel_texture(recipe, name));
        const auto host = [&](const Vec3d& solid) {
            Vec4d numbers;
            for (int c = 0; c < 4; ++c)
                numbers[c] = graphs[std::size_t(c)](solid).channels[0].value;
            return glm::clamp(numbers, 0.0, 1.0);
        };
        expect(recipe, fmt::format("vec4(m.{})", fmt::join(names, ", m.")), host, 1e-4, varying);
    }

    /// Compares a colour, `strength` times the channel's.
    void expect_color(const Recipe& recipe, const char* name, double strength, int varying) {
        const GraphEvaluator graph(channel_texture(recipe, name));
        const auto host = [&](const Vec3d& solid) {
            return Vec4d(strength * graph(solid).color(), 1.0);
        };
        expect(recipe, fmt::format("vec4(m.{}.rgb, 1.0)", name), host, 1e-4, varying);
    }

    /// Compares the base colour with the channels' light, divided by its alpha, and `alpha` of
    /// alpha and opacity.
    void expect_base_color(const Recipe& recipe, const std::function<double(double)>& alpha) {
        const GraphEvaluator color(channel_texture(recipe, "base_color")),
            cover(channel_texture(recipe, "alpha"));
        const auto host = [&](const Vec3d& solid) {
            const GraphSample sample = color(solid);
            return Vec4d(sample.color() / sample.channels[3].value,
                         alpha(cover(solid).channels[0].value));
        };
        expect(recipe, "m.base_color", host, 1e-4, 4);
    }

    /// Compares the height with the bumps' own graph, and normals with the host's.
    void expect_bumps(const Recipe& recipe) {
        const Mesh& mesh = pipeline_.mesh();
        const GraphEvaluator graph(recipe.bump.input);
        const double rise = recipe.bump.height / solid_units(mesh, recipe.solid.space);
        const auto height = [&](const Vec3d& solid) {
            return Vec4d(rise * graph(solid).channels[0].value, 0.0, 0.0, 0.0);
        };
        expect(recipe, "vec4(texture_height(solid), 0.0, 0.0, 0.0)", height, 1e-6, 1);
        const SurfaceNormal bumped = bumped_normals(recipe, mesh);
        const Affine3 map = texture_from_mesh(recipe, mesh);
        const Mat3d back = glm::inverse(map.linear);
        const auto tilt = [&](const Vec3d& solid) {
            const Vec3d n = glm::normalize(solid);
            return Vec4d(bumped(back * (solid - map.offset), n) - n, 0.0);
        };
        expect(recipe, "vec4(texture_normal(solid, normalize(solid)) - normalize(solid), 0.0)",
               tilt, 1e-4, 3);
    }

    Pipeline pipeline_{torus(300)};
};

TEST_F(GlEmitMaterialTest, GivesTheHostsNumbers) {
    const Recipe recipe = material(clear_colors);
    expect_numbers(recipe, {"metallic", "roughness", "specular", "occlusion"}, 3);
    expect_numbers(recipe, {"clearcoat", "sheen_roughness", "transmission", "clearcoat_roughness"},
                   3);
}

TEST_F(GlEmitMaterialTest, GivesTheHostsColours) {
    const Recipe recipe = material(opaque_colors);
    expect_color(recipe, "base_color", 1.0, 3);
    expect_color(recipe, "emissive", 3.0, 2);
    expect_color(recipe, "sheen", 1.0, 0);
    expect(
        recipe, "vec4(m.ior, m.base_color.a, 0.0, 0.0)",
        [](const Vec3d&) { return Vec4d(1.4, 1.0, 0.0, 0.0); }, 1e-6, 0);
}

TEST_F(GlEmitMaterialTest, BaseColoursAreNotMultipliedByAlpha) {
    const auto is_alpha = [](double alpha) { return std::clamp(alpha, 0.0, 1.0); };
    expect_base_color(material(clear_colors), is_alpha);
    const auto is_there = [](double alpha) { return alpha >= 0.4 ? 1.0 : 0.0; };
    expect_base_color(material(clear_colors + R"("alpha": "mask", "alpha_cutoff": 0.4,)"),
                      is_there);
}

TEST_F(GlEmitMaterialTest, OpaqueOnesShowBlackInHoles) {
    const Recipe recipe = material(clear_colors + R"("alpha": "opaque",)");
    expect_color(recipe, "base_color", 1.0, 3);
    const GraphEvaluator graph(recipe.texture);
    const auto color = [&](const Vec3d& solid) { return Vec4d(graph(solid).color(), 1.0); };
    expect(recipe, "vec4(texture_color(solid), m.base_color.a)", color, 1e-4, 3);
}

TEST_F(GlEmitMaterialTest, HeightsAndNormalsAreTheBumps) {
    expect_bumps(material(opaque_colors));
}

TEST_F(GlEmitMaterialTest, HeightsAndNormalsOfPresetsAreTheBumps) {
    for (const char* preset : {"carved-wood", "hammered", "orange-peel"}) {
        SCOPED_TRACE(preset);
        expect_bumps(load_recipe(preset, {"atlas.size=64", "atlas.kind=area"}));
    }
}

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

TEST(GlEmitMaterial, NodesOfSeveralChannelsAreWrittenOnce) {
    Recipe recipe = material(clear_colors);
    recipe.bump = {};
    const std::string text = emit_glsl(recipe, {}).text;
    EXPECT_EQ(count_of(text, "// fbm (node"), 2u) << text;  // grain and transmission
    EXPECT_EQ(count_of(text, "texture_planes(solid);"), 1u);
}

TEST(GlEmitMaterial, ConstantChannelsAreNumbers) {
    const std::string text =
        emit_glsl(parse_recipe(
                      R"({"material": {"base_color": {"node": "checkerboard_3d"}, "opacity": 0.25,
                         "metallic": 1}})",
                      "test"),
                  {})
            .text;
    for (const char* part :
         {"vec4(texture_color(solid), 0.25)", "material.metallic = 1.0;",
          "material.roughness = 0.6;", "material.emissive = vec3(0.0, 0.0, 0.0);",
          "material.ior = 1.5;", "float texture_height(vec3 solid) {\n    return 0.0;",
          "vec3 texture_normal(vec3 solid, vec3 normal) {\n    return normal;"})
        EXPECT_THAT(text, HasSubstr(part));
    EXPECT_THAT(text, Not(HasSubstr("texture_planes")));
}

TEST(GlEmitMaterial, BumpsOfTooManyStopsAreRefused) {
    std::string stops;
    for (int i = 0; i < 300; ++i)
        stops += fmt::format(R"({}[{}, "#{:02x}0000"])", i == 0 ? "" : ", ", i / 300.0, i % 256);
    const Recipe recipe =
        parse_recipe(fmt::format(R"({{"bump": {{"input": {{"node": "split", "input":
                         {{"node": "color_map", "input": {{"node": "fbm"}}, "stops": [{}]}}}}}}}})",
                                 stops),
                     "test");
    try {
        emit_glsl(recipe, {}).text;
        FAIL() << "nothing was refused";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::unsupported);
        EXPECT_STREQ(error.what(),
                     "the height of the bumps cannot be written as GLSL: a colour map of it has "
                     "300 stops, and shaders with gradients take at most 256");
    }
}

/// A recipe whose base colour, roughness or emission, and bumps are one node; the bumps of a colour
/// are its luminance.
Recipe all_of(const GraphCase& one) {
    Recipe recipe;
    recipe.texture = graph_of(one.json);
    const bool number = recipe.texture.nodes[recipe.texture.result].wire == Wire::number;
    recipe.bump.input =
        number ? recipe.texture
               : graph_of(fmt::format(R"({{"node": "split", "channel": "luminance", "input": {}}})",
                                      one.json));
    recipe.texture.channels = {
        {number ? Channel::roughness : Channel::emissive, recipe.texture.result}};
    return recipe;
}

/// OpenGL drivers forgive what the language does not have, so the reference compiler reads them.
TEST(GlEmitMaterial, MaterialsAndNodesAreValidGlsl) {
    if (std::system("command -v glslangValidator >/dev/null") != 0)
        GTEST_SKIP() << "glslangValidator (package glslang-tools) is not installed";
    const test::Scratch scratch;
    std::string files;
    const auto add = [&](const std::string& name, const Recipe& recipe) {
        files += " '" + scratch.write(name + ".frag", emit_glsl(recipe, {}).text) + "'";
    };
    for (const GraphCase& one : graph_cases) add(fmt::format("node-{}", one.node), all_of(one));
    for (const char* alpha : {"blend", "mask", "opaque"}) {
        const std::string mode = fmt::format(R"("alpha": "{}",)", alpha);
        add(fmt::format("clear-{}", alpha), material(clear_colors + mode));
        add(fmt::format("{}", alpha), material(opaque_colors + mode + R"("opacity": 0.5,)"));
    }
    const std::string log = scratch / "log.txt";
    const int status = std::system(("glslangValidator" + files + " >'" + log + "'").c_str());
    EXPECT_EQ(status, 0) << test::slurp(log);
    // It names each file that it has read.
    for (const char* file : {"node-split.frag", "node-marble.frag", "clear-mask.frag"})
        EXPECT_THAT(test::slurp(log), HasSubstr(file));
}

}  // namespace
}  // namespace burl
