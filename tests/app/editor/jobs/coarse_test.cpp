// Coarse surfaces made beside the user interface.
#include "app/editor/jobs/coarse.h"

#include <gtest/gtest.h>

#include <atomic>

#include "tests/app/support/sample_scene.h"

namespace burl {
namespace {

Surface sphere(std::uint32_t rings) {
    const Mesh mesh = sphere_mesh(rings, 2 * rings);
    Surface surface;
    surface.positions = mesh.positions;
    surface.triangles = mesh.triangles;
    for (const Vec3d& p : mesh.positions) surface.normals.emplace_back(p);
    return surface;
}

std::shared_ptr<const EditSurface> edited(std::uint64_t number, std::vector<Surface> surfaces) {
    auto surface = std::make_shared<EditSurface>();
    surface->number = number;
    surface->scene.surfaces = std::move(surfaces);
    return surface;
}

TEST(EditCoarse, SurfacesShareTheTrianglesByHowManyTheyDraw) {
    Scene scene;
    scene.surfaces = {sphere(120), sphere(60)};
    scene.surfaces[1].placements.assign(3, Mat4d(1.0));
    const std::size_t all = drawn_triangles(scene);
    EXPECT_EQ(all, scene.surfaces[0].triangles.size() + 3 * scene.surfaces[1].triangles.size());
    Scene coarse;
    coarse.surfaces = coarse_surfaces(scene, all / 10);
    ASSERT_EQ(coarse.surfaces.size(), 2u);
    EXPECT_LE(double(drawn_triangles(coarse)), 1.25 * 0.1 * double(all));
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_GE(double(coarse.surfaces[i].triangles.size()),
                  0.03 * double(scene.surfaces[i].triangles.size()));
}

TEST(EditCoarse, LargeSurfacesHaveThemUntilAnotherIsShown) {
    std::atomic<int> woken = 0;
    EditCoarse coarse([&] { ++woken; });
    const auto small = edited(1, {sphere(20)}), large = edited(2, {sphere(180)});
    ASSERT_GT(drawn_triangles(large->scene), EditCoarse::many);
    coarse.follow(small);
    coarse.wait();
    EXPECT_FALSE(coarse.surfaces(small));
    EXPECT_EQ(woken, 0);
    coarse.follow(large);
    coarse.follow(large);
    coarse.wait();
    EXPECT_EQ(woken, 1);
    const auto made = coarse.surfaces(large);
    ASSERT_TRUE(made);
    EXPECT_LE(double(made->front().triangles.size()), 1.25 * double(EditCoarse::few));
    EXPECT_FALSE(coarse.surfaces(small)) << "they are another's";
    coarse.follow(small);
    coarse.wait();
    EXPECT_FALSE(coarse.surfaces(large));
}

}  // namespace
}  // namespace burl
