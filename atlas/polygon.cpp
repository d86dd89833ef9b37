// Ear clipping with three grades of strictness: proper ears first, then ears that only touch other
// corners, then ears without area; so every polygon, however broken, ends with n - 2 triangles. The
// plane is reached by dropping the normal's longest axis, which leaves the coordinates exact.
#include "atlas/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burl {
namespace {

/// Twice the signed area of abc, zero where rounding could have made its sign.
double orientation(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
    const double left = (b.x - a.x) * (c.y - a.y);
    const double right = (b.y - a.y) * (c.x - a.x);
    const double bound = 4.0 * std::numeric_limits<double>::epsilon();
    const double area = left - right;
    return std::abs(area) <= bound * (std::abs(left) + std::abs(right)) ? 0.0 : area;
}

/// Newell's normal: robust for non-planar polygons and collinear corners.
Vec3d newell_normal(std::span<const Vec3d> corners) {
    Vec3d normal(0.0);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3d a = corners[i] - corners[0];
        const Vec3d b = corners[i + 1 == corners.size() ? 0 : i + 1] - corners[0];
        normal += glm::cross(a, b);
    }
    return normal;
}

}  // namespace

const std::vector<std::array<std::uint32_t, 3>>& PolygonTriangulator::operator()(
    std::span<const Vec3d> corners) {
    triangles_.clear();
    const auto count = static_cast<std::uint32_t>(corners.size());
    if (count == 3 || !project(corners) || strictly_convex())
        fan(count);
    else
        clip_ears();
    return triangles_;
}

/// Fills plane_, counter-clockwise; false when the polygon has no area to speak of.
bool PolygonTriangulator::project(std::span<const Vec3d> corners) {
    const Vec3d normal = newell_normal(corners);
    const Vec3d size = glm::abs(normal);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    if (!(size[axis] > 0.0)) return false;
    int u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (normal[axis] < 0.0) std::swap(u, v);
    plane_.resize(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) plane_[i] = {corners[i][u], corners[i][v]};
    return true;
}

/// Every corner turns left and the outline goes round once.
bool PolygonTriangulator::strictly_convex() const {
    const std::size_t count = plane_.size();
    int changes = 0;  // of the x direction: two for one turn
    bool rightward = plane_[0].x > plane_[count - 1].x;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2d& a = plane_[i];
        const Vec2d& b = plane_[i + 1 == count ? 0 : i + 1];
        const Vec2d& c = plane_[i + 2 >= count ? i + 2 - count : i + 2];
        if (!(orientation(a, b, c) > 0.0)) return false;
        const bool direction = b.x == a.x ? rightward : b.x > a.x;
        changes += direction != rightward;
        rightward = direction;
    }
    return changes <= 2;
}

void PolygonTriangulator::fan(std::uint32_t count) {
    for (std::uint32_t i = 1; i + 1 < count; ++i) triangles_.push_back({0, i, i + 1});
}

/// Clips the first ear of the mildest grade that has one, until a triangle is left.
void PolygonTriangulator::clip_ears() {
    const auto count = static_cast<std::uint32_t>(plane_.size());
    next_.resize(count);
    previous_.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        next_[i] = i + 1 == count ? 0 : i + 1;
        previous_[i] = i == 0 ? count - 1 : i - 1;
    }
    work_left_ = std::min<std::uint64_t>(4096ull * count, 1ull << 26);
    std::uint32_t tip = 0, left = count, tried = 0;
    int strictness = 2;
    while (left > 3) {
        if (work_left_ == 0) strictness = -1;
        if (strictness < 0 || is_ear(tip, strictness)) {
            const std::uint32_t after = next_[tip];
            cut(tip);
            --left;
            tip = next_[after];  // not the neighbour: avoids fans of slivers
            tried = 0;
            strictness = work_left_ == 0 ? -1 : 2;
        } else {
            tip = next_[tip];
            if (++tried == left) {
                tried = 0;
                --strictness;
            }
        }
    }
    unfinished_ += work_left_ == 0;
    triangles_.push_back({previous_[tip], tip, next_[tip]});
}

void PolygonTriangulator::cut(std::uint32_t tip) {
    const std::uint32_t before = previous_[tip], after = next_[tip];
    triangles_.push_back({before, tip, after});
    next_[before] = after;
    previous_[after] = before;
}

/// Grade 2: area and nothing in the closed triangle; 1: nothing strictly inside; 0: no area at all.
bool PolygonTriangulator::is_ear(std::uint32_t tip, int strictness) {
    const Vec2d &a = plane_[previous_[tip]], &b = plane_[tip], &c = plane_[next_[tip]];
    const double area = orientation(a, b, c);
    if (strictness == 0) return area == 0.0;
    if (!(area > 0.0)) return false;
    for (std::uint32_t i = next_[next_[tip]]; i != previous_[tip]; i = next_[i]) {
        if (work_left_ > 0) --work_left_;
        if (blocks(i, tip, strictness)) return false;
    }
    return true;
}

/// Does corner `other` keep the triangle at `tip` from being cut off? Only corners that do not turn
/// left can: where one of the others lies inside, such a one does too.
bool PolygonTriangulator::blocks(std::uint32_t other, std::uint32_t tip, int strictness) const {
    const Vec2d &a = plane_[previous_[tip]], &b = plane_[tip], &c = plane_[next_[tip]];
    const Vec2d& p = plane_[other];
    const double ab = orientation(a, b, p), bc = orientation(b, c, p), ca = orientation(c, a, p);
    if (ab < 0.0 || bc < 0.0 || ca < 0.0) return false;
    const Vec2d &before = plane_[previous_[other]], &after = plane_[next_[other]];
    if (p == b) {  // a bridge or a touching loop: does it enter the wedge at the tip?
        const auto enters = [&](const Vec2d& q) {
            return orientation(a, b, q) > 0.0 && orientation(b, c, q) > 0.0;
        };
        return enters(before) || enters(after);
    }
    if (p == a || p == c) return false;
    if (strictness < 2 && (ab == 0.0 || bc == 0.0 || ca == 0.0)) return false;
    return orientation(before, p, after) <= 0.0;
}

}  // namespace burl
