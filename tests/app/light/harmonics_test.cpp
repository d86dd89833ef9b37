// Diffuse light against what is known of cosine lobes, and against sums over all pixels.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "app/light/harmonics.h"
#include "app/light/prefilter.h"

namespace burl {
namespace {

using std::numbers::pi;

Environment sphere_of(double (*light)(const Vec3d&)) {
    constexpr std::size_t height = 128;
    Environment made{Image<RgbF>(2 * height, height)};
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < 2 * height; ++x) {
            const auto c = float(light(
                direction_at({(double(x) + 0.5) / (2.0 * height), (double(y) + 0.5) / height})));
            made.radiance(x, y) = {c, c, c};
        }
    return made;
}

double diffuse_at(const Environment& e, const Vec3d& normal) {
    return diffuse_light({{}, diffuse_harmonics(e), {}}, glm::normalize(normal)).y;
}

const Vec3d normals[] = {{1.0, 0.0, 0.0},  {0.0, 1.0, 0.0},   {0.0, 0.0, 1.0},
                         {1.0, 2.0, -3.0}, {-2.0, -1.0, 0.5}, {0.3, -0.2, -0.9}};

/// A light of harmonics of one degree is scaled by A_l / pi: 1, 2/3, 1/4 (Ramamoorthi and Hanrahan
/// 2001, equation 9).
TEST(Harmonics, ScaleEveryDegreeAsACosineLobeDoes) {
    for (const Vec3d& v : normals) {
        const Vec3d n = glm::normalize(v);
        EXPECT_NEAR(diffuse_at(sphere_of([](const Vec3d&) { return 2.0; }), n), 2.0, 1e-3);
        const auto linear =
            sphere_of([](const Vec3d& d) { return 2.0 + d.x - 0.5 * d.y + 0.2 * d.z; });
        EXPECT_NEAR(diffuse_at(linear, n), 2.0 + (n.x - 0.5 * n.y + 0.2 * n.z) * 2.0 / 3.0, 1e-3);
        const auto square = sphere_of([](const Vec3d& d) {
            return 3.0 + d.x * d.y - d.y * d.z + 0.7 * d.x * d.z + 0.5 * (3.0 * d.z * d.z - 1.0) +
                   0.3 * (d.x * d.x - d.y * d.y);
        });
        const double degree2 = n.x * n.y - n.y * n.z + 0.7 * n.x * n.z +
                               0.5 * (3.0 * n.z * n.z - 1.0) + 0.3 * (n.x * n.x - n.y * n.y);
        EXPECT_NEAR(diffuse_at(square, n), 3.0 + 0.25 * degree2, 1e-3);
    }
}

/// Degrees 3 and more are lost, which of a half sky of light is 3 % at most.
TEST(Harmonics, ComeNearTheSumOverAllPixels) {
    const Environment e = sphere_of([](const Vec3d& d) { return d.y > 0.0 ? 1.0 : 0.1; });
    for (const Vec3d& v : normals) {
        const Vec3d n = glm::normalize(v);
        double sum = 0.0;
        for (std::size_t y = 0; y < 128; ++y)
            for (std::size_t x = 0; x < 256; ++x) {
                const Vec2d uv((double(x) + 0.5) / 256.0, (double(y) + 0.5) / 128.0);
                sum += double(e.radiance(x, y).r) * std::max(0.0, glm::dot(direction_at(uv), n)) *
                       std::sin(pi * uv.y) * 2.0 * pi * pi / (256.0 * 128.0);
            }
        EXPECT_NEAR(diffuse_at(e, n), sum / pi, 0.03);
    }
}

TEST(Harmonics, AreNeverNegative) {
    const Environment sun = sphere_of([](const Vec3d& d) { return d.y > 0.995 ? 500.0 : 0.0; });
    for (double a = 0.0; a < pi; a += 0.05)
        EXPECT_GE(diffuse_at(sun, {std::sin(a), std::cos(a), 0.0}), 0.0);
}

}  // namespace
}  // namespace burl
