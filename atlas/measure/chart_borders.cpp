// Borders are cut into pieces no longer than a cell of a uniform grid; a piece is listed in every
// cell that comes within a texel of its box.
#include "atlas/measure/chart_borders.h"

#include <algorithm>
#include <cmath>

namespace burl {

namespace {

constexpr double cell_size = 4.0;     // texels
constexpr double border_reach = 1.0;  // texels

double squared_distance(const Vec2d& p, const Vec2d& a, const Vec2d& b) {
    const Vec2d d = b - a;
    const double length = glm::dot(d, d);
    const double t = length > 0.0 ? std::clamp(glm::dot(p - a, d) / length, 0.0, 1.0) : 0.0;
    const Vec2d off = p - (a + t * d);
    return glm::dot(off, off);
}

}  // namespace

ChartBorders::ChartBorders(const Atlas& atlas, std::span<const MeshEdge> edges)
    : size_(atlas.options.size), cells_(std::uint32_t(size_ / cell_size) + 1) {
    const auto add_side = [&](const EdgeSide& side) {
        const auto& corners = atlas.corners[side.triangle];
        add(corners[side.corners[0]], corners[side.corners[1]]);
    };
    for (const MeshEdge& edge : edges) {
        if (joined(atlas, edge)) continue;
        add_side(edge.first);
        if (edge.interior) add_side(edge.second);
    }
    std::sort(in_cell_.begin(), in_cell_.end());
}

void ChartBorders::add(const Vec2d& a, const Vec2d& b) {
    // Pieces far outside the texture are of no use; so long an edge is cut more coarsely.
    const double pieces = std::clamp(std::ceil(glm::length(b - a) / cell_size), 1.0, 1e4);
    for (double i = 0.0; i < pieces; ++i) {
        const Vec2d p = a + (i / pieces) * (b - a), q = a + ((i + 1.0) / pieces) * (b - a);
        const Vec2d low = glm::min(p, q) - border_reach, high = glm::max(p, q) + border_reach;
        if (!(high.x >= 0.0 && high.y >= 0.0 && low.x <= size_ && low.y <= size_)) continue;
        const auto number = std::uint32_t(segments_.size());
        segments_.push_back({p, q});
        for (std::uint32_t y = cell(0.0, low.y); y <= cell(0.0, high.y); y += cells_)
            for (std::uint32_t x = cell(low.x, 0.0); x <= cell(high.x, 0.0); ++x)
                in_cell_.emplace_back(y + x, number);
    }
}

std::uint32_t ChartBorders::cell(double x, double y) const {
    const auto clamped = [&](double c) {
        return std::uint32_t(std::clamp(std::floor(c / cell_size), 0.0, double(cells_ - 1)));
    };
    return clamped(y) * cells_ + clamped(x);
}

bool ChartBorders::near(const Vec2d& place) const {
    const std::uint32_t here = cell(place.x, place.y);
    auto it = std::lower_bound(in_cell_.begin(), in_cell_.end(), std::pair{here, 0u});
    for (; it != in_cell_.end() && it->first == here; ++it) {
        const Segment& s = segments_[it->second];
        if (squared_distance(place, s.a, s.b) <= border_reach * border_reach) return true;
    }
    return false;
}

}  // namespace burl
