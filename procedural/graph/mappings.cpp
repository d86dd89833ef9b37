// The nodes that move the point at which other nodes are evaluated: pbrt's texture mappings and
// affine maps. Slopes follow by the chain rule, so they are continuous across the seams of the
// round mappings, which finite differences (the slides' way) have to repair.
#include <numbers>

#include "procedural/graph/affine.h"
#include "procedural/graph/nodes.h"
#include "procedural/numbers/rotation.h"

namespace burl::nodes {

namespace {

using std::numbers::pi;

Dual dot(const Vec3d& d, const DualPoint& p) {
    return d.x * p.x + d.y * p.y + d.z * p.z;
}

}  // namespace

void transform(const NodeCall& call) {
    const Affine3 map = transform_map(call);
    const Mat3d rows = glm::transpose(map.linear);
    map_points(call, [&](std::size_t, const DualPoint& p) -> DualPoint {
        return {dot(rows[0], p) + map.offset.x, dot(rows[1], p) + map.offset.y,
                dot(rows[2], p) + map.offset.z};
    });
}

void map_uv(const NodeCall& call) {
    const double su = call.parameter("scale", 0), sv = call.parameter("scale", 1);
    const double du = call.parameter("offset", 0), dv = call.parameter("offset", 1);
    map_points(call, [&](std::size_t, const DualPoint& p) -> DualPoint {
        return {su * p.x + du, sv * p.y + dv, p.z};
    });
}

void map_spherical(const NodeCall& call) {
    map_points(call, [](std::size_t, const DualPoint& p) -> DualPoint {
        const Dual off_axis = dual_length(p.x, p.y), turn = dual_angle(p.y, p.x);
        const Dual t = 0.5 / pi * turn;
        return {1.0 / pi * dual_angle(off_axis, p.z), t.value < 0.0 ? t + 1.0 : t,
                dual_length(off_axis, p.z)};
    });
}

void map_cylindrical(const NodeCall& call) {
    const bool normalized = call.parameter("height") == 1.0;
    map_points(call, [&](std::size_t, const DualPoint& p) -> DualPoint {
        const Dual off_axis = dual_length(p.x, p.y), distance = dual_length(off_axis, p.z);
        Dual t = p.z;
        if (normalized)
            t = distance.value > 0.0 ? p.z * chain(distance, 1.0 / distance.value,
                                                   -1.0 / (distance.value * distance.value))
                                     : Dual(0.0);
        return {0.5 + 0.5 / pi * dual_angle(p.y, p.x), t, off_axis};
    });
}

void map_planar(const NodeCall& call) {
    const Vec3d vs = call.vector("vs"), vt = call.vector("vt");
    const double ds = call.parameter("offset", 0), dt = call.parameter("offset", 1);
    map_points(call, [&](std::size_t, const DualPoint& p) -> DualPoint {
        return {dot(vs, p) + ds, dot(vt, p) + dt, 0.0};
    });
}

}  // namespace burl::nodes

namespace burl {

Affine3 transform_map(const NodeCall& call) {
    const Vec3d factors = call.vector("scale"), degrees = call.vector("rotate");
    Affine3 inner{Mat3d(1.0), call.vector("translate")}, outer;
    for (int axis = 0; axis < 3; ++axis) inner.linear[axis] *= factors[axis];
    for (int axis = 0; axis < 3; ++axis)
        inner.linear = rotation_about(axis, degrees[axis]) * inner.linear;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            outer.linear[column][row] = call.parameter("matrix", std::size_t(4 * row + column));
        outer.offset[row] = call.parameter("matrix", std::size_t(4 * row + 3));
    }
    return outer.after(inner);
}

}  // namespace burl
