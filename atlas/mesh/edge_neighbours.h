#pragma once
// The triangle across an edge, found when it is asked for: a list of each point's triangles takes a
// tenth of the time that half-edges of the whole mesh take, where only some edges are looked at.
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/mesh/mesh.h"

namespace burl {

/// The edge that runs from corner k of triangle t to corner (k+1)%3 is number 3t+k.
struct TriangleEdge {
    static constexpr std::uint32_t none = 0xffffffffu;

    static std::uint32_t start(std::span<const Triangle> triangles, std::uint32_t edge) {
        return triangles[edge / 3][edge % 3];
    }
    static std::uint32_t end(std::span<const Triangle> triangles, std::uint32_t edge) {
        return triangles[edge / 3][(edge % 3 + 1) % 3];
    }
};

/// The triangles round every point; triangles and positions must outlive it.
class EdgeNeighbours {
  public:
    EdgeNeighbours(std::span<const Triangle> triangles, std::span<const Vec3d> positions);

    /// Number of the edge in the triangle on its other side, which runs along it the other
    /// way; none where the edge is open, has a third triangle, or two that run along it the same
    /// way. Triangles on the same points count once, and the first of them is taken; triangles
    /// without area count only where there are no others.
    std::uint32_t across(std::uint32_t edge) const;

    /// Calls visit(other) for every triangle's edge that runs from the end of `edge` to its start.
    template <class Visit>
    void visit_opposite(std::uint32_t edge, const Visit& visit) const {
        const std::uint32_t a = TriangleEdge::start(triangles_, edge),
                            b = TriangleEdge::end(triangles_, edge);
        visit_edges_of(a, b, [&](std::uint32_t other) {
            if (TriangleEdge::start(triangles_, other) == b) visit(other);
        });
    }

  private:
    std::span<const std::uint32_t> triangles_at(std::uint32_t point) const {
        return {list_.data() + begin_[point], begin_[point + 1] - begin_[point]};
    }

    /// Calls visit(edge) for every triangle's edge between the points a and b, either way.
    template <class Visit>
    void visit_edges_of(std::uint32_t a, std::uint32_t b, const Visit& visit) const {
        const std::span<const std::uint32_t> at_a = triangles_at(a), at_b = triangles_at(b);
        for (const std::uint32_t t : at_a.size() < at_b.size() ? at_a : at_b)
            for (std::uint32_t edge = 3 * t; edge < 3 * t + 3; ++edge) {
                const std::uint32_t p = TriangleEdge::start(triangles_, edge),
                                    q = TriangleEdge::end(triangles_, edge);
                if ((p == a && q == b) || (p == b && q == a)) visit(edge);
            }
    }

    std::uint32_t third_point(std::uint32_t edge) const {
        return triangles_[edge / 3][(edge % 3 + 2) % 3];
    }
    bool has_area(std::uint32_t triangle) const;

    std::span<const Triangle> triangles_;
    std::span<const Vec3d> positions_;
    std::vector<std::uint32_t> begin_, list_;  ///< triangles sorted by point
};

}  // namespace burl
