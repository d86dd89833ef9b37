#include "atlas/outline/least_box.h"

#include <algorithm>
#include <limits>

namespace burl {

std::vector<Vec2d> hull_of(std::vector<Vec2d> points) {
    std::ranges::sort(points, [](const Vec2d& a, const Vec2d& b) {
        return a.x < b.x || (a.x == b.x && a.y < b.y);
    });
    std::vector<Vec2d> hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t first = hull.size();
        for (const Vec2d& p : points) {
            while (hull.size() >= first + 2 &&
                   cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0)
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();
        std::ranges::reverse(points);
    }
    return hull;
}

LeastBox least_box(const std::vector<Vec2d>& hull) {
    LeastBox least{.area = std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Vec2d edge = hull[(i + 1) % hull.size()] - hull[i];
        if (!(glm::length(edge) > 0.0)) continue;
        const Vec2d u = glm::normalize(edge), v(-u.y, u.x);
        Vec2d low(std::numeric_limits<double>::infinity()), high = -low;
        for (const Vec2d& p : hull) {
            const Vec2d q(glm::dot(p, u), glm::dot(p, v));
            low = glm::min(low, q);
            high = glm::max(high, q);
        }
        const Vec2d size = high - low;
        if (size.x * size.y < least.area)
            least = {size.x >= size.y ? u : v, std::max(size.x, size.y), std::min(size.x, size.y),
                     size.x * size.y};
    }
    return least;
}

}  // namespace burl
