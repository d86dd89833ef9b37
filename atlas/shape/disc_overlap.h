#pragma once
// The part of a triangle that lies in a ball, in closed form: a triangle of a plane, cut by the
// disc in which the plane meets the ball, is a sum of triangles and circular sectors about the
// disc's centre, one for each piece of its edges (Green's theorem).
#include <array>

#include "atlas/base/vec.h"

namespace burl {

/// Area and first moment of a piece of surface.
struct SurfacePiece {
    double area = 0.0;
    Vec3d moment{0.0};  ///< the integral of position over the area
};

/// The part of a triangle within distance `radius` of the origin. `normal` is the triangle's unit
/// normal, counter-clockwise.
SurfacePiece piece_in_ball(const std::array<Vec3d, 3>& corners, const Vec3d& normal, double radius);

}  // namespace burl
