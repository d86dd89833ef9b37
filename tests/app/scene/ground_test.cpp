// The shadow on the ground against form factors, and against the shape of a sun's shadow.
#include "app/scene/ground.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace burl {
namespace {

/// A square plate of side 2 at height 1 over the lowest point, a speck.
Scene plate() {
    Scene scene;
    Surface& surface = scene.surfaces.emplace_back();
    surface.positions = {{-1, 1, -1}, {1, 1, -1},   {1, 1, 1},   {-1, 1, 1},
                         {0, 0, 0},   {1e-3, 0, 0}, {0, 0, 1e-3}};
    surface.normals.assign(7, Vec3f(0, 1, 0));
    surface.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}};
    return scene;
}

/// The mean shadow of the texels nearest to a point of the ground.
double shadow_at(const Ground& ground, double x, double z) {
    const double n = double(ground.shadow.width());
    return double(ground.shadow(std::size_t((x - ground.corner.x) / ground.side * n),
                                std::size_t((z - ground.corner.z) / ground.side * n)));
}

/// The share of a white sky that a rectangle at height 1 hides from below its corner (Howell's
/// catalogue of form factors, B-3).
double corner_factor(double x, double y) {
    const double a = std::hypot(1.0, x), b = std::hypot(1.0, y);
    return (x / a * std::atan(y / a) + y / b * std::atan(x / b)) / (2.0 * std::numbers::pi);
}

TEST(Ground, HidesTheSkyAsFormFactorsSay) {
    const Ground ground = ground_under(plate(), white_environment());
    EXPECT_DOUBLE_EQ(ground.corner.y, 0.0);
    EXPECT_NEAR(shadow_at(ground, 0.05, 0.05), 4.0 * corner_factor(1.0, 1.0), 0.01);
    EXPECT_NEAR(shadow_at(ground, 1.0, 1.0), corner_factor(2.0, 2.0), 0.015);
    EXPECT_NEAR(shadow_at(ground, -1.0, 0.0), 2.0 * corner_factor(2.0, 1.0), 0.015);
    EXPECT_EQ(ground.shadow(0, 0), 0.0f);
}

TEST(Ground, FollowsTheSun) {
    Environment sun{Image<RgbF>(256, 128)};
    const Vec3d towards = glm::normalize(Vec3d(1.0, 1.0, 0.0));
    const Vec2d at = equirectangular(towards);
    sun.radiance(std::size_t(at.x * 256), std::size_t(at.y * 128)) = {1e4f, 1e4f, 1e4f};
    const Ground ground = ground_under(plate(), sun);
    EXPECT_NEAR(shadow_at(ground, -1.0, 0.0), 1.0, 0.02) << "the plate's shadow is moved by 1";
    EXPECT_NEAR(shadow_at(ground, -1.8, 0.8), 1.0, 0.02);
    EXPECT_NEAR(shadow_at(ground, 0.3, 0.0), 0.0, 0.02);
    EXPECT_NEAR(shadow_at(ground, -1.0, 1.2), 0.0, 0.02);
}

TEST(Ground, HasNoShadowWithoutLight) {
    const Ground ground = ground_under(plate(), {Image<RgbF>(8, 4)});
    for (const float shadow : ground.shadow.pixels()) ASSERT_EQ(shadow, 0.0f);
}

TEST(Ground, IsTheSameOnEveryNumberOfThreads) {
    const Ground all = ground_under(plate(), make_environment("studio", 64));
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(ground_under(plate(), make_environment("studio", 64)).shadow, all.shadow);
}

}  // namespace
}  // namespace burl
