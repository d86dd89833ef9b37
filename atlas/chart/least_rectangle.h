#pragma once
// The rectangle of least area round points of the plane: one of its sides lies along their hull
// (Freeman & Shapira, "Determining the minimum-area encasing rectangle for an arbitrary closed
// curve", 1975); every hull edge is tried.
#include <algorithm>
#include <vector>

#include "atlas/base/vec.h"

namespace burl {

/// A rectangle with a side along the unit vector `axis`; its extent is in coordinates along the
/// axis and to its left.
struct TurnedRectangle {
    Vec2d axis{1.0, 0.0}, low{0.0}, high{0.0};

    Vec2d size() const { return high - low; }
    double area() const { return (high.x - low.x) * (high.y - low.y); }
    double longer() const { return std::max(size().x, size().y); }
    double perimeter() const { return 2.0 * (size().x + size().y); }
};

/// The convex hull, counter-clockwise, without points on its edges (Andrew's monotone chain, 1979).
std::vector<Vec2d> convex_hull(std::vector<Vec2d> points);

/// The least rectangle round a hull; one without extent where the hull has none.
TurnedRectangle least_rectangle(const std::vector<Vec2d>& hull);

}  // namespace burl
