// The table of what surfaces reflect, against sums of the functions themselves, which are written
// here once more from their papers.
#include "app/light/reflectance.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "app/light/microfacets.h"
#include "atlas/base/random_unit.h"

namespace burl {
namespace {

using std::numbers::pi;

/// Walter et al. 2007, equation 33, in tangents.
double ggx_by_tangent(double angle, double alpha) {
    const double t = std::tan(angle), c = std::cos(angle);
    return alpha * alpha / (pi * std::pow(c, 4.0) * std::pow(alpha * alpha + t * t, 2.0));
}

double smith_lambda(double cosine, double alpha) {
    const double t2 = 1.0 / (cosine * cosine) - 1.0;
    return 0.5 * (std::sqrt(1.0 + alpha * alpha * t2) - 1.0);
}

TEST(Microfacets, ProjectedAreasSumToOne) {
    for (const double roughness : {0.1, 0.3, 0.6, 1.0}) {
        const double alpha = alpha_of(roughness);
        double sum = 0.0;
        constexpr int count = 20000;
        for (int i = 0; i < count; ++i) {
            const double angle = 0.5 * pi * (i + 0.5) / count;
            EXPECT_NEAR(ggx(std::cos(angle), alpha), ggx_by_tangent(angle, alpha),
                        1e-6 * ggx_by_tangent(angle, alpha));
            sum += ggx(std::cos(angle), alpha) * std::cos(angle) * std::sin(angle);
        }
        EXPECT_NEAR(sum * 2.0 * pi * 0.5 * pi / count, 1.0, 1e-4) << roughness;
    }
}

TEST(Microfacets, MaskingIsSmithsCorrelatedForm) {
    for (const double alpha : {0.01, 0.2, 1.0})
        for (const double nl : {0.05, 0.4, 1.0})
            for (const double nv : {0.1, 0.7, 1.0}) {
                const double g = 1.0 / (1.0 + smith_lambda(nl, alpha) + smith_lambda(nv, alpha));
                EXPECT_NEAR(visibility(nl, nv, alpha), g / (4.0 * nl * nv), 1e-9 * g / (nl * nv));
                EXPECT_NEAR(masking(nv, alpha), 1.0 / (1.0 + smith_lambda(nv, alpha)), 1e-12);
            }
}

/// Scale and bias of F0 by 10^5 microfacets drawn from their density.
Vec2d sums_by_density(double nv, double alpha) {
    const Vec3d view(std::sqrt(1.0 - nv * nv), 0.0, nv);
    Vec2d sum(0.0);
    constexpr std::uint64_t count = 100'000;
    for (std::uint64_t i = 0; i < count; ++i) {
        const double u = (double(i) + 0.5) / count, turn = 2.0 * pi * random_unit(7, i);
        const double angle = std::atan(alpha * std::sqrt(u / (1.0 - u)));
        const Vec3d h(std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn),
                      std::cos(angle));
        const double vh = glm::dot(view, h), nl = 2.0 * vh * h.z - nv;
        if (vh <= 0.0 || nl <= 0.0) continue;
        const double g = 1.0 / (1.0 + smith_lambda(nl, alpha) + smith_lambda(nv, alpha));
        const double passed = g * vh / (h.z * nv), grazing = std::pow(1.0 - vh, 5.0);
        sum += passed * Vec2d(1.0 - grazing, grazing);
    }
    return sum / double(count);
}

TEST(Reflectance, EqualsTheSumOverTenToTheFiveMicrofacets) {
    const Image<Vec3f>& table = reflectance_table();
    for (const std::size_t y : {4u, 12u, 25u, 40u, 63u})
        for (const std::size_t x : {3u, 10u, 30u, 50u, 63u}) {
            const double nv = double(x) / 63.0, roughness = double(y) / 63.0;
            const Vec2d sum = sums_by_density(nv, roughness * roughness);
            EXPECT_NEAR(double(table(x, y).x), sum.x, 0.004) << nv << " " << roughness;
            EXPECT_NEAR(double(table(x, y).y), sum.y, 0.004) << nv << " " << roughness;
        }
}

TEST(Reflectance, SheenEqualsTheSumOverDirections) {
    const Image<Vec3f>& table = reflectance_table();
    for (const std::size_t y : {12u, 25u, 40u, 63u})
        for (const std::size_t x : {3u, 20u, 50u}) {
            const double nv = double(x) / 63.0, roughness = double(y) / 63.0;
            const double alpha = sheen_alpha(roughness);
            const Vec3d view(std::sqrt(1.0 - nv * nv), 0.0, nv);
            double sum = 0.0;
            constexpr int count = 100'000;
            for (int i = 0; i < count; ++i) {  // even over the hemisphere
                const double nl = (i + 0.5) / count, out = std::sqrt(1.0 - nl * nl);
                const double turn = 2.399963229728653 * i;
                const Vec3d l(out * std::cos(turn), out * std::sin(turn), nl);
                sum += charlie(glm::normalize(l + view).z, alpha) *
                       charlie_visibility(nl, nv, alpha) * nl;
            }
            EXPECT_NEAR(double(table(x, y).z), std::min(1.0, sum * 2.0 * pi / count), 0.01)
                << nv << " " << roughness;
        }
}

TEST(Reflectance, ASmoothSurfaceReflectsBySchlick) {
    for (const double nv : {0.3, 0.6, 0.95}) {
        const Vec3d at = reflectance(nv, 0.0);
        EXPECT_NEAR(at.x, 1.0 - std::pow(1.0 - nv, 5.0), 0.003);
        EXPECT_NEAR(at.y, std::pow(1.0 - nv, 5.0), 0.003);
    }
}

TEST(Reflectance, LooksUpBetweenTexelsAndClamps) {
    const Image<Vec3f>& table = reflectance_table();
    EXPECT_EQ(reflectance(-1.0, 2.0), Vec3d(table(0, 63)));
    EXPECT_EQ(reflectance(1.0, 0.0), Vec3d(table(63, 0)));
    const Vec3d between = reflectance(19.5 / 63.0, 30.5 / 63.0);
    Vec3d mean(0.0);
    for (const std::size_t x : {19u, 20u})
        for (const std::size_t y : {30u, 31u}) mean += 0.25 * Vec3d(table(x, y));
    EXPECT_LT(glm::length(between - mean), 1e-6);
}

}  // namespace
}  // namespace burl
