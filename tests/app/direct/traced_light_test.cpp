// Light summed over directions against what is known of it: white furnaces, walls and balls that
// block a known part of the sky.
#include "app/direct/traced_light.h"

#include <cmath>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "app/direct/picture.h"
#include "app/image/exr_io.h"
#include "app/light/tone.h"
#include "atlas/base/error.h"
#include "tests/app/support/sample_scene.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

Environment room_of(float light) {
    return {Image<RgbF>(64, 32, {light, light, light})};
}

ShadedPoint white_paper() {
    ShadedPoint point;
    point.specular = 0.0;
    return point;
}

LitPoint facing_up(const Vec3d& place) {
    return {place, place, {0.0, 1.0, 0.0}, {0.0, 1.0, 0.0}, glm::normalize(Vec3d(0.3, 1.0, 0.2))};
}

/// The mean over several points' draws.
Vec3d mean_light(const TracedLight& light, const ShadedPoint& material, const LitPoint& at) {
    Vec3d sum(0.0);
    for (int i = 0; i < 16; ++i) sum += light(material, at, {7, i}) / 16.0;
    return sum;
}

/// A rectangle in the plane x = `x`, from z = -size to size and y = 0 to size.
Mesh wall_mesh(double x, double size) {
    Mesh mesh;
    mesh.positions = {{x, 0, -size}, {x, 0, size}, {x, size, size}, {x, size, -size}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    add_whole_part(mesh);
    return mesh;
}

TEST(TracedLight, AWhiteRoomLosesNothing) {
    const TracedLight light(room_of(2.0f), 256, nullptr);
    for (const double roughness : {0.0, 0.3, 1.0})
        for (const double metallic : {0.0, 1.0}) {
            ShadedPoint point;
            point.roughness = roughness, point.metallic = metallic;
            EXPECT_NEAR(mean_light(light, point, facing_up({})).y, 2.0, 0.02) << roughness;
        }
}

/// A wall without an end beside a point hides half the sky, by symmetry.
TEST(TracedLight, AWallHidesHalfTheSky) {
    const Mesh mesh = wall_mesh(0.001, 1000.0);
    const Blockers wall(mesh);
    const TracedLight light(room_of(1.0f), 256, &wall);
    EXPECT_NEAR(mean_light(light, white_paper(), facing_up({0.0, 1e-3, 0.0})).x, 0.5, 0.01);
    EXPECT_NEAR(mean_light(light, white_paper(), facing_up({0.0, 1e-3, 5000.0})).x, 1.0, 0.05);
}

/// A ball of radius r whose middle is d above a plane hides (r / d)^2 of its light (the form factor
/// of a sphere over a patch that it stands above).
TEST(TracedLight, ABallsShadowIsItsFormFactor) {
    Mesh mesh = sphere_mesh(48, 96);
    for (Vec3d& p : mesh.positions) p.y += 2.0;
    const Blockers ball(mesh);
    EXPECT_NEAR(ball.lowest().value(), 1.0, 0.01);
    const TracedLight light(room_of(1.0f), 256, &ball);
    double sum = 0.0;
    for (int i = 0; i < 16; ++i) sum += light.shadow({0.0, 0.0, 0.0}, {3, i}) / 16.0;
    EXPECT_NEAR(sum, 0.25, 0.01);
    EXPECT_NEAR(mean_light(light, white_paper(), facing_up({})).z, 0.75, 0.01);
    EXPECT_NEAR(light.shadow({300.0, 0.0, 0.0}, {3, 0}), 0.0, 0.01);
}

TEST(TracedLight, WhatStandsBehindHidesTheRoomButNotTheSurfaceItself) {
    const Mesh mesh = wall_mesh(0.0, 1000.0);
    const Blockers wall(mesh);
    const TracedLight light(room_of(1.0f), 256, &wall);
    ShadedPoint glass;
    glass.transmission = 1.0, glass.roughness = 0.1;
    LitPoint at = facing_up({});
    at.normal = at.smooth = at.view = {1.0, 0.0, 0.0};
    at.place = {0.001, 500.0, 0.0}, at.behind = {-0.001, 500.0, 0.0};
    EXPECT_NEAR(mean_light(light, glass, at).x, 1.0, 0.01);
    at.behind = at.place;
    EXPECT_NEAR(mean_light(light, glass, at).x, dielectric_f0(1.5), 0.01);
}

TEST(TracedLight, SmoothLightIsTheAmbientShading) {
    const Environment studio = make_environment("studio", 64);
    const TracedLight light(std::make_shared<const PrefilteredLight>(prefilter(studio)));
    ShadedPoint gold;
    gold.base = {1.0, 0.7, 0.3}, gold.metallic = 1.0, gold.roughness = 0.4;
    const LitPoint at = facing_up({});
    EXPECT_EQ(light(gold, at, {1, 0}), light(gold, at, {2, 0}));
    EXPECT_LT(glm::length(light(gold, at, {}) -
                          ambient_shading(gold, at.normal, at.view, prefilter(studio))),
              1e-9);
}

/// Shaded by the prefiltered light and summed over directions, a point without anything around it
/// is about the same.
TEST(TracedLight, PrefilteredLightIsNearIt) {
    const Environment room = make_environment("neutral", 64);
    const TracedLight summed(room, 1024, nullptr),
        smooth(std::make_shared<const PrefilteredLight>(prefilter(room)));
    for (const double roughness : {0.1, 0.5, 1.0})
        for (const double metallic : {0.0, 1.0}) {
            ShadedPoint point;
            point.base = {0.8, 0.5, 0.3}, point.roughness = roughness, point.metallic = metallic;
            const LitPoint at = facing_up({});
            const Vec3d truth = mean_light(summed, point, at);
            EXPECT_LT(glm::length(smooth(point, at, {}) - truth), 0.05 * glm::length(truth));
        }
}

// Pictures

DirectOptions lit_ball(const std::string& light) {
    DirectOptions options;
    options.scene = "sample:icosphere";
    options.size = "24x24";
    options.light.light = light;
    options.recipe.recipe = "gold";
    options.picture.supersample = 2;
    options.rays = 16;
    return options;
}

Image<Rgba8> lit_picture(const DirectOptions& options) {
    return DirectPicture(options).with_alpha(picture_recipes(options, {}).front());
}

TEST(LitPicture, IsTheSameForAnyThreads) {
    DirectOptions options = lit_ball("studio");
    options.light.ground = true;
    const Image<Rgba8> many = lit_picture(options);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(lit_picture(options), many);
}

/// In a white room every point of a white surface shows the room, whatever its material.
TEST(LitPicture, AWhiteRoomLeavesAWhiteBallUnseen) {
    const ScratchFolder folder;
    write_exr(folder / "white.exr", Image<RgbF>(16, 8, {0.5f, 0.5f, 0.5f})).commit();
    DirectOptions options = lit_ball(folder / "white.exr");
    options.recipe.settings = {"define.alloy=#ffffff", "define.bloom=#ffffff", "bump.height=0"};
    options.light.background = "light", options.light.tone = "none";
    options.rays = 64;
    const Image<Rgba8> picture = lit_picture(options);
    for (const Rgba8& p : picture.pixels()) {
        EXPECT_NEAR(p.r, 188, 6);  // the code of 0.5
        EXPECT_NEAR(p.b, 188, 6);
        EXPECT_EQ(p.a, 255);
    }
}

TEST(LitPicture, ABackgroundMayBeTransparent) {
    DirectOptions options = lit_ball("overcast");
    options.light.background = "transparent";
    const Image<Rgba8> picture = lit_picture(options);
    EXPECT_EQ(picture(0, 0).a, 0);
    EXPECT_EQ(picture(12, 12).a, 255);
    options.light.ground = true;
    const Image<Rgba8> standing = lit_picture(options);
    int shadow = 0;
    for (std::size_t x = 0; x < 24; ++x) shadow += standing(x, 22).a;
    EXPECT_GT(shadow, 24);
}

TEST(LitPicture, TheEnvironmentStandsBehindWhereItIsAskedFor) {
    DirectOptions options = lit_ball("warehouse");
    options.light.background = "light", options.light.turn = 40.0, options.light.exposure = -1.0;
    const Image<Rgba8> picture = lit_picture(options);
    const Environment room = turned(make_environment("warehouse", 1024), 40.0);
    const Camera camera = orbit_camera(View{}, {Vec3d(0.0), 1.0}, {24, 24});
    const SrgbEncoder<std::uint8_t> encode;
    for (const std::size_t x : {0u, 23u}) {
        const Vec3d d = ray_through(camera, {24, 24}, {double(x) + 0.5, 23.5}).direction;
        const Vec3d shown = developed(light_from(room, d), options.light.light_options());
        EXPECT_NEAR(picture(x, 23).g, encode(shown.y), 12);
    }
}

TEST(LitPicture, ShadowsFallOnPlanes) {
    DirectOptions options = lit_ball("overcast");
    options.planes = {"terracotta:0,1,0,-1.05"};
    options.view = "0,40,4.5";
    const Image<Rgba8> shaded = lit_picture(options);
    options.rays = 0;
    const Image<Rgba8> open = lit_picture(options);
    // Below the ball the plane is darker than without shadows, in a corner it is not.
    EXPECT_LT(int(shaded(12, 21).g), int(open(12, 21).g) - 8);
    EXPECT_NEAR(shaded(1, 22).g, open(1, 22).g, 14);
}

}  // namespace
}  // namespace burl
