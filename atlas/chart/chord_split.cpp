// Splitting by cases: a triangle with one, two or three chords becomes two, three or four. Pieces
// are joined through a table of the halves of each original edge, so no search for neighbours is
// needed.
#include "atlas/chart/chord_split.h"

#include <array>

namespace burl {
namespace {

constexpr std::uint32_t no_vertex = 0xffffffffu;
/// A piece of a split triangle. Its edge is 2k+j for half j (0: the half at the edge's start) of
/// the triangle's edge k, or -1 minus the number of the piece on the other side for an edge within
/// the triangle.
struct Piece {
    Triangle vertices;
    std::array<int, 3> edges;
};

constexpr int within(int piece) {
    return -1 - piece;
}

/// The pieces of a triangle whose edge k has the middle vertex m[k] or no_vertex. An unsplit edge
/// is a single half 2k.
std::vector<Piece> pieces_of(const Triangle& t, const std::array<std::uint32_t, 3>& m) {
    const int count = (m[0] != no_vertex) + (m[1] != no_vertex) + (m[2] != no_vertex);
    if (count == 0) return {{t, {0, 2, 4}}};
    if (count == 3)
        return {{{t[0], m[0], m[2]}, {0, within(3), 5}},
                {{t[1], m[1], m[0]}, {2, within(3), 1}},
                {{t[2], m[2], m[1]}, {4, within(3), 3}},
                {{m[0], m[1], m[2]}, {within(1), within(2), within(0)}}};
    // Turn the triangle so that its edge 0 is split and, of two, edge 2 is not.
    std::size_t first = 0;
    while (m[first] == no_vertex || (count == 2 && m[(first + 2) % 3] != no_vertex)) ++first;
    const std::size_t second = (first + 1) % 3, third = (first + 2) % 3;
    const std::uint32_t a = t[first], b = t[second], c = t[third];
    const int e0 = 2 * int(first), e1 = 2 * int(second), e2 = 2 * int(third);
    const std::uint32_t p = m[first], q = m[second];
    if (count == 1) return {{{a, p, c}, {e0, within(1), e2}}, {{p, b, c}, {e0 + 1, e1, within(0)}}};
    return {{{p, b, q}, {e0 + 1, e1, within(1)}},
            {{p, q, c}, {within(0), e1 + 1, within(2)}},
            {{a, p, c}, {e0, within(1), e2}}};
}

/// Puts a vertex into the middle of every chord; returns its number for each half-edge, or
/// no_vertex.
std::vector<std::uint32_t> middles(Patch& patch, std::span<const SideMask> sides) {
    std::vector<std::uint32_t> middle(3 * patch.triangles.size(), no_vertex);
    for (HalfEdge h = 0; h < middle.size(); ++h) {
        if (patch.on_border(h) || middle[h] != no_vertex) continue;
        const std::uint32_t a = patch.start(h), b = patch.end(h);
        if ((sides[a] & sides[b]) == 0) continue;
        middle[h] = middle[patch.across(h)] = static_cast<std::uint32_t>(patch.points.size());
        patch.points.push_back(0.5 * patch.points[a] + 0.5 * patch.points[b]);
        const VertexOrigin &from = patch.origins[a], &to = patch.origins[b];
        // Ends lie on the border, so both are points of the mesh.
        patch.origins.push_back({from.a, to.a});
    }
    return middle;
}

}  // namespace

std::uint32_t split_chords(Patch& patch, std::span<const SideMask> sides) {
    const auto before = static_cast<std::uint32_t>(patch.points.size());
    const std::vector<std::uint32_t> middle = middles(patch, sides);
    if (patch.points.size() == before) return 0;
    Patch result;
    result.points = patch.points;
    result.origins = patch.origins;
    const std::size_t triangles = patch.triangles.size() + 2 * (patch.points.size() - before);
    result.triangles.reserve(triangles);
    result.neighbours.reserve(triangles);
    result.faces.reserve(triangles);
    std::vector<std::array<HalfEdge, 2>> halves(middle.size());  // new half-edges by old one
    for (std::uint32_t t = 0; t < patch.triangles.size(); ++t) {
        const auto base = static_cast<std::int32_t>(result.triangles.size());
        for (const Piece& piece :
             pieces_of(patch.triangles[t], {middle[3 * t], middle[3 * t + 1], middle[3 * t + 2]})) {
            auto& sides_of_piece = result.neighbours.emplace_back();
            for (std::size_t k = 0; k < 3; ++k) {
                const int edge = piece.edges[k];
                sides_of_piece[k] = edge < 0 ? base - 1 - edge : -1;
                if (edge < 0) continue;
                halves[3 * t + std::size_t(edge) / 2][std::size_t(edge) % 2] =
                    static_cast<HalfEdge>(3 * result.triangles.size() + k);
            }
            result.triangles.push_back(piece.vertices);
            result.faces.push_back(patch.faces[t]);
        }
    }
    for (HalfEdge h = 0; h < middle.size(); ++h) {
        if (patch.on_border(h)) continue;
        const HalfEdge other = patch.across(h);
        const std::size_t count = middle[h] == no_vertex ? 1 : 2;
        for (std::size_t j = 0; j < count; ++j)
            result.neighbours[halves[h][j] / 3][halves[h][j] % 3] =
                static_cast<std::int32_t>(halves[other][count - 1 - j] / 3);
    }
    for (const auto& loop : patch.loops) {
        auto& edges = result.loops.emplace_back();
        for (const HalfEdge h : loop) edges.push_back(halves[h][0]);
    }
    const auto added = static_cast<std::uint32_t>(patch.points.size()) - before;
    patch = std::move(result);
    return added;
}

std::uint32_t split_border_chords(Patch& patch) {
    std::vector<SideMask> border(patch.points.size(), 0);
    for (const HalfEdge h : patch.loops[0]) border[patch.start(h)] = 1;
    return split_chords(patch, border);
}

}  // namespace burl
