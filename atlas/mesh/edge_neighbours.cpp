#include "atlas/mesh/edge_neighbours.h"

namespace burl {
namespace {

/// Sine of an angle below which a triangle has no area.
constexpr double least_sine_of_area = 1e-12;

}  // namespace

EdgeNeighbours::EdgeNeighbours(std::span<const Triangle> triangles,
                               std::span<const Vec3d> positions)
    : triangles_(triangles),
      positions_(positions),
      begin_(positions.size() + 2, 0),
      list_(3 * triangles.size()) {
    // Counts lie two places on, so that filling moves every begin to where it belongs.
    for (const Triangle& triangle : triangles)
        for (const std::uint32_t point : triangle) ++begin_[point + 2];
    for (std::size_t p = 2; p < begin_.size(); ++p) begin_[p] += begin_[p - 1];
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        for (const std::uint32_t point : triangles[t]) list_[begin_[point + 1]++] = t;
}

bool EdgeNeighbours::has_area(std::uint32_t triangle) const {
    const auto& [a, b, c] = triangles_[triangle];
    const Vec3d u = positions_[b] - positions_[a], v = positions_[c] - positions_[a];
    return glm::length(glm::cross(u, v)) > least_sine_of_area * glm::length(u) * glm::length(v);
}

std::uint32_t EdgeNeighbours::across(std::uint32_t edge) const {
    const std::uint32_t a = TriangleEdge::start(triangles_, edge),
                        b = TriangleEdge::end(triangles_, edge);
    if (a == b) return TriangleEdge::none;
    std::uint32_t found = TriangleEdge::none;
    bool one = true, flat = true;
    visit_edges_of(a, b, [&](std::uint32_t other) {
        const bool same_way = TriangleEdge::start(triangles_, other) == a;
        const std::uint32_t known = same_way ? edge : found;
        if (known != TriangleEdge::none && third_point(other) == third_point(known)) return;
        const bool other_flat = !has_area(other / 3);
        if (same_way) {
            one = one && other_flat;
        } else if (found == TriangleEdge::none || (flat && !other_flat)) {
            found = other;
            flat = other_flat;
        } else if (flat == other_flat) {
            one = false;
        }
    });
    return one ? found : TriangleEdge::none;
}

}  // namespace burl
