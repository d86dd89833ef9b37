#include "atlas/chart/least_rectangle.h"

#include <limits>

namespace burl {
namespace {

TurnedRectangle rectangle_along(const std::vector<Vec2d>& hull, const Vec2d& axis) {
    TurnedRectangle r{axis, Vec2d(std::numeric_limits<double>::max()),
                      Vec2d(-std::numeric_limits<double>::max())};
    for (const Vec2d& p : hull) {
        const Vec2d q(glm::dot(p, axis), cross(axis, p));
        r.low = glm::min(r.low, q);
        r.high = glm::max(r.high, q);
    }
    return r;
}

}  // namespace

std::vector<Vec2d> convex_hull(std::vector<Vec2d> points) {
    if (points.empty()) return points;
    std::sort(points.begin(), points.end(),
              [](const Vec2d& a, const Vec2d& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    std::vector<Vec2d> hull;
    const auto append = [&](const Vec2d& p, std::size_t keep) {
        while (hull.size() >= keep + 2 &&
               cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0)
            hull.pop_back();
        hull.push_back(p);
    };
    for (const Vec2d& p : points) append(p, 0);
    const std::size_t lower = hull.size() - 1;
    for (std::size_t i = points.size() - 1; i-- > 0;) append(points[i], lower);
    if (hull.size() > 1) hull.pop_back();
    return hull;
}

TurnedRectangle least_rectangle(const std::vector<Vec2d>& hull) {
    TurnedRectangle best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Vec2d edge = hull[(i + 1) % hull.size()] - hull[i];
        const double length = glm::length(edge);
        if (!(length > 0.0)) continue;
        const TurnedRectangle r = rectangle_along(hull, edge / length);
        if (r.area() < least) {
            least = r.area();
            best = r;
        }
    }
    return best;
}

}  // namespace burl
