#pragma once
// The way back from a rotation to the three angles that recipes hold.
#include "atlas/base/vec.h"

namespace burl {

/// Degrees about x, then y, then z, within [-360, 360], for which rotation_about_axes
/// (procedural/numbers/rotation.h) gives `rotation`, to some 1e-14. Of the sets that do, the one
/// nearest to `near`: where y is a quarter turn, and x and z turn about one line, x stays as it
/// was.
Vec3d angles_of(const Mat3d& rotation, const Vec3d& near = Vec3d(0.0));

/// The shortest turn that takes one direction to another; opposite ones by a half turn about any
/// line across. Lengths do not matter; the identity where one is 0.
Mat3d turn_between(const Vec3d& from, const Vec3d& to);

/// About an axis of any length but 0, by radians, counterclockwise seen against it.
Mat3d turn_about(const Vec3d& axis, double radians);

}  // namespace burl
