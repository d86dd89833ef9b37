#include "atlas/mesh/unit_frame.h"

namespace burl {

namespace {

constexpr double frame_steps = 1.0 / frame_step;  ///< a side of the unit frame

/// The nearest whole number; of two the larger, also where x has been rounded by up to 2^-17. In a
/// box whose side is a power of two, half the coordinates of 24 bits lie between two steps.
Vec3d nearest_step(const Vec3d& x) {
    return glm::floor(glm::floor(x * 0x1p16 + 0.5) * 0x1p-16 + 0.5);
}

}  // namespace

Mesh in_unit_frame(const Mesh& mesh) {
    Mesh result;
    result.triangles = mesh.triangles;
    result.positions = mesh.positions;
    const Box3 box = bounding_box(mesh);
    const double side = box.longest_side();
    if (!(side > 0.0)) return result;
    for (Vec3d& p : result.positions)
        p = nearest_step((p - box.low) / side * frame_steps) / frame_steps;
    return result;
}

}  // namespace burl
