#include "app/surface/mesh_frame.h"

#include <cmath>

#include <fmt/format.h>

#include "atlas/base/error.h"
#include "atlas/file/text_scanner.h"
#include "procedural/numbers/rotation.h"

namespace burl {

namespace {

/// The map whose rows say which coordinates become x, y and z.
Mat4d rows(const Vec3d& x, const Vec3d& y, const Vec3d& z) {
    return Mat4d(glm::transpose(Mat3d(x, y, z)));
}

bool is_quarter_turns(const Vec3d& degrees) {
    return glm::all(glm::equal(glm::mod(degrees, 90.0), Vec3d(0.0)));
}

/// rotation_about_axes(), with entries of -1, 0 and 1 for quarter turns.
Mat3d exact_rotation(const Vec3d& degrees) {
    Mat3d rotation = rotation_about_axes(degrees);
    if (is_quarter_turns(degrees))
        for (int column = 0; column < 3; ++column) rotation[column] = glm::round(rotation[column]);
    return rotation;
}

double units_of_a_metre(const MeshFrame& frame) {
    const LengthUnit unit = frame.units.value_or(LengthUnit::m);
    return unit == LengthUnit::mm ? 1000.0 : unit == LengthUnit::cm ? 100.0 : 1.0;
}

/// The frame's rotation times its scale.
Mat3d turned_and_scaled(const MeshFrame& frame) {
    return frame.scale * (exact_rotation(frame.rotate) * Mat3d(upright(frame.up)));
}

void turn_normals(std::vector<Vec3f>& normals, const Mat3d& map) {
    const double factor = std::cbrt(glm::determinant(map));
    for (Vec3f& normal : normals) normal = Vec3f(map * Vec3d(normal) / factor);
}

void frame_points(std::vector<Vec3d>& points, const MeshFrame& frame, const std::string& name) {
    const FramePoints framed_point(frame);
    for (Vec3d& p : points) {
        p = framed_point(p);
        if (glm::any(glm::greaterThan(glm::abs(p), Vec3d(largest_coordinate))))
            throw invalid_file(name, 0,
                               fmt::format("a coordinate is beyond {:g} once the mesh is scaled",
                                           largest_coordinate));
    }
}

}  // namespace

Mat4d upright(std::string_view axis) {
    const Vec3d x(1.0, 0.0, 0.0), y(0.0, 1.0, 0.0), z(0.0, 0.0, 1.0);
    if (axis == "x") return rows(-y, x, z);
    if (axis == "-x") return rows(y, -x, z);
    if (axis == "y") return rows(x, y, z);
    if (axis == "-y") return rows(x, -y, -z);
    if (axis == "z") return rows(x, z, -y);
    if (axis == "-z") return rows(x, -z, y);
    throw Error(ExitCode::usage,
                fmt::format("--up {}: it must be one of {}", axis, fmt::join(up_axes, ", ")));
}

Mat4d frame_transform(const MeshFrame& frame) {
    return Mat4d(turned_and_scaled(frame) / units_of_a_metre(frame));
}

FramePoints::FramePoints(const MeshFrame& frame)
    : map_(turned_and_scaled(frame)), divisor_(units_of_a_metre(frame)) {}

Mesh framed(Mesh mesh, const MeshFrame& frame) {
    const Mat4d map = frame_transform(frame);
    if (map == Mat4d(1.0)) return mesh;
    frame_points(mesh.positions, frame, mesh.name);
    turn_normals(mesh.corners.normals, Mat3d(map));
    const Mat4d back = glm::inverse(map);
    for (Part& part : mesh.parts)
        for (std::size_t i = 1; i < part.instances.size(); ++i)
            part.instances[i] = map * part.instances[i] * back;
    return mesh;
}

MeshPose framed(MeshPose pose, const MeshFrame& frame) {
    const Mat4d map = frame_transform(frame);
    if (map == Mat4d(1.0)) return pose;
    frame_points(pose.positions, frame, pose.name);
    turn_normals(pose.normals, Mat3d(map));
    return pose;
}

}  // namespace burl
