// Light of sky and sun against closed forms: half spaces, a sphere, walls that lean, the shadow of
// an edge; and through walls as thin as a hundred thousandth of the mesh.
#include "atlas/shape/light.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "tests/atlas/support/made_shapes.h"

namespace burl {
namespace {

using Points = std::vector<ShapePoint>;

std::vector<float> lit_by_sky(const ShapeScene& shape, const Points& points, const Vec3d& up,
                              SkyHalf half, const OcclusionOptions& options = {}) {
    std::vector<float> values(points.size(), -1.0f);
    sky_light(shape, points, up, half, options, values);
    return values;
}

std::vector<float> lit_by_sun(const ShapeScene& shape, const Points& points,
                              const SunOptions& options) {
    std::vector<float> values(points.size(), -1.0f);
    sun_light(shape, points, options, values);
    return values;
}

const Vec3d above(0, 0, 1);

/// A floor of side 2 about the origin that faces z.
Mesh small_floor() {
    return made::sheet({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
}

TEST(SkyLight, OnAPlaneIsTheHalvesShare) {
    const ShapeScene shape(small_floor());
    const Points points = made::middles(shape);
    EXPECT_EQ(lit_by_sky(shape, points, above, SkyHalf::upper)[0], 1.0f);
    EXPECT_EQ(lit_by_sky(shape, points, above, SkyHalf::lower)[0], 0.0f);
    EXPECT_EQ(lit_by_sky(shape, points, -above, SkyHalf::lower)[1], 1.0f);
    for (const double angle : {0.3, 1.2, 0.5 * std::numbers::pi, 2.5}) {
        const Vec3d up(std::sin(angle), 0.0, std::cos(angle));
        const double share = (1.0 + std::cos(angle)) / 2.0;
        EXPECT_NEAR(lit_by_sky(shape, points, up, SkyHalf::upper, {4096})[0], share, 0.004);
        EXPECT_NEAR(lit_by_sky(shape, points, up, SkyHalf::lower, {4096})[0], 1.0 - share, 0.004);
    }
}

TEST(SkyLight, OnASphereIsMixedByTheHeightOfItsNormal) {
    const Mesh ball = made::ball(4);
    const ShapeScene shape(ball);
    const Points points = made::middles(shape);
    const Vec3d up(0.48, 0.64, 0.6);
    const auto sky = lit_by_sky(shape, points, up, SkyHalf::upper, {1024});
    for (std::size_t i = 0; i < points.size(); ++i)
        ASSERT_NEAR(sky[i], (1.0 + glm::dot(points[i].normal, up)) / 2.0, 0.015);
}

TEST(SkyLight, HalvesMakeOcclusion) {
    const ShapeScene shape(made::torus(1.0, 0.45, 40, 20));
    const Points points = made::middles(shape);
    const OcclusionOptions options{100, 0.8};
    std::vector<float> open(points.size());
    occlusion(shape, points, options, open);
    for (const Vec3d& up : {above, Vec3d(0.6, 0.0, -0.8), Vec3d(0.0)}) {
        const auto upper = lit_by_sky(shape, points, up, SkyHalf::upper, options);
        const auto lower = lit_by_sky(shape, points, up, SkyHalf::lower, options);
        for (std::size_t i = 0; i < points.size(); ++i)
            ASSERT_NEAR(upper[i] + lower[i], open[i], 1e-6);
        if (up == Vec3d(0.0)) {
            EXPECT_EQ(upper, open);
        }
    }
}

TEST(SkyLight, BesideAWallThatLeans) {
    // A wall without end at this angle to the floor leaves (1 - cos(angle)) / 2 of the sky. Where
    // it stands upright, nothing of what is left lies on its side.
    const Mesh floor = made::sheet({-4, -4, 0}, {4, 0, 0}, {0, 8, 0});
    for (const double angle : {0.5, 1.0, 0.5 * std::numbers::pi, 2.0}) {
        const Vec3d wall(-std::cos(angle), 0.0, std::sin(angle));
        const ShapeScene shape(
            made::both(floor, made::sheet({0, 2000, 0}, {0, -4000, 0}, 2000.0 * wall)));
        const Points points{made::point_at(shape, 1, {-1.0, 0.5, 0})};
        EXPECT_NEAR(lit_by_sky(shape, points, above, SkyHalf::upper, {8192})[0],
                    (1.0 - std::cos(angle)) / 2.0, 0.004);
        if (wall.z < 1.0) continue;
        EXPECT_NEAR(lit_by_sky(shape, points, {1, 0, 0}, SkyHalf::upper, {8192})[0], 0.0, 0.002);
        EXPECT_NEAR(lit_by_sky(shape, points, {1, 0, 0}, SkyHalf::lower, {8192})[0], 0.5, 0.004);
        // Beyond the rays' length the wall hides nothing.
        EXPECT_EQ(lit_by_sky(shape, points, above, SkyHalf::upper, {512, 0.9})[0], 1.0f);
    }
}

TEST(SunLight, OnAPlaneIsTheCosine) {
    const ShapeScene shape(small_floor());
    const Points points = made::middles(shape);
    for (const double angle : {0.0, 0.4, 1.1, 1.5}) {
        const Vec3d sun(std::sin(angle), 0.0, std::cos(angle));
        for (const float v : lit_by_sun(shape, points, {sun}))
            EXPECT_NEAR(v, std::cos(angle), 1e-6);
        for (const float v : lit_by_sun(shape, points, {-sun, 0.1})) EXPECT_LT(v, 0.01);
    }
    EXPECT_EQ(lit_by_sun(shape, points, {-above})[0], 0.0f);
}

TEST(SunLight, OfADiscIsTheMeanOfItsCosines) {
    // The mean of all directions within a cone of radius a is (1 + cos a) / 2 times its axis.
    const ShapeScene shape(small_floor());
    const Points points = made::middles(shape);
    for (const double radius : {0.01, 0.2, 0.7})
        for (const double angle : {0.0, 0.3, 0.8}) {
            const Vec3d sun(0.0, std::sin(angle), std::cos(angle));
            EXPECT_NEAR(lit_by_sun(shape, points, {sun, radius})[0],
                        std::cos(angle) * (1.0 + std::cos(radius)) / 2.0, 0.04 * radius)
                << radius << " " << angle;
        }
    const auto half_set = lit_by_sun(shape, points, {{1, 0, 0}, 0.5});
    EXPECT_GT(half_set[0], 0.08f);  // half of the disc stands above the horizon
    EXPECT_LT(half_set[0], 0.13f);
}

TEST(SunLight, UsesTheNormalOfShadingAboveTheTriangleOnly) {
    Mesh mesh = small_floor();
    mesh.corners.normals.assign(6, Vec3f(0.6f, 0.0f, 0.8f));
    const ShapeScene shape(mesh);
    const Points points = made::middles(shape);
    EXPECT_NEAR(lit_by_sun(shape, points, {{0.8, 0.0, 0.6}})[0], 0.96, 1e-6);
    EXPECT_EQ(lit_by_sun(shape, points, {{1.0, 0.0, 0.0}})[0], 0.0f);  // below the triangle
    EXPECT_EQ(lit_by_sun(shape, points, {{-0.96, 0.0, 0.28}})[0], 0.0f);
}

/// A floor, and half of a plane over it from x = 0 on, at height 1.
Mesh floor_below_an_edge() {
    return made::both(made::sheet({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}),
                      made::sheet({0, -40, 1}, {40, 0, 0}, {0, 80, 0}));
}

/// The light of the floor at (x, 0), of a sun above.
float below_edge(const ShapeScene& shape, double x, double radius) {
    const std::uint32_t triangle = x > 0.0 ? 1 : 0;
    const Points points{made::point_at(shape, triangle, {x, x > 0.0 ? 0.01 : -0.01, 0})};
    return lit_by_sun(shape, points, {above, radius})[0];
}

TEST(SunLight, HasUmbraAndPenumbraOfAnEdge) {
    const ShapeScene shape(floor_below_an_edge());
    EXPECT_EQ(below_edge(shape, 1e-3, 0.0), 0.0f);
    EXPECT_EQ(below_edge(shape, -1e-3, 0.0), 1.0f);
    const double radius = 0.1, reach = std::tan(radius);
    const double whole = (1.0 + std::cos(radius)) / 2.0;
    EXPECT_EQ(below_edge(shape, 1.01 * reach, radius), 0.0f);
    EXPECT_NEAR(below_edge(shape, -1.01 * reach, radius), whole, 1e-4);
    for (const double t : {-0.8, -0.5, -0.2, 0.2, 0.5, 0.8}) {
        // The segment of a disc of radius 1 that lies beyond a line at distance t of its middle.
        const double shows = (std::acos(t) - t * std::sqrt(1.0 - t * t)) / std::numbers::pi;
        EXPECT_NEAR(below_edge(shape, t * reach, radius), whole * shows, 0.08) << t;
    }
}

TEST(SunLight, DoesNotLeakIntoABoxUpToItsCorners) {
    for (const double height : {1.0, 1e-4}) {
        const ShapeScene shape(made::turned_inside_out(made::cuboid({0, 0, 0}, {1, 2, height})));
        Points points = made::middles(shape);
        for (std::uint32_t t = 0; t < 12; ++t)
            for (int i = 0; i < 30; ++i) {
                const double along = i / 30.0;
                points.push_back(shape.surface_point(t, {1.0 - along, along, 0.0}));
                points.push_back(shape.surface_point(t, {along, 0.0, 1.0 - along}));
            }
        for (const Vec3d& sun : {above, Vec3d(0.36, 0.48, 0.8), Vec3d(-0.8, 0.6, 0.0)}) {
            for (const float v : lit_by_sun(shape, points, {sun})) ASSERT_EQ(v, 0.0f);
            for (const float v : lit_by_sun(shape, points, {sun, 0.3})) ASSERT_EQ(v, 0.0f);
            for (const float v : lit_by_sky(shape, points, sun, SkyHalf::upper)) ASSERT_EQ(v, 0.0f);
        }
    }
}

TEST(SunLight, DoesNotLeakBetweenPlates) {
    for (const double gap : {1e-3, 1e-4, 1e-5}) {
        const ShapeScene shape(made::both(made::sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0}),
                                          made::sheet({0, 0, gap}, {0, 1, 0}, {1, 0, 0})));
        const Points points = made::middles(shape);
        for (const Vec3d& sun : {above, Vec3d(0.6, 0.0, 0.8)})
            for (const float v : lit_by_sun(shape, points, {sun})) EXPECT_EQ(v, 0.0f);
    }
}

TEST(Light, ThreadsDoNotMatter) {
    const Mesh mesh = made::torus(1.0, 0.45, 60, 30);
    const auto with_threads = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        const ShapeScene shape(mesh);
        const Points points = made::middles(shape);
        return std::pair(lit_by_sky(shape, points, above, SkyHalf::lower),
                         lit_by_sun(shape, points, {Vec3d(0.8, 0.0, 0.6), 0.05}));
    };
    EXPECT_EQ(with_threads(1), with_threads(4));
}

TEST(Light, TrianglesWithoutAreaHaveHalfOfTheSkyAndNoSun) {
    for (const Mesh& mesh :
         {made::nasty(), made::mesh_of({{1, 1, 1}}, {{0, 0, 0}}),
          made::mesh_of({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}, {0, 0, 1}}), Mesh{}}) {
        const ShapeScene shape(mesh);
        const Points points = made::middles(shape);
        const auto sky = lit_by_sky(shape, points, above, SkyHalf::upper);
        const auto sun = lit_by_sun(shape, points, {above, 0.1});
        for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_TRUE(sky[i] >= 0.0f && sky[i] <= 1.0f && sun[i] >= 0.0f && sun[i] <= 1.0f);
            if (shape.areas()[i] > 0.0) continue;
            EXPECT_EQ(sky[i], 0.5f);
            EXPECT_EQ(sun[i], 0.0f);
        }
    }
}

}  // namespace
}  // namespace burl
