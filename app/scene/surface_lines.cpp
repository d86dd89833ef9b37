#include "app/scene/surface_lines.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace burl {

namespace {

/// Per position a number that is equal for equal positions, since corners of several charts share a
/// point.
std::vector<std::uint32_t> point_numbers(const std::vector<Vec3d>& positions) {
    std::vector<std::uint32_t> order(positions.size()), numbers(positions.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto key = [&](std::uint32_t i) {
        const Vec3d& p = positions[i];
        return std::tuple(p.x, p.y, p.z, i);
    };
    std::ranges::sort(order, {}, key);
    for (std::size_t k = 0; k < order.size(); ++k) {
        const bool known = k > 0 && positions[order[k]] == positions[order[k - 1]];
        numbers[order[k]] = known ? numbers[order[k - 1]] : order[k];
    }
    return numbers;
}

/// A side of a triangle, directed from the lower point number to the higher one.
struct Side {
    /// The numbers of its points, its triangle, and the vertices at its ends.
    std::uint32_t low = 0, high = 0, triangle = 0, from = 0, to = 0;
    auto key() const { return std::tuple(low, high, triangle, from); }
    bool same_edge(const Side& other) const { return low == other.low && high == other.high; }
};

std::vector<Side> sides_of(const Surface& surface) {
    const std::vector<std::uint32_t> numbers = point_numbers(surface.positions);
    std::vector<Side> sides;
    sides.reserve(3 * surface.triangles.size());
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            std::uint32_t from = surface.triangles[t][k], to = surface.triangles[t][(k + 1) % 3];
            if (numbers[from] > numbers[to]) std::swap(from, to);
            sides.push_back({numbers[from], numbers[to], t, from, to});
        }
    std::ranges::sort(sides, {}, &Side::key);
    return sides;
}

/// The connected groups of triangles (Tarjan's union-find with path halving); a group's root is its
/// least triangle.
class Groups {
  public:
    explicit Groups(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0U);
    }
    std::uint32_t root(std::uint32_t t) {
        while (parent_[t] != t) t = parent_[t] = parent_[parent_[t]];
        return t;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = root(a), b = root(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::uint32_t> parent_;
};

class Lines {
  public:
    explicit Lines(const Surface& surface)
        : surface_(surface), groups_(surface.triangles.size()), sides_(sides_of(surface)) {}

    /// Appends the surface's edges, borders and charts, which are numbered on from those already
    /// there.
    void add_to(SurfaceLines& lines, bool changes) {
        std::vector<Side> borders;
        for (auto side = sides_.begin(); side != sides_.end();) {
            const auto end = std::find_if(
                side, sides_.end(), [&](const Side& other) { return !other.same_edge(*side); });
            lines.edges.push_back(line(*side));
            if (changes) lines.changes.push_back(change(*side));
            if (end - side == 2 && lie_together(side[0], side[1]))
                groups_.join(side[0].triangle, side[1].triangle);
            else
                borders.insert(borders.end(), side, end);
            side = end;
        }
        add_borders(borders, lines);
    }

  private:
    bool lie_together(const Side& a, const Side& b) const {
        const std::vector<Vec2d>& uvs = surface_.uvs;
        return uvs.empty() || (uvs[a.from] == uvs[b.from] && uvs[a.to] == uvs[b.to]);
    }

    void add_borders(std::vector<Side>& borders, SurfaceLines& lines) {
        std::vector<std::uint32_t> charts(surface_.triangles.size());
        auto count = std::uint32_t(lines.border_begin.size()) - 1;
        for (std::uint32_t t = 0; t < charts.size(); ++t) {
            const std::uint32_t root = groups_.root(t);  // the least triangle of its group
            charts[t] = root == t ? count++ : charts[root];
        }
        std::ranges::stable_sort(borders, {}, [&](const Side& s) { return charts[s.triangle]; });
        auto side = borders.begin();
        while (lines.border_begin.size() <= count) {
            const auto chart = std::uint32_t(lines.border_begin.size()) - 1;
            for (; side != borders.end() && charts[side->triangle] == chart; ++side)
                lines.borders.push_back(border(*side));
            lines.border_begin.push_back(lines.borders.size());
        }
        lines.charts.push_back(std::move(charts));
    }

    Vec3d point(std::uint32_t vertex) const {
        return Vec3d(surface_.placements.front() * Vec4d(surface_.positions[vertex], 1.0));
    }
    Vec3d change(std::uint32_t vertex) const {
        if (surface_.target.positions.empty()) return Vec3d(0.0);
        return Mat3d(surface_.placements.front()) * surface_.target.positions[vertex];
    }
    SurfaceLine change(const Side& side) const { return {change(side.from), change(side.to)}; }
    Vec3d normal(const Triangle& t, double share) const {
        const auto at = [&](std::size_t k) { return point(t[k]) + share * change(t[k]); };
        return glm::cross(at(1) - at(0), at(2) - at(0));
    }
    Vec2d uv(std::uint32_t vertex) const {
        return surface_.uvs.empty() ? Vec2d(0.0) : surface_.uvs[vertex];
    }
    SurfaceLine line(const Side& side) const { return {point(side.from), point(side.to)}; }
    BorderLine border(const Side& side) const {
        const Triangle& t = surface_.triangles[side.triangle];
        const Vec3d rest = normal(t, 0.0);
        return {line(side), uv(side.from), uv(side.to), rest, change(side), normal(t, 1.0) - rest};
    }

    const Surface& surface_;
    Groups groups_;
    std::vector<Side> sides_;
};

}  // namespace

BorderLine BorderLine::at(double share) const {
    BorderLine moved = *this;
    moved.line.from += share * change.from;
    moved.line.to += share * change.to;
    moved.normal += share * normal_change;
    return moved;
}

SurfaceLines surface_lines(const Scene& scene) {
    SurfaceLines lines;
    lines.border_begin.push_back(0);
    const bool changes = std::ranges::any_of(
        scene.surfaces, [](const Surface& surface) { return !surface.target.positions.empty(); });
    for (const Surface& surface : scene.surfaces) Lines(surface).add_to(lines, changes);
    return lines;
}

}  // namespace burl
