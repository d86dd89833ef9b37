// Prefiltered light against sums over all pixels of the map.
#include "app/light/prefilter.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "app/light/cube_map.h"
#include "app/light/glints.h"
#include "app/light/padded_cube.h"

namespace burl {
namespace {

using std::numbers::pi;

/// The mean of light over a GGX lobe seen along the normal, weighted by density times n.l.
Vec3d lobe_mean(const Environment& e, const Vec3d& normal, double roughness) {
    const double a2 = std::pow(roughness, 4.0);
    const double width = double(e.radiance.width()), height = double(e.radiance.height());
    Vec3d sum(0.0);
    double weights = 0.0;
    for (std::size_t y = 0; y < e.radiance.height(); ++y)
        for (std::size_t x = 0; x < e.radiance.width(); ++x) {
            const Vec2d uv((double(x) + 0.5) / width, (double(y) + 0.5) / height);
            const Vec3d d = direction_at(uv);
            const double nl = glm::dot(d, normal);
            if (nl <= 0.0) continue;
            const double h2 = 0.5 + 0.5 * nl;  // squared cosine of half the angle
            const double density = a2 / std::pow(h2 * (a2 - 1.0) + 1.0, 2.0);
            const double weight = density * nl * std::sin(pi * uv.y);
            const RgbF& p = e.radiance(x, y);
            sum += weight * Vec3d(double(p.r), double(p.g), double(p.b));
            weights += weight;
        }
    return sum / weights;
}

const Vec3d seen[] = {{0.0, 1.0, 0.0},   {1.0, 0.0, 0.0},    {0.58, 0.57, 0.58},
                      {-0.6, 0.5, 0.62}, {0.71, 0.02, 0.70}, {0.1, -0.9, -0.4}};

TEST(CubeMap, DirectionsComeBackFromTheirFaces) {
    for (const Vec3d& v : seen) {
        const CubePoint point = cube_point(3.0 * v);
        EXPECT_LT(glm::length(glm::normalize(cube_direction(point)) - glm::normalize(v)), 1e-12);
        EXPECT_TRUE(point.at.x >= 0.0 && point.at.x <= 1.0 && point.at.y >= 0.0 &&
                    point.at.y <= 1.0);
    }
}

/// The OpenGL specification's table of faces: s and t of a direction on +x are -z and -y over |x|.
TEST(CubeMap, FacesAreThoseOfOpenGl) {
    const CubePoint x = cube_point({1.0, 0.5, 0.25});
    EXPECT_EQ(x.face, 0u);
    EXPECT_EQ(x.at, Vec2d(0.5 - 0.125, 0.5 - 0.25));
    const CubePoint down = cube_point({0.5, -1.0, 0.25});
    EXPECT_EQ(down.face, 3u);
    EXPECT_EQ(down.at, Vec2d(0.5 + 0.25, 0.5 - 0.125));
    const CubePoint back = cube_point({0.5, 0.25, -1.0});
    EXPECT_EQ(back.face, 5u);
    EXPECT_EQ(back.at, Vec2d(0.5 - 0.25, 0.5 - 0.125));
}

CubeFaces smooth_faces(std::size_t side) {
    CubeFaces faces;
    for (std::size_t f = 0; f < 6; ++f) {
        faces[f] = Image<RgbF>(side, side);
        for (std::size_t y = 0; y < side; ++y)
            for (std::size_t x = 0; x < side; ++x) {
                const Vec3d d = glm::normalize(
                    cube_direction({f, Vec2d(double(x) + 0.5, double(y) + 0.5) / double(side)}));
                faces[f](x, y) = {float(d.x), float(d.y), float(d.z)};
            }
    }
    return faces;
}

TEST(CubeMap, LookupsAreContinuousOverEdgesAndCorners) {
    const CubeFaces faces = smooth_faces(32);
    const PaddedCube padded(faces);
    for (int i = 0; i < 2000; ++i) {
        const double y = 1.0 - (i + 0.5) / 1000.0, out = std::sqrt(1.0 - y * y), turn = 2.39996 * i;
        const Vec3d d(out * std::cos(turn), y, out * std::sin(turn));
        EXPECT_LT(glm::length(cube_lookup(faces, d) - d), 0.03);
        EXPECT_LT(glm::length(Vec3d(padded(Vec3f(d))) - cube_lookup(faces, d)), 1e-5);
    }
}

TEST(Prefilter, LevelsHalveAndTheFirstIsTheMap) {
    const Environment e = make_environment("neutral", 64);
    const PrefilteredLight light = prefilter(e, 64);
    ASSERT_EQ(light.glossy.size(), 4u);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(light.glossy[k][5].width(), 64u >> k);
    for (const Vec3d& v : seen)
        EXPECT_LT(glm::length(glossy_light(light, v, 0.0) - light_from(e, v)), 0.02);
}

TEST(Prefilter, GlintsAndTheRestAreTheWhole) {
    PrefilteredLight light = prefilter(make_environment("sun"), 64);
    light.glossy[0][2](20, 30) = {900.0f, 800.0f, 500.0f};
    const Glinting parts = without_glints(light.glossy[0]);
    EXPECT_GT(parts.glints.size(), 0u);
    EXPECT_LE(parts.glints.size(), 64u);
    double whole = 0.0, sum = 0.0, brightest = 0.0;
    for (const Glint& glint : parts.glints) sum += double(glint.light.y);
    for (std::size_t f = 0; f < 6; ++f)
        for (std::size_t y = 0; y < 64; ++y)
            for (std::size_t x = 0; x < 64; ++x) {
                const double length = glm::length(
                    cube_direction({f, Vec2d(double(x) + 0.5, double(y) + 0.5) / 64.0}));
                const double solid = 4.0 / (64.0 * 64.0) / std::pow(length, 3.0);
                whole += solid * double(light.glossy[0][f](x, y).g);
                sum += solid * double(parts.rest[f](x, y).g);
                brightest = std::max(brightest, double(parts.rest[f](x, y).g));
            }
    EXPECT_NEAR(sum, whole, 1e-4 * whole);
    EXPECT_LT(brightest, 32.0 * whole / (4.0 * pi));
}

void expect_lobes(const char* name, double tolerance) {
    const PrefilteredLight light = prefilter(make_environment(name, 128));
    const Environment e = without_sun(make_environment(name, 128)).sky;
    const double last = double(light.glossy.size()) - 1.0;
    for (std::size_t k = 1; k < light.glossy.size(); ++k)
        for (const Vec3d& v : seen) {
            const Vec3d truth = lobe_mean(e, glm::normalize(v), double(k) / last);
            const Vec3d made = glossy_light(light, v, double(k) / last);
            EXPECT_LT(glm::length(made - truth), tolerance * glm::length(truth) + 0.006)
                << name << " level " << k << " " << made.y << " " << truth.y;
        }
}

TEST(Prefilter, LobesEqualSumsOverAllPixels) {
    expect_lobes("neutral", 0.01);
    expect_lobes("studio", 0.05);
    expect_lobes("sun", 0.08);
}

TEST(Prefilter, IsTheSameForAnyThreads) {
    const Environment e = make_environment("sun", 32);
    const PrefilteredLight many = prefilter(e, 16);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const PrefilteredLight single = prefilter(e, 16);
    EXPECT_EQ(many.glossy, single.glossy);
    EXPECT_EQ(many.diffuse, single.diffuse);
}

}  // namespace
}  // namespace burl
