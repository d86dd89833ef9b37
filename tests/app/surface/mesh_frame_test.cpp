// Axes and units of mesh files.
#include "app/surface/mesh_frame.h"

#include <cmath>

#include <fmt/format.h>
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

/// The rotation about one axis by an angle in degrees, from its definition.
Vec3d turned(const Vec3d& p, int axis, double degrees) {
    const double angle = degrees * std::acos(-1.0) / 180.0;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    Vec3d out = p;
    out[u] = std::cos(angle) * p[u] - std::sin(angle) * p[v];
    out[v] = std::sin(angle) * p[u] + std::cos(angle) * p[v];
    return out;
}

TEST(MeshFrame, TurnsFirstUprightThenAboutXThenYThenZ) {
    const MeshFrame frame{"z", {10.0, -25.0, 70.0}, 3.0, LengthUnit::cm};
    const Vec3d p(0.3, -1.7, 2.2);
    const Vec3d upright(p.x, p.z, -p.y);
    const Vec3d expected = 0.03 * turned(turned(turned(upright, 0, 10.0), 1, -25.0), 2, 70.0);
    EXPECT_LT(glm::length(Vec3d(frame_transform(frame) * Vec4d(p, 1.0)) - expected), 1e-15);
}

TEST(MeshFrame, IsExactForQuarterTurns) {
    const Mat4d map = frame_transform({"y", {-90.0, 180.0, 270.0}, 2.0, {}});
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) {
            const double entry = std::abs(map[i][k]);
            EXPECT_TRUE(entry == 0.0 || entry == 2.0) << entry;
        }
    EXPECT_EQ(frame_transform({}), Mat4d(1.0));
}

TEST(MeshFrame, TakesPlacementsNormalsAndPosesAlong) {
    Mesh mesh = sample_mesh("sample:cad_part");
    Mat4d placement(1.0);
    placement[3] = Vec4d(5.0, -2.0, 1.0, 1.0);
    mesh.parts[0].instances.push_back(placement);
    MeshPose pose{"moved", {}, {}};
    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t p : triangle) {
            pose.positions.push_back(mesh.positions[p] + Vec3d(1.0, 0.0, 0.0));
            pose.normals.emplace_back(0.0f, 0.0f, 2.0f);
        }
    mesh.corners.normals.assign(pose.normals.size(), Vec3f(0.0f, 0.0f, 1.0f));
    const MeshFrame frame{"z", Vec3d(0.0), 1.0, LengthUnit::mm};
    const Mesh result = framed(mesh, frame);
    const MeshPose posed = framed(pose, frame);
    EXPECT_EQ(result.parts[0].instances[0], Mat4d(1.0));
    const Mat4d& moved = result.parts[0].instances[1];
    for (std::size_t p = 0; p < mesh.positions.size(); ++p) {
        const Vec3d& q = mesh.positions[p];
        EXPECT_EQ(result.positions[p], Vec3d(q.x / 1000, q.z / 1000, -q.y / 1000) + 0.0);
        const Vec3d there(moved * Vec4d(result.positions[p], 1.0));
        EXPECT_LT(glm::length(there - Vec3d(0.001 * (q.x + 5.0), 0.001 * (q.z + 1.0),
                                            -0.001 * (q.y - 2.0))),
                  1e-15);
    }
    for (const Vec3f& normal : result.corners.normals) EXPECT_EQ(normal, Vec3f(0.0f, 1.0f, 0.0f));
    for (const Vec3f& normal : posed.normals) EXPECT_EQ(normal, Vec3f(0.0f, 2.0f, 0.0f));
    const Vec3d& first = pose.positions[0];
    EXPECT_EQ(posed.positions[0], Vec3d(first.x, first.z, -first.y) / 1000.0 + 0.0);
}

TEST(MeshFrame, MakesOfWholeMillimetresAndCentimetresWhatMetresInDecimalsAre) {
    const FramePoints of_mm({"z", Vec3d(0.0), 1.0, LengthUnit::mm});
    const FramePoints of_cm({"y", {0.0, 90.0, 0.0}, 1.0, LengthUnit::cm});
    for (int i = 1; i < 20000; ++i) {
        const double mm = std::stod(fmt::format("{}.{:03}", i / 1000, i % 1000));
        EXPECT_EQ(of_mm(Vec3d(i, 0.0, -i)), Vec3d(mm, -mm, 0.0)) << i;
        const double cm = std::stod(fmt::format("{}.{:02}", i / 100, i % 100));
        EXPECT_EQ(of_cm(Vec3d(i, i, -i)), Vec3d(-cm, cm, -cm)) << i;
    }
}

TEST(MeshFrame, RefusesWhatLeavesTheRangeOfMeshes) {
    Mesh mesh = sample_mesh("sample:cad_part");
    for (Vec3d& p : mesh.positions) p *= 1e97;
    EXPECT_THROW(framed(mesh, MeshFrame{"y", Vec3d(0.0), 1e6, {}}), Error);
}

TEST(MeshFrame, TurnsScenes) {
    const Mesh mesh = sample_mesh("sample:cad_part");
    Scene scene = scene_from_mesh(mesh, {});
    turn(scene, upright("z"));
    for (const Surface& surface : scene.surfaces) EXPECT_EQ(surface.placements[0], upright("z"));
    EXPECT_EQ(bounding_sphere(scene).centre.y, bounding_box(mesh).centre().z);
}

}  // namespace
}  // namespace burl
