// Picks against every triangle in turn, in the plainest arithmetic.
#include "app/scene/surface_pick.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "app/gl/draw/view_scene.h"
#include "app/pipeline/pipeline.h"
#include "tests/app/support/sample_scene.h"

namespace burl {
namespace {

class Numbers {
  public:
    double operator()(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    Vec3d point(double side) {
        return {(*this)(-side, side), (*this)(-side, side), (*this)(-side, side)};
    }

  private:
    std::mt19937 engine_{7};
};

Surface random_triangles(std::uint32_t count, Numbers& numbers) {
    Surface surface;
    for (std::uint32_t t = 0; t < count; ++t) {
        const Vec3d middle = numbers.point(1.0);
        const Vec2d place(numbers(0, 1), numbers(0, 1));
        for (int k = 0; k < 3; ++k) {
            surface.positions.push_back(middle + numbers.point(0.2));
            surface.uvs.push_back(place + Vec2d(numbers(-0.09, 0.09), numbers(-0.09, 0.09)));
        }
        surface.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    return surface;
}

/// Depth at which a ray meets the triangle, by solving for it (Cramer's rule).
double depth(const Ray& ray, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const Mat3d equations(a - b, a - c, ray.direction);
    const Vec3d solution = glm::inverse(equations) * (a - ray.origin);
    const bool inside =
        solution.x >= 0 && solution.y >= 0 && solution.x + solution.y <= 1 && solution.z >= 0;
    return inside ? solution.z : std::numeric_limits<double>::infinity();
}

struct Expected {
    double depth = std::numeric_limits<double>::infinity();
    std::uint32_t surface = 0, triangle = 0, placement = 0;
};

Expected search_all(const Scene& scene, const Ray& ray) {
    Expected best;
    for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
        const Surface& surface = scene.surfaces[s];
        for (std::uint32_t k = 0; k < surface.placements.size(); ++k)
            for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
                std::array<Vec3d, 3> p;
                for (std::size_t i = 0; i < 3; ++i)
                    p[i] = surface.placements[k] *
                           Vec4d(surface.positions[surface.triangles[t][i]], 1.0);
                const double d = depth(ray, p[0], p[1], p[2]);
                if (d < best.depth) best = {d, s, t, k};
            }
    }
    return best;
}

Vec3d mixed(const Surface& surface, const SurfaceHit& hit) {
    Vec3d sum(0.0);
    for (int i = 0; i < 3; ++i)
        sum += hit.weights[i] * surface.positions[surface.triangles[hit.triangle][std::size_t(i)]];
    return sum;
}

TEST(SurfacePick, RaysMeetWhatASearchOfAllTrianglesFinds) {
    Numbers numbers;
    auto scene = std::make_shared<Scene>();
    scene->surfaces = {random_triangles(150, numbers), random_triangles(70, numbers)};
    scene->surfaces[1].placements = {placement(30, {1, 2, 0.5}, {0.5, 0, 0}),
                                     placement(-70, {0.7, 0.7, 0.7}, {0, 1, -1})};
    const SurfacePick pick(scene);
    int met = 0, second = 0;
    for (int i = 0; i < 700; ++i) {
        const Vec3d origin = 4.0 * glm::normalize(numbers.point(1.0));
        const Ray ray{origin, 0.3 * (numbers.point(1.0) - origin)};
        const Expected expected = search_all(*scene, ray);
        const auto hit = pick.meet(ray);
        ASSERT_EQ(hit.has_value(), std::isfinite(expected.depth)) << i;
        if (!hit) continue;
        ++met;
        second += hit->placement == 1;
        EXPECT_EQ(hit->surface, expected.surface);
        EXPECT_EQ(hit->triangle, expected.triangle);
        EXPECT_EQ(hit->placement, expected.placement);
        EXPECT_NEAR(hit->depth, expected.depth, 1e-12);
        EXPECT_LT(glm::distance(hit->point, ray.at(expected.depth)), 1e-12);
        const Surface& surface = scene->surfaces[hit->surface];
        const Vec3d local = mixed(surface, *hit);
        EXPECT_LT(glm::distance(hit->mesh_point, Vec3d(surface.placements[0] * Vec4d(local, 1.0))),
                  1e-12);
    }
    EXPECT_GT(met, 100);
    EXPECT_GT(second, 10);
}

TEST(SurfacePick, NoRaySlipsThroughEdgesAndCorners) {
    const Mesh mesh = sphere_mesh(12, 17);
    const SurfacePick pick(std::make_shared<Scene>(scene_from_mesh(mesh, {})));
    Numbers numbers;
    for (const Triangle& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3d a = mesh.positions[t[k]], b = mesh.positions[t[(k + 1) % 3]];
            const Vec3d origin = numbers.point(0.4);
            EXPECT_TRUE(pick.meet({origin, a - origin}));
            EXPECT_TRUE(pick.meet({origin, glm::mix(a, b, numbers(0, 1)) - origin}));
        }
}

TEST(SurfacePick, OnlyBetweenTheRaysEnds) {
    const SurfacePick pick(std::make_shared<Scene>(scene_from_mesh(cube_mesh(), {})));
    Ray ray{{0.2, 0.3, 5.0}, {0.0, 0.0, -2.0}};
    EXPECT_DOUBLE_EQ(pick.meet(ray)->depth, 2.0);
    ray.begin = 2.5;
    EXPECT_DOUBLE_EQ(pick.meet(ray)->depth, 3.0);
    ray.end = 2.9;
    EXPECT_FALSE(pick.meet(ray));
}

TEST(SurfacePick, OfTwoAtOneDepthTheFirstInOrder) {
    Mesh mesh = cube_mesh();
    const std::size_t count = mesh.triangles.size();
    for (std::size_t t = 0; t < count; ++t) mesh.triangles.push_back(mesh.triangles[t]);
    add_whole_part(mesh);
    const SurfacePick pick(std::make_shared<Scene>(scene_from_mesh(mesh, {})));
    Numbers numbers;
    for (int i = 0; i < 50; ++i)
        EXPECT_LT(pick.meet({Vec3d(0.0), numbers.point(1.0)})->triangle, count);
}

TEST(SurfacePick, TexelsFindTheTriangleThatShowsThem) {
    Numbers numbers;
    auto scene = std::make_shared<Scene>();
    scene->surfaces = {random_triangles(200, numbers)};
    const Surface& surface = scene->surfaces[0];
    const SurfacePick pick(scene);
    int found = 0;
    for (int i = 0; i < 250; ++i) {
        const Vec2d uv(numbers(0, 1), numbers(0, 1));
        std::uint32_t expected = 0;
        for (; expected < 200; ++expected) {
            const auto& [a, b, c] = surface.triangles[expected];
            const Mat3d corners(Vec3d(surface.uvs[a], 1), Vec3d(surface.uvs[b], 1),
                                Vec3d(surface.uvs[c], 1));
            if (glm::all(glm::greaterThanEqual(glm::inverse(corners) * Vec3d(uv, 1), Vec3d(0))))
                break;
        }
        const auto hit = pick.at(uv);
        ASSERT_EQ(hit.has_value(), expected < 200) << i;
        if (!hit) continue;
        ++found;
        EXPECT_EQ(hit->triangle, expected);
        EXPECT_LT(glm::distance(hit->uv, uv), 1e-12);
        EXPECT_LT(glm::distance(hit->point, mixed(surface, *hit)), 1e-12);
    }
    EXPECT_GT(found, 80);
    EXPECT_LT(found, 250);
}

TEST(SurfacePick, GuttersBelongToTheNearestTriangleInReach) {
    auto scene = std::make_shared<Scene>();
    Surface surface;
    surface.positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    surface.uvs = {{0.2, 0.2}, {0.6, 0.2}, {0.2, 0.6}};
    surface.triangles = {{0, 1, 2}};
    scene->surfaces = {surface};
    const SurfacePick pick(scene);
    EXPECT_FALSE(pick.at({0.3, 0.17}));
    EXPECT_FALSE(pick.at({0.3, 0.17}, 0.029));
    const auto hit = pick.at({0.3, 0.17}, 0.031);
    ASSERT_TRUE(hit);
    EXPECT_LT(glm::distance(hit->uv, Vec2d(0.3, 0.2)), 1e-12);
    EXPECT_LT(glm::distance(hit->point, Vec3d(1, 0, 0)), 1e-12);
    EXPECT_LT(glm::distance(pick.at({0.5, 0.5}, 0.5)->point, Vec3d(2, 2, 0)), 1e-12);
}

TEST(SurfacePick, BakedScenesGiveTheMeshsOwnPoints) {
    const Mesh mesh = cube_mesh({1000.0, 20.0, -3.0});
    Pipeline pipeline(mesh);
    Recipe recipe;
    recipe.atlas.size = 64;
    pipeline.set_recipe(recipe);
    const SurfacePick pick(std::make_shared<Scene>(baked_scene(pipeline)));
    const auto hit = pick.meet({{1000.25, 20.5, 9.0}, {0.0, 0.0, -1.0}});
    ASSERT_TRUE(hit);
    EXPECT_LT(glm::distance(hit->mesh_point, Vec3d(1000.25, 20.5, -2.0)), 1e-6);
    const auto back = pick.at(hit->uv);
    ASSERT_TRUE(back);
    EXPECT_LT(glm::distance(back->mesh_point, hit->mesh_point), 1e-5);
}

TEST(Ray, GoesThroughThePixelThatItsPointsProjectTo) {
    const PictureSize size{640, 360};
    const Camera camera = orbit_camera({70, -35, 2.0}, {{3, 4, 5}, 2.0}, size);
    for (const Vec2d& pixel : {Vec2d(0.5, 0.5), Vec2d(320, 180), Vec2d(600.25, 17)}) {
        const Ray ray = ray_through(camera, size, pixel);
        for (const double t : {ray.begin, 3.0, 8.0}) {
            const Vec3d seen = project(camera, size, ray.at(t));
            EXPECT_LT(glm::distance(Vec2d(seen), pixel), 1e-9);
            EXPECT_NEAR(seen.z, t, 1e-12);
        }
    }
}

}  // namespace
}  // namespace burl
