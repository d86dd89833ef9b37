#pragma once
// Euler angles of rotations, as recipes hold them.
#include "atlas/base/vec.h"

namespace burl {

/// The angles in degrees about x, then y, then z, each within [-360, 360], for which
/// rotation_about_axes (procedural/numbers/rotation.h) gives `rotation` to some 1e-14. Among all
/// such angles those nearest to `near` are taken: in gimbal lock (y a quarter turn, so that x and z
/// turn about one line) x keeps its value of `near`.
Vec3d angles_of(const Mat3d& rotation, const Vec3d& near = Vec3d(0.0));

/// The shortest rotation that takes the direction `from` to `to`; opposite directions by a half
/// turn about any perpendicular axis. Lengths are ignored; the identity where one of them is 0.
Mat3d turn_between(const Vec3d& from, const Vec3d& to);

/// The rotation about an axis of any length but 0 by an angle in radians, counterclockwise when the
/// axis points at the viewer.
Mat3d turn_about(const Vec3d& axis, double radians);

}  // namespace burl
