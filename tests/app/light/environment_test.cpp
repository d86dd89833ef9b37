// Conventions of maps of all directions, and the built-in ones.
#include "app/light/environment.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "atlas/base/error.h"

namespace burl {
namespace {

using std::numbers::pi;

Environment environment_of(std::size_t height, Vec3d (*light)(const Vec3d&)) {
    Environment made{Image<RgbF>(2 * height, height)};
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < 2 * height; ++x) {
            const Vec3d c = light(direction_at(
                {(double(x) + 0.5) / (2.0 * double(height)), (double(y) + 0.5) / double(height)}));
            made.radiance(x, y) = {float(c.x), float(c.y), float(c.z)};
        }
    return made;
}

void expect_near(const Vec3d& a, const Vec3d& b, double tolerance) {
    EXPECT_LT(glm::length(a - b), tolerance)
        << a.x << " " << a.y << " " << a.z << ", not " << b.x << " " << b.y << " " << b.z;
}

TEST(Environment, MapsAxesAsThreeJsDoes) {
    EXPECT_NEAR(equirectangular({2.0, 0.0, 0.0}).x, 0.5, 1e-12);
    EXPECT_NEAR(equirectangular({0.0, 0.0, 3.0}).x, 0.75, 1e-12);
    EXPECT_NEAR(equirectangular({0.0, 0.0, -1.0}).x, 0.25, 1e-12);
    EXPECT_NEAR(equirectangular({1.0, 0.0, 1.0}).y, 0.5, 1e-12);
    EXPECT_NEAR(equirectangular({0.0, 5.0, 0.0}).y, 0.0, 1e-12);
    EXPECT_NEAR(equirectangular({0.0, -1.0, 0.0}).y, 1.0, 1e-12);
}

TEST(Environment, DirectionsComeBack) {
    for (double u = 0.03; u < 1.0; u += 0.1)
        for (double v = 0.05; v < 1.0; v += 0.1) {
            const Vec2d back = equirectangular(7.0 * direction_at({u, v}));
            EXPECT_NEAR(back.x, u, 1e-12);
            EXPECT_NEAR(back.y, v, 1e-12);
        }
}

TEST(Environment, LightBetweenPixelsIsBilinearAndGoesRound) {
    const Environment e = environment_of(64, [](const Vec3d& d) { return Vec3d(1.0) + d; });
    for (const Vec3d& d : {Vec3d(-1.0, 0.0, 1e-9), Vec3d(-1.0, 0.0, -1e-9), Vec3d(0.6, 0.8, 0.0),
                           Vec3d(0.0, 1.0, 0.0), Vec3d(0.48, -0.6, 0.64)})
        expect_near(light_from(e, 3.0 * d), Vec3d(1.0) + d, 0.03);
}

TEST(Environment, TurningBringsLightOfZToX) {
    const Environment e = environment_of(32, [](const Vec3d& d) {
        return Vec3d(std::exp(8.0 * (d.z - 1.0)), 0.5 + 0.5 * d.y, 0.0);
    });
    const Environment quarter = turned(e, 90.0), odd = turned(e, 33.0), back = turned(odd, -33.0);
    expect_near(light_from(quarter, {1.0, 0.0, 0.0}), light_from(e, {0.0, 0.0, 1.0}), 1e-6);
    const double a = 33.0 * pi / 180.0;
    expect_near(light_from(odd, {std::sin(a), 0.0, std::cos(a)}), light_from(e, {0.0, 0.0, 1.0}),
                0.01);
    expect_near(light_from(back, {0.0, 0.3, 1.0}), light_from(e, {0.0, 0.3, 1.0}), 0.02);
    EXPECT_EQ(turned(e, 360.0).radiance, e.radiance);
}

/// Irradiance / pi on a surface, by a sum over pixels.
double paper_at(const Environment& e, const Vec3d& normal) {
    const std::size_t height = e.radiance.height(), width = e.radiance.width();
    double sum = 0.0;
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x) {
            const double v = (double(y) + 0.5) / double(height);
            const Vec3d d = direction_at({(double(x) + 0.5) / double(width), v});
            const RgbF& p = e.radiance(x, y);
            const double light = 0.2126 * double(p.r) + 0.7152 * double(p.g) + 0.0722 * double(p.b);
            sum += light * std::max(0.0, glm::dot(d, normal)) * std::sin(pi * v);
        }
    return sum * (2.0 * pi / double(width)) * (pi / double(height)) / pi;
}

TEST(Environment, BuiltInOnesLightPaperAsTheySay) {
    for (const EnvironmentNote& note : environment_notes()) {
        SCOPED_TRACE(note.name);
        const Environment e = make_environment(note.name, 32);
        ASSERT_EQ(e.radiance.width(), 64u);
        for (const RgbF& p : e.radiance.pixels())
            ASSERT_TRUE(p.r >= 0.0f && p.g >= 0.0f && p.b >= 0.0f &&
                        std::isfinite(p.r + p.g + p.b));
        double sum = 0.0;
        constexpr int count = 64;
        for (int i = 0; i < count; ++i) {  // even on the upper half of the ball
            const double y = (i + 0.5) / count, turn = 2.39996 * i, out = std::sqrt(1.0 - y * y);
            sum += paper_at(e, {out * std::cos(turn), y, out * std::sin(turn)});
        }
        EXPECT_NEAR(sum / count, note.paper, 0.03);
    }
}

TEST(Environment, BuiltInOnesDifferAndAreTheSameForAnyThreads) {
    std::vector<Image<RgbF>> all;
    for (const EnvironmentNote& note : environment_notes()) {
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        all.push_back(make_environment(note.name, 24).radiance);
    }
    ASSERT_EQ(all.size(), 6u);
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(make_environment(environment_notes()[i].name, 24).radiance, all[i]);
        for (std::size_t k = 0; k < i; ++k) EXPECT_NE(all[i], all[k]);
    }
}

TEST(Environment, RefusesUnknownNames) {
    try {
        make_environment("moonlight");
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ExitCode::usage);
        EXPECT_THAT(e.what(), testing::HasSubstr("burl list environments"));
    }
}

}  // namespace
}  // namespace burl
