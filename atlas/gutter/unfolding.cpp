#include "atlas/gutter/unfolding.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burl {
namespace {

/// Triangles after which a walk is given up that would not arrive within the longest one at this
/// rate: among triangles that are nothing beside a texel each texel's would go on to the end.
constexpr int early_triangles = 64;
constexpr double early_share = double(early_triangles) / longest_walk;
/// Sine of a triangle's angle, here or in the plane, below which it has no area to walk from.
constexpr double least_sine = 1e-12;

/// The quarter turn to the left, measured on the surface, of vectors of the plane that a triangle's
/// map takes to the surface; zero where the triangle has no area.
glm::dmat2 quarter_turn(const std::array<Vec2d, 3>& places, const std::array<Vec3d, 3>& points) {
    const Vec2d u = places[1] - places[0], v = places[2] - places[0];
    const Vec3d along_u = points[1] - points[0], along_v = points[2] - points[0];
    const double determinant = cross(u, v);
    const double sine = glm::length(glm::cross(along_u, along_v));
    if (!(std::abs(determinant) > least_sine * glm::length(u) * glm::length(v)) ||
        !(sine > least_sine * glm::length(along_u) * glm::length(along_v)))
        return glm::dmat2(0.0);
    const Vec3d x = (along_u * v.y - along_v * u.y) / determinant;
    const Vec3d y = (along_v * u.x - along_u * v.x) / determinant;
    const double area = glm::length(glm::cross(x, y));
    return glm::dmat2(-glm::dot(x, y), glm::dot(x, x), -glm::dot(y, y), glm::dot(x, y)) / area;
}

/// The share of the way from a point that lies before the line through a and b; 0 where they are
/// parallel.
double share_before(const Vec2d& a, const Vec2d& b, const Vec2d& from, const Vec2d& way) {
    const double to_edge = cross(a - from, b - a), to_end = cross(way, b - a);
    return std::abs(to_end) > 0.0 ? std::clamp(to_edge / to_end, 0.0, 1.0) : 0.0;
}

/// The number of the edge between two corners of a triangle.
std::uint32_t edge_between(std::uint32_t triangle, std::uint32_t a, std::uint32_t b) {
    return 3 * triangle + ((a + 1) % 3 == b ? a : b);
}

}  // namespace

std::uint32_t Unfolding::begin(std::uint32_t edge, const std::array<Vec2d, 3>& places) {
    Tile tile;
    tile.triangle = edge / 3;
    tile.start = static_cast<std::uint32_t>(starts_.size());
    // Walks leave by the right edge, as if they had come in by the one before.
    tile.right = static_cast<std::uint8_t>(edge % 3);
    tile.apex = static_cast<std::uint8_t>((edge % 3 + 1) % 3);
    if (cross(places[1] - places[0], places[2] - places[0]) < 0.0) std::swap(tile.right, tile.apex);
    tile.left = static_cast<std::uint8_t>(3 - tile.right - tile.apex);
    tile.at_left = places[tile.left];
    tile.at_right = places[tile.right];
    tile.at_apex = places[tile.apex];
    const auto& [a, b, c] = triangles_[tile.triangle];
    starts_.push_back({edge, quarter_turn(places, {positions_[a], positions_[b], positions_[c]})});
    if (starts_.back().turn == glm::dmat2(0.0)) tile.next[0] = closed;
    tiles_.push_back(tile);
    return static_cast<std::uint32_t>(tiles_.size() - 1);
}

Walk Unfolding::walk(std::uint32_t first, const Vec2d& from, const Vec2d& to) {
    const Vec2d way = to - from;
    Walk result{first, 0.0, false};
    bool left = false;
    for (int step = 0; step < longest_; ++step) {
        const std::uint32_t next = beyond(result.tile, left);
        if (next == closed) break;
        result.tile = next;
        const Tile& tile = tiles_[next];
        left = cross(way, tile.at_apex - from) < 0.0;
        const Vec2d a = left ? tile.at_apex : tile.at_right, b = left ? tile.at_left : tile.at_apex;
        if (cross(b - a, to - a) >= 0.0) return {next, 1.0, true};
        if (step == early_triangles && share_before(a, b, from, way) < early_share) break;
    }
    const Tile& tile = tiles_[result.tile];
    const Vec2d a = left ? tile.at_apex : tile.at_right, b = left ? tile.at_left : tile.at_apex;
    result.share = share_before(a, b, from, way);
    return result;
}

UnfoldedTriangle Unfolding::unfolded(std::uint32_t tile) const {
    const Tile& from = tiles_[tile];
    UnfoldedTriangle result{from.triangle, {}};
    result.places[from.left] = from.at_left;
    result.places[from.right] = from.at_right;
    result.places[from.apex] = from.at_apex;
    return result;
}

/// The tile across the right or the left edge of a tile, or closed.
std::uint32_t Unfolding::beyond(std::uint32_t tile, bool left) {
    const std::uint32_t known = tiles_[tile].next[left];
    if (known != unknown) return known;
    if (tiles_.size() >= most_) return closed;
    const std::uint32_t next = unfold(Tile(tiles_[tile]), left);
    return tiles_[tile].next[left] = next;
}

std::uint32_t Unfolding::unfold(const Tile& from, bool left) {
    const std::uint32_t a = left ? from.left : from.apex, b = left ? from.apex : from.right;
    const std::uint32_t edge = edge_between(from.triangle, a, b);
    std::uint32_t over = neighbours_.across(edge);
    if (over == TriangleEdge::none) {
        if (at_open_edge_ == AtOpenEdge::end) return closed;
        over = edge;
    }
    Tile tile;
    tile.triangle = over / 3;
    tile.start = from.start;
    const std::uint32_t point = triangles_[from.triangle][a];
    const bool same = TriangleEdge::start(triangles_, over) == point;
    tile.left = static_cast<std::uint8_t>((over % 3 + (same ? 0 : 1)) % 3);
    tile.right = static_cast<std::uint8_t>((over % 3 + (same ? 1 : 0)) % 3);
    tile.apex = static_cast<std::uint8_t>(3 - tile.left - tile.right);
    tile.at_left = left ? from.at_left : from.at_apex;
    tile.at_right = left ? from.at_apex : from.at_right;
    const Triangle& corners = triangles_[tile.triangle];
    const Vec3d side = positions_[corners[tile.right]] - positions_[corners[tile.left]];
    const Vec3d to_apex = positions_[corners[tile.apex]] - positions_[corners[tile.left]];
    const double square = glm::dot(side, side);
    const double along = glm::dot(to_apex, side) / square;
    const double height = glm::length(glm::cross(side, to_apex)) / square;
    if (!std::isfinite(along) || !std::isfinite(height)) return closed;
    const Vec2d base = tile.at_right - tile.at_left;
    tile.at_apex = tile.at_left + along * base + height * (starts_[from.start].turn * base);
    tiles_.push_back(tile);
    return static_cast<std::uint32_t>(tiles_.size() - 1);
}

}  // namespace burl
