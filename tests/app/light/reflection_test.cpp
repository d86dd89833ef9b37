// Directions that are drawn against the densities that they are said to have.
#include "app/light/reflection.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "app/light/light_sampler.h"
#include "atlas/base/random_unit.h"

namespace burl {
namespace {

using std::numbers::pi;

/// A direction of a lattice of `count`, even on the sphere.
Vec3d even_direction(int i, int count) {
    const double y = 1.0 - (2.0 * i + 1.0) / count, turn = 2.399963229728653 * i;
    const double out = std::sqrt(1.0 - y * y);
    return {out * std::cos(turn), y, out * std::sin(turn)};
}

std::vector<ShadedPoint> sampled_points() {
    std::vector<ShadedPoint> points(5);
    points[1].metallic = 1.0, points[1].roughness = 0.5;
    points[2].clearcoat = 1.0, points[2].clearcoat_roughness = 0.6, points[2].roughness = 0.8,
    points[2].coat_normal = glm::normalize(Vec3d(0.2, -0.1, 1.0));
    points[3].transmission = 0.7, points[3].roughness = 0.6;
    points[4].sheen = Vec3d(0.5), points[4].sheen_roughness = 0.6, points[4].roughness = 0.4;
    return points;
}

/// The densities sum to 1 over all directions, and what lies in an octant is what is drawn there.
TEST(Reflection, DrawsDirectionsAsOftenAsItSays) {
    const Vec3d normal = glm::normalize(Vec3d(0.3, 0.5, 0.9)),
                view = glm::normalize(Vec3d(-0.5, 0.7, 0.6));
    for (const ShadedPoint& point : sampled_points()) {
        const Reflection reflection(point, normal, view);
        const auto octant = [](const Vec3d& d) {
            return (d.x > 0.0 ? 1u : 0u) + (d.y > 0.0 ? 2u : 0u) + (d.z > 0.0 ? 4u : 0u);
        };
        std::array<double, 8> drawn{}, said{};
        constexpr int count = 40'000;
        for (int i = 0; i < count; ++i) {
            const auto k = std::uint64_t(i);
            const Vec3d light = reflection.sample(
                (i + 0.5) / count, {random_unit(1, 2 * k), random_unit(1, 2 * k + 1)});
            EXPECT_NEAR(glm::length(light), 1.0, 1e-9);
            drawn[octant(light)] += 1.0 / count;
            const Vec3d d = even_direction(i, count);
            said[octant(d)] += reflection.density(d) * 4.0 * pi / count;
        }
        double sum = 0.0;
        for (std::size_t o = 0; o < 8; ++o) {
            EXPECT_NEAR(drawn[o], said[o], 0.01) << o;
            sum += said[o];
        }
        EXPECT_NEAR(sum, 1.0, 0.01);
    }
}

TEST(Reflection, SumsByItsOwnDirectionsAreThoseOfEvenOnes) {
    const Vec3d normal(0.0, 0.0, 1.0), view = glm::normalize(Vec3d(-0.5, 0.2, 0.6));
    const auto sky = [](const Vec3d& d) { return 1.0 + 0.5 * d.x + 0.3 * d.y * d.z; };
    for (const ShadedPoint& point : sampled_points()) {
        const Reflection reflection(point, normal, view);
        double even = 0.0, own = 0.0;
        constexpr int count = 60'000;
        for (int i = 0; i < count; ++i) {
            const Vec3d d = even_direction(i, count);
            even += sky(d) * reflection(d).y * 4.0 * pi / count;
            const auto k = std::uint64_t(i);
            const Vec3d l = reflection.sample((i + 0.5) / count,
                                              {random_unit(2, 2 * k), random_unit(2, 2 * k + 1)});
            own += sky(l) * reflection(l).y / reflection.density(l) / count;
        }
        EXPECT_NEAR(own, even, 0.01 * even);
    }
}

TEST(LightSampler, DrawsDirectionsAsOftenAsThereIsLight) {
    for (const char* name : {"neutral", "studio", "warehouse"}) {
        const LightSampler sampler(make_environment(name, 64));
        Vec3d drawn(0.0), even(0.0);
        double sum = 0.0;
        constexpr int count = 40'000;
        for (int i = 0; i < count; ++i) {
            const auto k = std::uint64_t(i);
            const Vec3d l = sampler.sample({random_unit(3, 2 * k), random_unit(3, 2 * k + 1)});
            const LightSampler::Seen seen = sampler(l);
            ASSERT_GT(seen.density, 0.0);
            drawn += seen.light * (1.0 + l.y) / seen.density / double(count);
            const Vec3d d = even_direction(i, count);
            even += light_from(sampler.environment(), d) * (1.0 + d.y) * 4.0 * pi / double(count);
            sum += sampler(d).density * 4.0 * pi / count;
        }
        EXPECT_NEAR(sum, 1.0, 0.02) << name;
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(drawn[c], even[c], 0.02 * even[c]) << name;
    }
}

TEST(LightSampler, TakesDarknessAndMapsLargerThanItsSums) {
    const LightSampler dark(Environment{Image<RgbF>(8, 4)});
    EXPECT_EQ(dark(dark.sample({0.3, 0.7})).light, Vec3d(0.0));
    Image<RgbF> map(2068, 1034);
    map(1500, 300) = {9.0f, 9.0f, 9.0f};
    const LightSampler spot(Environment{map});
    // Sums are of 3 x 3 pixels, and a pixel's light reaches into the next ones.
    for (double at = 0.05; at < 1.0; at += 0.1) {
        const Vec2d uv = equirectangular(spot.sample({at, at}));
        EXPECT_NEAR(uv.x, 1500.5 / 2068.0, 4.0 / 2068.0);
        EXPECT_NEAR(uv.y, 300.5 / 1034.0, 4.0 / 1034.0);
    }
}

}  // namespace
}  // namespace burl
