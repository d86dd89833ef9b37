#pragma once
// The rectangle of least area round points of the plane: one of its sides lies along their hull
// (Freeman & Shapira, "Determining the minimum-area encasing rectangle for an arbitrary closed
// curve", 1975).
#include <vector>

#include "atlas/base/vec.h"

namespace burl {

/// A rectangle round points.
struct LeastBox {
    Vec2d along{1.0, 0.0};  ///< direction of its longer side, of length 1
    double longer = 0.0, shorter = 0.0;
    double area = 0.0;
    double perimeter() const { return 2.0 * (longer + shorter); }
};

/// The convex hull of points, counter-clockwise (Andrew's monotone chain, 1979).
std::vector<Vec2d> hull_of(std::vector<Vec2d> points);

/// The least rectangle round a hull; `along` is (1, 0) and the area infinite where it has no
/// extent.
LeastBox least_box(const std::vector<Vec2d>& hull);

}  // namespace burl
