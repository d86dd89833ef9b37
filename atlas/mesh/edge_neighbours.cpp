#include "atlas/mesh/edge_neighbours.h"

namespace burl {

EdgeNeighbours::EdgeNeighbours(std::span<const Triangle> triangles, std::size_t points)
    : triangles_(triangles), begin_(points + 2, 0), list_(3 * triangles.size()) {
    // Counts lie two places on, so that filling moves every begin to where it belongs.
    for (const Triangle& triangle : triangles)
        for (const std::uint32_t point : triangle) ++begin_[point + 2];
    for (std::size_t p = 2; p < begin_.size(); ++p) begin_[p] += begin_[p - 1];
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        for (const std::uint32_t point : triangles[t]) list_[begin_[point + 1]++] = t;
}

std::uint32_t EdgeNeighbours::across(std::uint32_t edge) const {
    const std::uint32_t a = TriangleEdge::start(triangles_, edge),
                        b = TriangleEdge::end(triangles_, edge);
    if (a == b) return TriangleEdge::none;
    std::uint32_t found = TriangleEdge::none;
    int same = 0, opposite = 0;
    visit_edges_of(a, b, [&](std::uint32_t other) {
        if (TriangleEdge::start(triangles_, other) == a) {
            ++same;
        } else {
            ++opposite;
            found = other;
        }
    });
    return same == 1 && opposite == 1 ? found : TriangleEdge::none;
}

}  // namespace burl
