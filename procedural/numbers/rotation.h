#pragma once
// Rotations about the coordinate axes, for textures that lie askew in their solid.
#include <cmath>
#include <numbers>

#include "atlas/base/elementary.h"
#include "atlas/base/vec.h"

namespace burl {

/// The cosine and the sine of a finite angle in degrees, the same on every machine; exact for
/// quarter turns.
inline Vec2d cosine_and_sine(double degrees) {
    const double quarters = std::nearbyint(degrees / 90.0);
    const double rest = (degrees - 90.0 * quarters) * std::numbers::pi / 180.0;
    const double s = sine(rest), half = sine(0.5 * rest), c = 1.0 - 2.0 * half * half;
    switch (int(std::fmod(quarters, 4.0))) {
        case 1:
        case -3:
            return {-s, c};
        case 2:
        case -2:
            return {-c, -s};
        case 3:
        case -1:
            return {s, -c};
        default:
            return {c, s};
    }
}

/// The rotation about axis 0, 1 or 2, counterclockwise seen against the axis: a quarter turn about
/// the first axis takes the second to the third. The identity for 0 degrees.
inline Mat3d rotation_about(int axis, double degrees) {
    const Vec2d at = cosine_and_sine(degrees);
    const int from = (axis + 1) % 3, to = (axis + 2) % 3;
    Mat3d m(1.0);
    m[from][from] = m[to][to] = at.x;
    m[from][to] = at.y;
    m[to][from] = -at.y;
    return m;
}

/// The rotation about the first axis, then the second, then the third, all of them fixed.
inline Mat3d rotation_about_axes(const Vec3d& degrees) {
    Mat3d m(1.0);
    for (int axis = 0; axis < 3; ++axis) m = rotation_about(axis, degrees[axis]) * m;
    return m;
}

}  // namespace burl
