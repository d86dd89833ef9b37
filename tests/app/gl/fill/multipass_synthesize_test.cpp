// Textures by the papers' passes against the host's.
#include "app/gl/fill/multipass.h"
#include "app/recipe/edit/recipe_json.h"

#include <cmath>

#include <gtest/gtest.h>

#include "app/base/embedded.h"
#include "app/pipeline/pipeline.h"
#include "app/surface/sample_meshes.h"
#include "procedural/color/table.h"
#include "procedural/fill/synthesize.h"
#include "tests/app/gl/device/fixture.h"

namespace burl {
namespace {

/// A mesh's atlas.
struct Subject {
    Pipeline pipeline{sample_mesh("sample:teapot")};
    Subject() {
        Recipe recipe;
        recipe.atlas.size = 64;
        pipeline.set_recipe(recipe);
    }
    const SolidAtlas& solid() { return pipeline.solid(); }
};

using GlMultipassSynthesizeTest = GlTest;

double distance_of_indices(Wrap wrap, double a, double b) {
    const double d = std::abs(a - b);
    return wrap == Wrap::repeat ? std::min(d, 1.0 - d) : d;
}

struct Distance {
    double largest = 0.0, squares = 0.0;
};

/// The distance of the colour map's index from the host's.
Distance distance_of(GlMultipassSynthesis& gl, const SolidAtlas& solid, const Recipe& recipe) {
    const Texture& texture = *plain_texture(recipe.texture);
    const Affine3 map = texture_from_solid(recipe);
    Image<float> index;
    gl.synthesize(solid, texture, map, 0, index);
    const Image<float> field = synthesize_field(solid, texture, map, 0, Kernel::direct);
    Distance distance;
    const Wrap wrap = texture.colors.wrap;
    for (std::size_t i = 0; i < field.pixels().size(); ++i) {
        const double expected = map_index(wrap, double(field.pixels()[i]));
        const double d = distance_of_indices(wrap, double(index.pixels()[i]), expected);
        distance.largest = std::max(distance.largest, d);
        distance.squares += d * d / double(field.pixels().size());
    }
    return distance;
}

/// Recipes that the passes can make.
std::vector<Recipe> presets(const GlMultipassSynthesis& gl) {
    std::vector<Recipe> recipes;
    for (const EmbeddedFile& preset : embedded_recipes()) {
        Recipe recipe = load_recipe(std::string(preset.name.substr(0, preset.name.find('.'))));
        if (const Texture* texture = plain_texture(recipe.texture);
            texture && gl.problem(*texture).empty())
            recipes.push_back(std::move(recipe));
    }
    return recipes;
}

TEST_F(GlMultipassSynthesizeTest, Float32HasTheHostsIndexTo2e6) {
    Subject subject;
    GlMultipassSynthesis gl(*context, {});
    const std::vector<Recipe> recipes = presets(gl);
    EXPECT_GE(recipes.size(), 6u);
    for (const Recipe& recipe : recipes)
        EXPECT_LE(distance_of(gl, subject.solid(), recipe).largest, 2e-6) << recipe.name;
}

TEST_F(GlMultipassSynthesizeTest, WithoutFloat64AsWell) {
    Subject subject;
    GlSynthesisLimits limits;
    limits.float64 = false;
    GlMultipassSynthesis gl(*context, {}, limits);
    EXPECT_LE(distance_of(gl, subject.solid(), load_recipe("marble")).largest, 2e-6);
}

TEST_F(GlMultipassSynthesizeTest, FewerBitsAreFurtherAway) {
    Subject subject;
    const Recipe recipe = load_recipe("marble");
    GlMultipassSynthesis half(*context, {PassPrecision::float16, Randomizer::hash});
    const Distance halves = distance_of(half, subject.solid(), recipe);
    EXPECT_LE(std::sqrt(halves.squares), 0.001);
    EXPECT_GE(std::sqrt(halves.squares), 0.00001);
    GlMultipassSynthesis fixed(*context, {PassPrecision::fixed8, Randomizer::hash});
    const Distance eighths = distance_of(fixed, subject.solid(), recipe);
    EXPECT_LE(std::sqrt(eighths.squares), 0.04);
    EXPECT_GE(std::sqrt(eighths.squares), 0.002);
    EXPECT_EQ(fixed.octaves().size(), 4u);
    EXPECT_EQ(fixed.octaves().back().bits.integer + 3, fixed.octaves().front().bits.integer);
}

TEST_F(GlMultipassSynthesizeTest, ColorsAreTheHostsButForRounding) {
    Subject subject;
    const Recipe recipe = load_recipe("marble");
    const Affine3 map = texture_from_solid(recipe);
    GlMultipassSynthesis gl(*context, {});
    Image<Rgb8> colors, again;
    gl.synthesize(subject.solid(), *plain_texture(recipe.texture), map, 0, colors);
    const Image<Rgb8> host =
        synthesize_model<Rgb8>(subject.solid(), *plain_texture(recipe.texture), map, 0);
    EXPECT_LE(differing(colors, host), colors.pixels().size() / 500);
    EXPECT_EQ(gl.work().passes, 4 * 63 + 2);
    gl.synthesize(subject.solid(), *plain_texture(recipe.texture), map, 0, again);
    EXPECT_EQ(differing(colors, again), 0u);
    EXPECT_EQ(gl.work().maps, 0) << "kept";
}

TEST_F(GlMultipassSynthesizeTest, WiderPixelsAreNearTheHosts) {
    Subject subject;
    const Recipe recipe = load_recipe("marble");
    const Affine3 map = texture_from_solid(recipe);
    GlMultipassSynthesis gl(*context, {});
    Image<RgbF> linear;
    Image<Rgb16> codes;
    gl.synthesize(subject.solid(), *plain_texture(recipe.texture), map, 0, linear);
    gl.synthesize(subject.solid(), *plain_texture(recipe.texture), map, 0, codes);
    const Image<RgbF> host_linear =
        synthesize_model<RgbF>(subject.solid(), *plain_texture(recipe.texture), map, 0);
    const Image<Rgb16> host_codes =
        synthesize_model<Rgb16>(subject.solid(), *plain_texture(recipe.texture), map, 0);
    for (std::size_t i = 0; i < linear.pixels().size(); ++i) {
        ASSERT_NEAR(linear.pixels()[i].g, host_linear.pixels()[i].g, 2e-5f) << i;
        ASSERT_NEAR(int(codes.pixels()[i].g), int(host_codes.pixels()[i].g), 2) << i;
    }
}

/// All that the command line can ask for.
std::vector<MultipassOptions> forms() {
    std::vector<MultipassOptions> forms;
    for (const PassPrecision precision :
         {PassPrecision::float32, PassPrecision::float16, PassPrecision::fixed8})
        for (const Randomizer randomizer : {Randomizer::hash, Randomizer::table})
            forms.push_back({precision, randomizer});
    forms.push_back({PassPrecision::fixed8, Randomizer::bits});
    forms.push_back({PassPrecision::fixed8, Randomizer::bits, true});
    return forms;
}

Recipe two_octaves() {
    Recipe recipe = load_recipe("marble");
    plain_texture(recipe.texture)->noise[0].octaves = 2;
    return recipe;
}

TEST_F(GlMultipassSynthesizeTest, EveryFormGivesIndicesAndTheSameAgain) {
    Subject subject;
    const Recipe recipe = two_octaves();
    const Affine3 map = texture_from_solid(recipe);
    for (const MultipassOptions& form : forms()) {
        GlMultipassSynthesis gl(*context, form);
        ASSERT_EQ(gl.problem(*plain_texture(recipe.texture)), "");
        Image<float> index, again;
        gl.synthesize(subject.solid(), *plain_texture(recipe.texture), map, 0, index);
        gl.synthesize(subject.solid(), *plain_texture(recipe.texture), map, 1, again);
        float least = 1.0f, largest = 0.0f;
        for (const float i : index.pixels()) {
            ASSERT_TRUE(i >= 0.0f && i <= 1.0f) << i;
            least = std::min(least, i), largest = std::max(largest, i);
        }
        EXPECT_GT(largest - least, 0.5f) << int(form.precision) << int(form.randomizer);
        EXPECT_EQ(differing(index, again), 0u) << int(form.precision) << int(form.randomizer);
    }
}

/// In the form with the most images of its own: tables of bits, made white.
TEST_F(GlMultipassSynthesizeTest, ANewOneGivesTheSame) {
    Subject subject;
    const Recipe recipe = two_octaves();
    const Affine3 map = texture_from_solid(recipe);
    GlMultipassSynthesis one(*context, forms().back()), other(*context, forms().back());
    Image<float> index, anew;
    one.synthesize(subject.solid(), *plain_texture(recipe.texture), map, 0, index);
    other.synthesize(subject.solid(), *plain_texture(recipe.texture), map, 0, anew);
    EXPECT_EQ(differing(index, anew), 0u);
}

TEST_F(GlMultipassSynthesizeTest, TilesLeaveNoTrace) {
    Subject subject;
    const Recipe recipe = load_recipe("clouds");
    const Affine3 map = texture_from_solid(recipe);
    const MultipassOptions options{PassPrecision::fixed8, Randomizer::table};
    GlSynthesisLimits limits;
    limits.tile = 40;
    GlMultipassSynthesis whole(*context, options), parts(*context, options, limits);
    Image<Rgb8> one, many;
    whole.synthesize(subject.solid(), *plain_texture(recipe.texture), map, 0, one);
    parts.synthesize(subject.solid(), *plain_texture(recipe.texture), map, 0, many);
    EXPECT_EQ(differing(one, many), 0u);
    EXPECT_EQ(parts.work().passes, 4 * whole.work().passes);
}

TEST_F(GlMultipassSynthesizeTest, SaysWhatItCannotMake) {
    GlMultipassSynthesis gl(*context, {});
    NoiseTerm term;
    term.kind = NoiseKind::simplex;
    Texture texture;
    texture.noise = {term};
    texture.colors.stops = {{0.0, {0, 0, 0}}};
    EXPECT_NE(gl.problem(texture), "");
    Subject subject;
    Image<Rgb8> image;
    EXPECT_THROW(gl.synthesize(subject.solid(), texture, {}, 0, image), Error);
}

}  // namespace
}  // namespace burl
