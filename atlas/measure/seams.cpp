#include "atlas/measure/seams.h"

#include <algorithm>
#include <cmath>

#include "atlas/base/random_unit.h"
#include "atlas/measure/lookup.h"
#include "atlas/measure/surface_mean.h"

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

Vec2d on_side(const Atlas& atlas, const EdgeSide& side, double t) {
    const auto& corners = atlas.corners[side.triangle];
    return (1.0 - t) * corners[side.corners[0]] + t * corners[side.corners[1]];
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
    // Segments far outside the texture are of no use; so long an edge is cut more coarsely.
    const double count = std::clamp(std::ceil(glm::length(b - a) / cell_size), 1.0, 1e4);
    for (double i = 0.0; i < count; ++i) {
        const Vec2d p = a + (i / count) * (b - a), q = a + ((i + 1.0) / count) * (b - a);
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

SeamPoints seam_points(const Mesh& mesh, const Atlas& atlas, std::span<const MeshEdge> edges,
                       std::size_t count, std::uint64_t seed) {
    SeamPoints points;
    double interior = 0.0, seams = 0.0;
    for (const MeshEdge& edge : edges) {
        if (!edge.interior) continue;
        interior += edge_length(mesh, edge);
        if (!joined(atlas, edge)) seams += edge_length(mesh, edge);
    }
    if (!(seams > 0.0)) return points;
    points.share = seams / interior;
    double below = 0.0;
    std::size_t next = 0;
    const auto wanted = [&] {
        return seams * (double(next) + random_unit(seed, next)) / double(count);
    };
    for (const MeshEdge& edge : edges) {
        if (!edge.interior || joined(atlas, edge)) continue;
        const double length = edge_length(mesh, edge);
        for (; next < count && wanted() < below + length; ++next) {
            const double t = (wanted() - below) / length;
            points.places.push_back(
                {on_side(atlas, edge.first, t), on_side(atlas, edge.second, t)});
        }
        below += length;
    }
    return points;
}

double mismatch(const SeamPoints& points, const Image<Vec3f>& level, std::uint32_t size) {
    if (points.places.empty()) return 0.0;
    const double scale = double(level.width()) / size;
    double squares = 0.0;
    for (const auto& [a, b] : points.places) {
        squares += mean_square(bilinear(level, a * scale) - bilinear(level, b * scale));
    }
    return std::sqrt(points.share * squares / double(points.places.size()));
}

}  // namespace burl
