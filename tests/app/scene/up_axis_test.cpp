// Scenes turned upright.
#include "app/scene/up_axis.h"

#include <gtest/gtest.h>

#include "app/scene/scene.h"
#include "app/surface/sample_meshes.h"
#include "atlas/base/error.h"

namespace burl {
namespace {

Vec3d unit_vector(std::string_view axis) {
    Vec3d v(0.0);
    v[axis.back() - 'x'] = axis.front() == '-' ? -1.0 : 1.0;
    return v;
}

TEST(UpAxis, TurnsTheAxisToUpWithoutAMirror) {
    for (const std::string_view axis : up_axes) {
        const Mat3d turned(upright(axis));
        EXPECT_EQ(turned * unit_vector(axis), Vec3d(0.0, 1.0, 0.0)) << axis;
        EXPECT_EQ(glm::determinant(turned), 1.0) << axis;
        EXPECT_EQ(glm::transpose(turned) * turned, Mat3d(1.0)) << axis;
    }
    EXPECT_EQ(upright("y"), Mat4d(1.0));
    EXPECT_THROW(upright("w"), Error);
}

TEST(UpAxis, ShowsTheFrontOfWhatBlenderMakes) {
    // Blender's front view looks along +y: its -y comes towards the viewer, +x is on the right.
    EXPECT_EQ(Mat3d(upright("z")) * Vec3d(0.0, -1.0, 0.0), Vec3d(0.0, 0.0, 1.0));
    EXPECT_EQ(Mat3d(upright("z")) * Vec3d(1.0, 0.0, 0.0), Vec3d(1.0, 0.0, 0.0));
}

TEST(UpAxis, TurnsPlacementsAndLeavesPoints) {
    Mesh mesh = sample_mesh("sample:cad_part");
    Scene scene = scene_from_mesh(mesh, {});
    const Mesh rest = mesh;
    turn(mesh, upright("z"));
    turn(scene, upright("z"));
    EXPECT_EQ(mesh.positions, rest.positions);
    for (std::size_t i = 0; i < rest.parts.size(); ++i)
        EXPECT_EQ(mesh.parts[i].instances[0], upright("z"));
    for (const Surface& surface : scene.surfaces) EXPECT_EQ(surface.placements[0], upright("z"));
    const Box3 box = bounding_box(rest);
    const Sphere sphere = bounding_sphere(mesh);
    EXPECT_EQ(sphere.centre.y, box.centre().z);
    EXPECT_EQ(bounding_sphere(scene).centre, sphere.centre);
}

}  // namespace
}  // namespace burl
