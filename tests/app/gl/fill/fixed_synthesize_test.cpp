// The single pass in fixed point: it draws what it should, the host's bytes, and leaves alone what
// it cannot draw.
#include "app/gl/fill/fixed_synthesize.h"

#include <random>

#include <gtest/gtest.h>

#include "app/base/embedded.h"
#include "app/gl/fill/synthesize.h"
#include "app/recipe/recipe.h"
#include "procedural/fill/synthesize.h"
#include "tests/app/gl/device/fixture.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

const Affine3 moved{Mat3d(1.25), Vec3d(0.25, -1, 3)};

SolidAtlas atlas_of(std::uint32_t size) {
    SyntheticAtlas atlas;
    atlas.size = size, atlas.block = 21;
    return atlas.make(8);
}

class GlFixedSynthesisTest : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        if (context) fixed.emplace(context->gl(), 2048, std::size_t(1) << 28);
    }
    bool draw(const SolidAtlas& solid, const Texture& texture) {
        image = Image<Rgb8>(solid.size, solid.size);
        work = {};
        return fixed->synthesize(solid, texture, moved, 0, image, work);
    }
    void expect_host(const SolidAtlas& solid, const Texture& texture, const std::string& name) {
        ASSERT_TRUE(draw(solid, texture)) << name;
        const Image<Rgb8> host = synthesize_rgb8(solid, texture, moved, 0, {}, Kernel::direct);
        EXPECT_EQ(differing(image, host), 0u) << name;
    }

    std::optional<GlFixedSynthesis> fixed;
    Image<Rgb8> image;
    GlWork work;
};

TEST_F(GlFixedSynthesisTest, DrawsPresetsWithTheHostsBytes) {
    const SolidAtlas solid = atlas_of(100);
    for (const char* name : {"marble", "clouds"}) {
        expect_host(solid, load_recipe(name).texture, name);
        EXPECT_EQ(work.passes, 1);
    }
}

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

TEST_F(GlFixedSynthesisTest, DrawsRandomTexturesWithTheHostsBytes) {
    const SolidAtlas solid = atlas_of(70);
    std::mt19937 random(11);
    int drawn = 0;
    for (int i = 0; i < 10; ++i) {
        const Texture texture = random_texture(random);
        if (!draw(solid, texture)) continue;
        const Image<Rgb8> host = synthesize_rgb8(solid, texture, moved, 0, {}, Kernel::direct);
        EXPECT_EQ(differing(image, host), 0u) << i;
        EXPECT_LT(fixed->undecided(), 70u) << i;
        ++drawn;
    }
    EXPECT_GE(drawn, 7);
}

/// Colours all of whose changes lie where the quadric is, in part of the texels: the host's work.
TEST_F(GlFixedSynthesisTest, TexelsAtAChangeAreTheHosts) {
    SolidAtlas solid = atlas_of(128);
    solid.maps[0].step_x = solid.maps[0].step_y = Vec3d(0.0);
    Texture texture;
    texture.colors = {Wrap::repeat, {{0.0, {0, 0, 0}}, {0.5, {0, 0, 0}}, {0.5, {255, 255, 255}}}};
    texture.quadric.i = 1.0;
    const double z = moved(solid.maps[0].origin).z;
    texture.quadric.j = 0.5 - 2.0 * z + 1e-13;
    expect_host(solid, texture, "at a change");
    EXPECT_GT(fixed->undecided(), 0u);
}

TEST_F(GlFixedSynthesisTest, WhatItCannotDrawIsLeftToFloat64) {
    const SolidAtlas solid = atlas_of(64);
    Texture flat = load_recipe("marble").texture;
    flat.noise.clear();
    flat.quadric = {};
    flat.colors = {Wrap::repeat, {{0.0, {9, 9, 9}}, {0.5, {9, 9, 9}}, {0.5, {99, 9, 9}}}};
    flat.quadric.j = 0.5;  // every texel at a change
    EXPECT_FALSE(draw(solid, flat));
    Texture huge = load_recipe("marble").texture;
    huge.quadric.j = 1e7;
    EXPECT_FALSE(draw(solid, huge));
    Texture simplex = load_recipe("marble").texture;
    simplex.noise[0].kind = NoiseKind::simplex;
    EXPECT_FALSE(draw(solid, simplex));
    EXPECT_EQ(work.passes, 0);
    // And drawn it is.
    GlSynthesis gl(*context);
    for (const Texture& texture : {flat, huge, simplex}) {
        gl.synthesize(solid, texture, moved, 0, image);
        EXPECT_EQ(differing(image, synthesize_rgb8(solid, texture, moved, 0, {}, Kernel::direct)),
                  0u);
    }
}

TEST_F(GlFixedSynthesisTest, TilesAndRepeatsLeaveNoTrace) {
    const SolidAtlas solid = atlas_of(150);
    const Texture texture = load_recipe("marble").texture;
    expect_host(solid, texture, "whole");
    const Image<Rgb8> whole = image;
    EXPECT_EQ(work.maps, 2);
    ASSERT_TRUE(draw(solid, texture));
    EXPECT_EQ(differing(image, whole), 0u);
    EXPECT_EQ(work.maps, 0);
    GlFixedSynthesis tiled(context->gl(), 70, 0);
    Image<Rgb8> other(solid.size, solid.size);
    ASSERT_TRUE(tiled.synthesize(solid, texture, moved, 1, other, work));
    EXPECT_EQ(work.passes, 1 + 9);
    EXPECT_EQ(differing(other, whole), 0u);
}

}  // namespace
}  // namespace burl
