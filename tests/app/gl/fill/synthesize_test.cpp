// Textures of the 1999 model through OpenGL against the host's, byte by byte.
#include "app/gl/fill/synthesize.h"
#include "app/recipe/edit/recipe_json.h"

#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "app/base/embedded.h"
#include "app/pipeline/pipeline.h"
#include "app/surface/sample_meshes.h"
#include "procedural/fill/synthesize.h"
#include "tests/app/gl/device/fixture.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

/// A mesh's atlas, and textures of it.
struct SynthesizeSubject {
    Pipeline pipeline;
    SynthesizeSubject(const std::string& mesh, std::uint32_t size) : pipeline(sample_mesh(mesh)) {
        Recipe recipe;
        recipe.atlas.size = size;
        pipeline.set_recipe(recipe);
    }
    const SolidAtlas& solid() { return pipeline.solid(); }
};

template <class Pixel>
Image<Pixel> on_host(const SolidAtlas& solid, const Texture& texture, const Affine3& map) {
    if constexpr (std::is_same_v<Pixel, Rgb8>)
        return synthesize_model<Rgb8>(solid, texture, map, 0, {}, Kernel::direct);
    else if constexpr (std::is_same_v<Pixel, Rgb16>)
        return synthesize_model<Rgb16>(solid, texture, map, 0, {}, Kernel::direct);
    else if constexpr (std::is_same_v<Pixel, RgbF>)
        return synthesize_model<RgbF>(solid, texture, map, 0, {}, Kernel::direct);
    else
        return synthesize_field(solid, texture, map, 0, Kernel::direct);
}

using GlSynthesizeTest = GlTest;

template <class Pixel>
void expect_equal(GlSynthesis& gl, SynthesizeSubject& subject, const Recipe& recipe) {
    const Affine3 map = texture_from_solid(recipe);
    Image<Pixel> drawn;
    gl.synthesize(subject.solid(), *plain_texture(recipe.texture), map, 0, drawn);
    const Image<Pixel> expected =
        on_host<Pixel>(subject.solid(), *plain_texture(recipe.texture), map);
    EXPECT_EQ(differing(drawn, expected), 0u) << recipe.name << " " << sizeof(Pixel);
}

TEST_F(GlSynthesizeTest, EveryPresetHasTheHostsBytes) {
    GlSynthesis gl(*context);
    SynthesizeSubject subject("sample:teapot", 64);
    int presets = 0;
    for (const EmbeddedFile& preset : embedded_recipes()) {
        const Recipe recipe =
            load_recipe(std::string(preset.name.substr(0, preset.name.find('.'))));
        if (!plain_texture(recipe.texture)) continue;
        ASSERT_EQ(gl.problem(*plain_texture(recipe.texture)), "") << recipe.name;
        expect_equal<Rgb8>(gl, subject, recipe);
        expect_equal<float>(gl, subject, recipe);
        ++presets;
    }
    EXPECT_GE(presets, 7);
}

TEST_F(GlSynthesizeTest, WiderPixelsHaveTheHostsBits) {
    GlSynthesis gl(*context);
    SynthesizeSubject subject("sample:king", 64);
    const Recipe recipe = load_recipe("marble");
    expect_equal<Rgb16>(gl, subject, recipe);
    expect_equal<RgbF>(gl, subject, recipe);
}

/// Marble with another list of terms.
Recipe with_noise(const std::vector<NoiseTerm>& terms) {
    Recipe recipe = load_recipe("marble");
    plain_texture(recipe.texture)->noise = terms;
    return recipe;
}

TEST_F(GlSynthesizeTest, OctavesWithoutAStreamHaveTheHostsBits) {
    NoiseTerm stream, worley, timed, ridged, periodic;
    stream.kind = NoiseKind::simplex, stream.octaves = 2;
    worley.kind = NoiseKind::worley, worley.amplitude = 0.3, worley.seed = 5;
    timed.time = 1.25, timed.phase = Vec3d(0.3, 0.0, -7.0), timed.amplitude = 0.2;
    ridged.kind = NoiseKind::perlin, ridged.shape = OctaveShape::ridged, ridged.octaves = 2;
    periodic.period = {3, 0, 5}, periodic.frequency = Vec3d(2.0), periodic.amplitude = -0.4;
    GlSynthesis gl(*context);
    SynthesizeSubject subject("sample:torus", 64);
    const Recipe recipe = with_noise({stream, worley, timed, ridged, periodic});
    expect_equal<float>(gl, subject, recipe);
    expect_equal<Rgb8>(gl, subject, recipe);
}

TEST_F(GlSynthesizeTest, ColoursJumpWhereTheHostsDo) {
    GlSynthesis gl(*context);
    SynthesizeSubject subject("sample:cube", 64);
    Recipe recipe = load_recipe("marble");
    // Far more steps than entries in the first hundredth, jumps, and ends that hold.
    ColorMap& colors = plain_texture(recipe.texture)->colors;
    colors = {Wrap::clamp, {}};
    for (int i = 0; i < 400; ++i)
        colors.stops.push_back({0.2 + 1e-5 * i, i % 2 == 0 ? Rgb8{0, 255, 7} : Rgb8{255, 0, 130}});
    colors.stops.push_back({0.6, {1, 2, 3}});
    colors.stops.push_back({0.6, {201, 202, 203}});
    expect_equal<Rgb8>(gl, subject, recipe);
    expect_equal<RgbF>(gl, subject, recipe);
}

const Affine3 solid_map{Mat3d(1.25), Vec3d(0.25, -1, 3)};

SolidAtlas synthetic_atlas_of(std::uint32_t size) {
    SyntheticAtlas atlas;
    atlas.size = size, atlas.block = 21;
    return atlas.make(8);
}

/// Value and Perlin noise, quadrics and colour maps with jumps.
Texture random_texture(std::mt19937& random) {
    const auto number = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const auto below = [&](std::uint32_t n) { return std::uint32_t(random() % n); };
    Texture texture;
    texture.quadric = {number(-1, 1), 0, number(-1, 1), 0, number(-2, 2), 0, 0, 0,
                       number(-9, 9), 1};
    for (std::uint32_t i = below(3); i-- > 0;) {
        NoiseTerm term;
        term.kind = below(2) == 0 ? NoiseKind::value : NoiseKind::perlin;
        term.fade = std::array{Fade::linear, Fade::smooth, Fade::quintic}[below(3)];
        term.amplitude = number(-2, 2);
        term.frequency = Vec3d(number(0.1, 30), number(0.1, 30), number(0.1, 30));
        term.octaves = 1 + below(6);
        term.seed = std::uint32_t(random());
        texture.noise.push_back(term);
    }
    texture.colors.wrap = below(2) == 0 ? Wrap::repeat : Wrap::clamp;
    texture.colors.stops.clear();
    const auto color = [&] {
        return Rgb8{std::uint8_t(random()), std::uint8_t(random()), std::uint8_t(random())};
    };
    for (std::uint32_t i = 0, n = 2 + below(5); i < n; ++i) {
        texture.colors.stops.push_back({double(i) / (n - 1), color()});
        if (below(3) == 0) texture.colors.stops.push_back({double(i) / (n - 1), color()});
    }
    return texture;
}

TEST_F(GlSynthesizeTest, RandomTexturesHaveTheHostsBytes) {
    GlSynthesis gl(*context);
    const SolidAtlas solid = synthetic_atlas_of(70);
    std::mt19937 random(11);
    Image<Rgb8> drawn;
    for (int i = 0; i < 10; ++i) {
        const Texture texture = random_texture(random);
        gl.synthesize(solid, texture, solid_map, 0, drawn);
        EXPECT_EQ(differing(drawn, on_host<Rgb8>(solid, texture, solid_map)), 0u) << i;
    }
}

/// Colours all of whose changes lie where the quadric is in part of the texels.
TEST_F(GlSynthesizeTest, TexelsAtAChangeOfColourHaveTheHostsBytes) {
    GlSynthesis gl(*context);
    SolidAtlas solid = synthetic_atlas_of(128);
    solid.maps[0].step_x = solid.maps[0].step_y = Vec3d(0.0);
    Texture texture;
    texture.colors = {Wrap::repeat, {{0.0, {0, 0, 0}}, {0.5, {0, 0, 0}}, {0.5, {255, 255, 255}}}};
    texture.quadric.i = 1.0;
    texture.quadric.j = 0.5 - 2.0 * solid_map(solid.maps[0].origin).z + 1e-13;
    Image<Rgb8> drawn;
    gl.synthesize(solid, texture, solid_map, 0, drawn);
    EXPECT_EQ(differing(drawn, on_host<Rgb8>(solid, texture, solid_map)), 0u);
}

TEST_F(GlSynthesizeTest, StepsFarFieldsAndSimplexHaveTheHostsBytes) {
    GlSynthesis gl(*context);
    SynthesizeSubject subject("sample:teapot", 64);
    Recipe flat = with_noise({});
    Texture& steps = *plain_texture(flat.texture);
    steps.quadric = {};
    steps.quadric.j = 0.5;  // every texel at a step of the colours
    steps.colors = {Wrap::repeat, {{0.0, {9, 9, 9}}, {0.5, {9, 9, 9}}, {0.5, {99, 9, 9}}}};
    Recipe far = load_recipe("marble"), simplex = far;
    plain_texture(far.texture)->quadric.j = 1e7;
    plain_texture(simplex.texture)->noise[0].kind = NoiseKind::simplex;
    for (const Recipe& recipe : {flat, far, simplex}) expect_equal<Rgb8>(gl, subject, recipe);
}

TEST_F(GlSynthesizeTest, TilesAndThreadsLeaveNoTrace) {
    GlSynthesisLimits limits;
    limits.tile = 24;
    limits.map_budget = 0;
    GlSynthesis whole(*context), tiled(*context, limits);
    SynthesizeSubject subject("sample:teapot", 64);
    const Recipe recipe = load_recipe("wood");
    const Affine3 map = texture_from_solid(recipe);
    Image<Rgb8> one, two;
    const Texture& texture = *plain_texture(recipe.texture);
    whole.synthesize(subject.solid(), texture, map, 1, one);
    tiled.synthesize(subject.solid(), texture, map, 2, two);
    EXPECT_EQ(differing(one, two), 0u);
    EXPECT_EQ(whole.work().passes, 1);
    EXPECT_EQ(tiled.work().passes, 9);
    tiled.synthesize(subject.solid(), texture, map, 0, two);
    EXPECT_EQ(tiled.work().maps, 9);
    EXPECT_EQ(differing(one, two), 0u);
}

TEST_F(GlSynthesizeTest, EditsKeepMapsAndShaders) {
    GlSynthesis gl(*context);
    SynthesizeSubject subject("sample:teapot", 64);
    Recipe recipe = load_recipe("marble");
    expect_equal<Rgb8>(gl, subject, recipe);
    EXPECT_EQ(gl.work().maps, 1);
    EXPECT_GT(gl.work().compile, 0.0);
    Texture& texture = *plain_texture(recipe.texture);
    texture.noise[0].amplitude = 0.31;
    texture.noise[0].seed = 77;
    texture.colors.stops[1].color = {9, 99, 199};
    expect_equal<Rgb8>(gl, subject, recipe);
    EXPECT_EQ(gl.work().maps, 0);
    EXPECT_EQ(gl.work().compile, 0.0);
    texture.quadric.i = 0.75;
    expect_equal<Rgb8>(gl, subject, recipe);
    EXPECT_EQ(gl.work().maps, 1);
    recipe.solid.scale = 5.0;
    expect_equal<Rgb8>(gl, subject, recipe);
    EXPECT_EQ(gl.work().maps, 1);
    EXPECT_EQ(gl.work().compile, 0.0);
}

TEST_F(GlSynthesizeTest, WithoutFloat64TheFieldAgreesTo2em6) {
    GlSynthesisLimits limits;
    limits.float64 = false;
    GlSynthesis gl(*context, limits);
    SynthesizeSubject subject("sample:king", 64);
    const Recipe recipe = load_recipe("marble");
    const Affine3 map = texture_from_solid(recipe);
    Image<float> drawn;
    gl.synthesize(subject.solid(), *plain_texture(recipe.texture), map, 0, drawn);
    const Image<float> expected =
        on_host<float>(subject.solid(), *plain_texture(recipe.texture), map);
    float largest = 0.0f;
    for (std::size_t i = 0; i < drawn.pixels().size(); ++i)
        largest = std::max(largest, std::abs(drawn.pixels()[i] - expected.pixels()[i]));
    EXPECT_LE(largest, 2e-6f);
    EXPECT_GT(differing(drawn, Image<float>(64, 64)), 3000u);
}

TEST_F(GlSynthesizeTest, MoreLatticesThanTextureUnitsAreRefused) {
    GlSynthesis gl(*context);
    SynthesizeSubject subject("sample:cube", 64);
    NoiseTerm term;
    term.octaves = 24, term.lacunarity = 1.9;
    const Recipe recipe = with_noise({term});
    EXPECT_NE(gl.problem(*plain_texture(recipe.texture)), "");
    Image<Rgb8> image;
    EXPECT_THROW(gl.synthesize(subject.solid(), *plain_texture(recipe.texture),
                               texture_from_solid(recipe), 0, image),
                 Error);
}

}  // namespace
}  // namespace burl
