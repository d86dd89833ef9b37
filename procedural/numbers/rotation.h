#pragma once
// Rotations about the coordinate axes, for textures that lie askew in their solid.
#include <numbers>

#include "atlas/base/elementary.h"
#include "atlas/base/vec.h"

namespace burl {

/// The rotation about axis 0, 1 or 2, counterclockwise seen against the axis: a quarter turn about
/// the first axis takes the second to the third. The identity for 0 degrees.
inline Mat3d rotation_about(int axis, double degrees) {
    const double angle = degrees * std::numbers::pi / 180.0, c = cosine(angle), s = sine(angle);
    const int from = (axis + 1) % 3, to = (axis + 2) % 3;
    Mat3d m(1.0);
    m[from][from] = m[to][to] = c;
    m[from][to] = s;
    m[to][from] = -s;
    return m;
}

/// The rotation about the first axis, then the second, then the third, all of them fixed.
inline Mat3d rotation_about_axes(const Vec3d& degrees) {
    Mat3d m(1.0);
    for (int axis = 0; axis < 3; ++axis) m = rotation_about(axis, degrees[axis]) * m;
    return m;
}

}  // namespace burl
