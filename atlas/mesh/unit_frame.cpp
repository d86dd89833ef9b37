#include "atlas/mesh/unit_frame.h"

namespace burl {

namespace {

constexpr double frame_steps = 1.0 / frame_step;  ///< a side of the unit frame

}  // namespace

Mesh in_unit_frame(const Mesh& mesh) {
    Mesh result;
    result.triangles = mesh.triangles;
    result.positions = mesh.positions;
    const Box3 box = bounding_box(mesh);
    const double side = box.longest_side();
    if (!(side > 0.0)) return result;
    for (Vec3d& p : result.positions)
        p = glm::floor((p - box.low) / side * frame_steps + 0.5) / frame_steps;
    return result;
}

}  // namespace burl
