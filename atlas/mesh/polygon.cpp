// Ear clipping with three grades of strictness: proper ears first, then ears that only touch other
// corners, then ears without area; so every polygon, however broken, ends with n - 2 triangles. The
// plane is reached by dropping the normal's longest axis, which leaves the coordinates exact.
#include "atlas/mesh/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burl {

namespace {

/// Twice the signed area of triangle abc; zero where rounding could have made its sign.
double orientation(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
    const double left = (b.x - a.x) * (c.y - a.y);
    const double right = (b.y - a.y) * (c.x - a.x);
    const double bound = 4.0 * std::numeric_limits<double>::epsilon();
    const double area = left - right;
    return std::abs(area) <= bound * (std::abs(left) + std::abs(right)) ? 0.0 : area;
}

/// Newell's normal of a polygon: robust for non-planar polygons and collinear corners.
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

/// Fills the grid by a counting sort over its cells.
void PointGrid::fill(const std::vector<Vec2d>& points, const std::vector<std::uint32_t>& members) {
    side_ = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(members.size()))) + 1;
    low_ = points.front();
    Vec2d high = low_;
    for (const Vec2d& p : points) {
        low_ = glm::min(low_, p);
        high = glm::max(high, p);
    }
    for (int k = 0; k < 2; ++k)
        cells_per_unit_[k] = high[k] > low_[k] ? side_ / (high[k] - low_[k]) : 0.0;

    const auto cell_of = [&](std::uint32_t member) {
        return row(points[member].y) * side_ + column(points[member].x);
    };
    begin_.assign(std::size_t{side_} * side_, 0);
    for (const std::uint32_t member : members) ++begin_[cell_of(member)];
    std::uint32_t sum = 0;
    for (std::uint32_t& begin : begin_) {
        const std::uint32_t count = begin;
        begin = sum;
        sum += count;
    }
    end_ = begin_;
    members_.resize(members.size());
    for (const std::uint32_t member : members) members_[end_[cell_of(member)]++] = member;
}

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

/// Fills plane_ with the projected corners, counter-clockwise; false where Newell's normal is zero.
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

/// Whether every corner turns left and the outline goes round once.
bool PolygonTriangulator::strictly_convex() const {
    const std::size_t count = plane_.size();
    int changes = 0;  // changes of the x direction: two for one turn
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

/// Cuts ears lap after lap until a triangle is left. A first lap tries every corner, the next ones
/// only the corners beside a cut, whose angle changed; when these are used up, all are tried again,
/// and when that gives nothing, with the next milder grade of strictness.
void PolygonTriangulator::clip_ears() {
    const auto count = static_cast<std::uint32_t>(plane_.size());
    start_ring(count);
    work_left_ = std::min<std::uint64_t>(4096ull * count, 1ull << 26);
    std::uint32_t left_at_last_fill = count;
    int strictness = 2;
    bool full_lap = true, forced = false;
    while (left_ > 3 && work_left_ > 0) {
        const std::uint32_t left_before = left_;
        run_lap(strictness);
        if (left_ < left_at_last_fill / 2) {  // ears are larger by now, so cells should be, too
            find_blockers();
            left_at_last_fill = left_;
        }
        const bool stuck = full_lap && left_ == left_before;
        strictness = stuck ? strictness - 1 : 2;
        if (strictness < 0) {
            cut(next_[start_]);
            forced = true;
            strictness = 2;
        }
        full_lap = lap_.empty();
        if (full_lap) lap_ = ring();
    }
    forced |= left_ > 3;
    forced_ += forced;
    while (left_ > 3) cut(next_[start_]);
    triangles_.push_back({previous_[start_], start_, next_[start_]});
}

void PolygonTriangulator::start_ring(std::uint32_t count) {
    next_.resize(count);
    previous_.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        next_[i] = i + 1 == count ? 0 : i + 1;
        previous_[i] = i == 0 ? count - 1 : i - 1;
    }
    start_ = 0;
    left_ = count;
    lap_ = ring();
    touched_.assign(count, false);
    find_blockers();
}

/// The corners left in the ring, in order.
std::vector<std::uint32_t> PolygonTriangulator::ring() const {
    std::vector<std::uint32_t> corners;
    corners.reserve(left_);
    for (std::uint32_t i = 0, corner = start_; i < left_; ++i, corner = next_[corner])
        corners.push_back(corner);
    return corners;
}

/// Tries the corners of lap_ and leaves in it the corners to try next: the neighbours of the cut
/// ones, which are passed over in this lap so that no fan of slivers grows round a corner.
void PolygonTriangulator::run_lap(int strictness) {
    following_.clear();
    for (const std::uint32_t tip : lap_) {
        if (left_ == 3 || work_left_ == 0) break;
        spend(1);
        if (next_[tip] == tip || touched_[tip] || !is_ear(tip, strictness)) continue;
        for (const std::uint32_t beside : {previous_[tip], next_[tip]}) {
            if (!touched_[beside]) following_.push_back(beside);
            touched_[beside] = true;
        }
        cut(tip);
        if (strictness < 2) break;  // proper ears may be free now
    }
    for (const std::uint32_t corner : following_) touched_[corner] = false;
    lap_.swap(following_);
}

void PolygonTriangulator::cut(std::uint32_t tip) {
    const std::uint32_t before = previous_[tip], after = next_[tip];
    triangles_.push_back({before, tip, after});
    next_[before] = after;
    previous_[after] = before;
    next_[tip] = tip;
    if (start_ == tip) start_ = after;
    --left_;
}

double PolygonTriangulator::turn(std::uint32_t corner) const {
    return orientation(plane_[previous_[corner]], plane_[corner], plane_[next_[corner]]);
}

/// Collects the corners that can keep an ear from being cut: reflex and straight ones. (Where
/// another corner lies in an ear, one of them does, too, and cutting never makes new ones.)
void PolygonTriangulator::find_blockers() {
    blockers_ = ring();
    std::erase_if(blockers_, [&](std::uint32_t corner) { return turn(corner) > 0.0; });
    blocker_grid_.fill(plane_, blockers_);
}

/// Whether the triangle at `tip` may be cut off. Strictness 2 asks for area and no corner in the
/// closed triangle, 1 for area and no corner strictly inside, 0 for no area at all.
bool PolygonTriangulator::is_ear(std::uint32_t tip, int strictness) {
    const Vec2d &a = plane_[previous_[tip]], &b = plane_[tip], &c = plane_[next_[tip]];
    const double area = orientation(a, b, c);
    if (strictness == 0) return area == 0.0;
    if (!(area > 0.0)) return false;
    const Vec2d low = glm::min(glm::min(a, b), c), high = glm::max(glm::max(a, b), c);
    spend(blocker_grid_.cells_in(low, high));
    using enum PointGrid::Verdict;
    return !blocker_grid_.visit(low, high, [&](std::uint32_t other) {
        spend(1);
        if (next_[other] == other || turn(other) > 0.0) return drop;  // cut, or turns left by now
        const bool of_the_ear = other == previous_[tip] || other == tip || other == next_[tip];
        return !of_the_ear && blocks(other, tip, strictness) ? stop : keep;
    });
}

/// Whether corner `other`, which does not turn left, keeps the triangle at `tip` from being cut
/// off.
bool PolygonTriangulator::blocks(std::uint32_t other, std::uint32_t tip, int strictness) const {
    const Vec2d &a = plane_[previous_[tip]], &b = plane_[tip], &c = plane_[next_[tip]];
    const Vec2d& p = plane_[other];
    const double ab = orientation(a, b, p), bc = orientation(b, c, p), ca = orientation(c, a, p);
    if (ab < 0.0 || bc < 0.0 || ca < 0.0) return false;
    if (p == b) {  // a bridge or a touching loop: does it enter the wedge at the tip?
        const auto enters = [&](const Vec2d& q) {
            return orientation(a, b, q) > 0.0 && orientation(b, c, q) > 0.0;
        };
        return enters(plane_[previous_[other]]) || enters(plane_[next_[other]]);
    }
    if (p == a || p == c) return false;
    return strictness == 2 || (ab > 0.0 && bc > 0.0 && ca > 0.0);
}

}  // namespace burl
