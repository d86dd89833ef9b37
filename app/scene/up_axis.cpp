#include "app/scene/up_axis.h"

#include <fmt/format.h>

#include "app/scene/scene.h"
#include "atlas/base/error.h"
#include "atlas/mesh/mesh.h"

namespace burl {

namespace {

/// The map whose rows say which coordinates become x, y and z.
Mat4d rows(const Vec3d& x, const Vec3d& y, const Vec3d& z) {
    return Mat4d(glm::transpose(Mat3d(x, y, z)));
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

void turn(Scene& scene, const Mat4d& rotation) {
    for (Surface& surface : scene.surfaces)
        for (Mat4d& placement : surface.placements) placement = rotation * placement;
}

void turn(Mesh& mesh, const Mat4d& rotation) {
    for (Part& part : mesh.parts)
        for (Mat4d& placement : part.instances) placement = rotation * placement;
}

}  // namespace burl
