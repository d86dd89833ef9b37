// What a surface does with light: no energy is made or lost in a white furnace, and the function
// summed over directions is what the prefiltered light says.
#include "app/light/brdf.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "atlas/base/random_unit.h"

namespace burl {
namespace {

using std::numbers::pi;

Environment white_room() {
    return {Image<RgbF>(64, 32, {1.0f, 1.0f, 1.0f})};
}

Vec3d view_at(double cosine) {
    return {std::sqrt(1.0 - cosine * cosine), 0.0, cosine};
}

/// The sum of `reflected` over directions, half of them by cosine, half by GGX's density, both
/// weighted by the sum of the densities (Veach's balance heuristic); twice for below the surface.
Vec3d sum_over_directions(const ShadedPoint& point, const Vec3d& view, double lobe_roughness,
                          const Vec3d& normal = {0.0, 0.0, 1.0}) {
    const double alpha = std::pow(std::max(lobe_roughness, 0.03), 2.0), a2 = alpha * alpha;
    constexpr std::uint64_t count = 20'000;
    Vec3d sum(0.0);
    for (std::uint64_t i = 0; i < count; ++i) {
        const double u = (double(i) + 0.5) / count, turn = 2.0 * pi * random_unit(3, i);
        Vec3d light;
        if (i % 2 == 0) {
            light = Vec3d(std::sqrt(u) * std::cos(turn), std::sqrt(u) * std::sin(turn),
                          std::sqrt(1.0 - u));
        } else {
            const double c2 = (1.0 - u) / (1.0 + (a2 - 1.0) * u), s = std::sqrt(1.0 - c2);
            const Vec3d half(s * std::cos(turn), s * std::sin(turn), std::sqrt(c2));
            light = 2.0 * glm::dot(view, half) * half - view;
        }
        if (light.z <= 0.0) continue;
        const Vec3d half = glm::normalize(light + view);
        const double d = half.z * half.z * (a2 - 1.0) + 1.0;
        const double density = 0.5 * light.z / pi + 0.5 * a2 / (pi * d * d) * half.z /
                                                        (4.0 * std::abs(glm::dot(view, half)));
        const Vec3d through(light.x, light.y, -light.z);
        sum += (reflected(point, normal, view, light) + reflected(point, normal, view, through)) /
               density;
    }
    return sum / double(count);
}

struct Furnace {
    double metallic, roughness;
};

class WhiteFurnace : public testing::TestWithParam<Furnace> {};

TEST_P(WhiteFurnace, LosesAndMakesNothing) {
    ShadedPoint point;
    point.metallic = GetParam().metallic, point.roughness = GetParam().roughness;
    const PrefilteredLight light = prefilter(white_room(), 16);
    for (const double cosine : {0.1, 0.3, 0.7, 1.0}) {
        const Vec3d view = view_at(cosine);
        const Vec3d ambient = ambient_shading(point, {0.0, 0.0, 1.0}, view, light);
        EXPECT_NEAR(ambient.x, 1.0, 0.01) << cosine;
        const Vec3d traced = sum_over_directions(point, view, point.roughness);
        EXPECT_NEAR(traced.x, 1.0, 0.01) << cosine;
        EXPECT_EQ(traced.x, traced.z);
    }
}

std::vector<Furnace> furnaces() {
    std::vector<Furnace> all;
    for (const double metallic : {0.0, 0.5, 1.0})
        for (const double roughness : {0.0, 0.1, 0.25, 0.5, 0.75, 1.0})
            all.push_back({metallic, roughness});
    return all;
}

INSTANTIATE_TEST_SUITE_P(Materials, WhiteFurnace, testing::ValuesIn(furnaces()),
                         [](const auto& info) {
                             return "metal" + std::to_string(int(100.0 * info.param.metallic)) +
                                    "rough" + std::to_string(int(100.0 * info.param.roughness));
                         });

/// In a room of one colour the prefiltered light is exact, so that both must agree for every
/// material, to what the tables and the sum are worth.
TEST(Brdf, TheSumOverDirectionsIsTheAmbientShading) {
    const PrefilteredLight light = prefilter(white_room(), 16);
    std::vector<ShadedPoint> points(6);
    points[0].base = {0.8, 0.3, 0.1}, points[0].roughness = 0.4, points[0].metallic = 1.0;
    points[1].base = {0.2, 0.5, 0.7}, points[1].clearcoat = 0.8,
    points[1].clearcoat_roughness = 0.3;
    points[2].base = {0.4, 0.1, 0.2}, points[2].sheen = {0.9, 0.6, 0.4},
    points[2].sheen_roughness = 0.5;
    points[3].base = {0.9, 0.95, 1.0}, points[3].transmission = 1.0, points[3].roughness = 0.3;
    points[4].ior = 1.9, points[4].specular = 0.5, points[4].roughness = 0.6;
    points[5].base = {0.5, 0.4, 0.3}, points[5].transmission = 0.4, points[5].metallic = 0.3,
    points[5].roughness = 0.5, points[5].clearcoat = 1.0, points[5].clearcoat_roughness = 0.5;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (const double cosine : {0.2, 0.6, 0.95}) {
            const Vec3d view = view_at(cosine);
            const Vec3d ambient = ambient_shading(points[i], {0.0, 0.0, 1.0}, view, light);
            const Vec3d traced = sum_over_directions(points[i], view, points[i].roughness);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(traced[c], ambient[c], 0.015) << i << " " << cosine;
        }
}

TEST(Brdf, DielectricsReflectByTheirIor) {
    EXPECT_NEAR(dielectric_f0(1.5), 0.04, 1e-15);
    EXPECT_NEAR(dielectric_f0(2.4), 0.16955, 1e-5);
    EXPECT_EQ(dielectric_f0(1.0), 0.0);
}

/// Far from the mirror direction a rough dielectric is Lambert's surface less what the glossy lobe
/// takes; at the mirror direction the GGX peak is D F / (4 n.v) of a smooth-sided V.
TEST(Brdf, MetalsReflectTheirColourAtNormalIncidence) {
    ShadedPoint gold;
    gold.base = {1.0, 0.71, 0.29}, gold.metallic = 1.0, gold.roughness = 0.3;
    const Vec3d n(0.0, 0.0, 1.0), peak = reflected(gold, n, n, n);
    const double alpha = 0.09, ggx_peak = 1.0 / (pi * alpha * alpha);
    // D / 4 at n = h = l = v, plus what scatters more than once, which is below 1 / pi.
    EXPECT_NEAR(peak.x, 0.25 * ggx_peak, 0.02 * ggx_peak * 0.25 + 0.01);
    EXPECT_NEAR(peak.y / peak.x, 0.71, 0.01);
    EXPECT_NEAR(peak.z / peak.x, 0.29, 0.01);
}

TEST(Brdf, OpaqueSurfacesLetNothingThrough) {
    ShadedPoint point;
    const Vec3d n(0.0, 0.0, 1.0);
    EXPECT_EQ(reflected(point, n, view_at(0.5), {0.0, 0.6, -0.8}), Vec3d(0.0));
    point.transmission = 1.0, point.roughness = 0.2;
    EXPECT_GT(reflected(point, n, view_at(0.5), -view_at(0.5)).x, 1.0);
}

TEST(Brdf, EmissionPassesTheCoatAndOcclusionLeavesIt) {
    ShadedPoint point;
    point.emissive = {2.0, 1.0, 0.0};
    point.occlusion = 0.0;
    const PrefilteredLight light = prefilter(white_room(), 16);
    const Vec3d n(0.0, 0.0, 1.0);
    EXPECT_LT(glm::length(ambient_shading(point, n, n, light) - point.emissive), 1e-9);
    EXPECT_EQ(emitted(point, n, n), point.emissive);
    point.clearcoat = 1.0;
    EXPECT_NEAR(emitted(point, n, n).x, 2.0 * 0.96, 1e-12);
}

TEST(Brdf, OcclusionTakesItsShareOfLightFromAround) {
    ShadedPoint open, half;
    half.occlusion = 0.5;
    const PrefilteredLight light = prefilter(white_room(), 16);
    const Vec3d n(0.0, 0.0, 1.0), v = view_at(0.8);
    const double share =
        ambient_shading(half, n, v, light).x / ambient_shading(open, n, v, light).x;
    EXPECT_NEAR(share, 0.5, 0.05);
    EXPECT_NEAR(reflected(half, n, v, n).x / reflected(open, n, v, n).x, share, 0.1);
}

/// The coat keeps its own normal: bumps below it do not move its highlight.
TEST(Brdf, TheCoatHasANormalOfItsOwn) {
    ShadedPoint point;
    point.base = Vec3d(0.0), point.specular = 0.0;
    point.clearcoat = 1.0, point.clearcoat_roughness = 0.1;
    const Vec3d smooth(0.0, 0.0, 1.0), bumped = glm::normalize(Vec3d(0.4, 0.0, 1.0));
    const Vec3d v = view_at(0.9), mirrored(-v.x, 0.0, v.z);
    point.coat_normal = smooth;
    EXPECT_GT(reflected(point, bumped, v, mirrored).x, 1.0);
    point.coat_normal = Vec3d(0.0);
    EXPECT_LT(reflected(point, bumped, v, mirrored).x, 0.1);
}

TEST(Brdf, GivesNumbersWhereverTheViewIs) {
    ShadedPoint point;
    point.clearcoat = 1.0, point.sheen = Vec3d(1.0), point.transmission = 0.5;
    point.roughness = 0.0, point.sheen_roughness = 0.0;
    const PrefilteredLight light = prefilter(white_room(), 16);
    const Vec3d n(0.0, 0.0, 1.0);
    for (const Vec3d& v : {Vec3d(1.0, 0.0, 0.0), Vec3d(0.0, 0.0, -1.0), n, view_at(1e-9)})
        for (const Vec3d& l : {Vec3d(1.0, 0.0, 0.0), -v, v, n, -n}) {
            EXPECT_TRUE(std::isfinite(reflected(point, n, v, l).x));
            EXPECT_TRUE(std::isfinite(ambient_shading(point, n, v, light).x));
        }
}

}  // namespace
}  // namespace burl
