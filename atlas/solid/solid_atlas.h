#pragma once
// Which solid (3-D) point every texel shows (Carr & Hart 2001, section 5.1), as rows of spans:
// coordinates are never stored per texel nor as world-space floats; a texel's point is an affine
// map, evaluated in float64.
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/solid/atlas.h"

namespace burl {

/// The solid point of texel (x,y), centre (x+0.5, y+0.5): origin + (x - anchor_x) * step_x + (y -
/// anchor_y) * step_y. `origin` is the point of texel (anchor_x, anchor_y), a texel of the
/// triangle's own block, so that the differences are small integers and nothing cancels.
struct TexelMap {
    Vec3d origin{0.0}, step_x{0.0}, step_y{0.0};
    std::int32_t anchor_x = 0, anchor_y = 0;

    Vec3d operator()(std::int64_t x, std::int64_t y) const {
        return origin + double(x - anchor_x) * step_x + double(y - anchor_y) * step_y;
    }
};

/// Texels [x, x+count) of one row, all showing (or extrapolating) one triangle by one map.
struct Span {
    std::uint32_t x = 0, count = 0, map = 0;
};

/// The span that a part was cut from (solid_tiles.h).
struct WholeSpan {
    std::uint32_t x = 0, count = 0;
};

struct SolidAtlas {
    std::uint32_t size = 0;              ///< N
    std::vector<Span> spans;             ///< by row, then x; spans of a row never overlap
    std::vector<std::size_t> row_begin;  ///< N+1 offsets into spans
    /// Per triangle, in the space of the positions given; then per element of `turned`.
    std::vector<TexelMap> maps;
    /// Triangles shown a second time, turned by 180 degrees to fill up a block (no lookup reads
    /// them, averages over the block do), and those that a patch's gutters go on from: turned[k] by
    /// maps[maps.size() - turned.size() + k].
    std::vector<std::uint32_t> turned;
    /// Of an atlas cut to some of its texels, per span the one it is a part of, from whose start
    /// on the host works out its texels; empty: spans are whole.
    std::vector<WholeSpan> wholes{};

    /// `span` is one of this atlas's own.
    WholeSpan whole(const Span& span) const {
        if (wholes.empty()) return {span.x, span.count};
        return wholes[std::size_t(&span - spans.data())];
    }
    std::span<const Span> row(std::size_t y) const {
        return {spans.data() + row_begin[y], row_begin[y + 1] - row_begin[y]};
    }
    std::uint32_t triangle_of(std::uint32_t map) const {
        const std::size_t triangles = maps.size() - turned.size();
        return map < triangles ? map : turned[map - triangles];
    }
};

/// `positions` are the mesh's points in the space wanted (mesh.positions, or these mapped to the
/// unit box). Every texel of every block has exactly one owner; a centre exactly on a shared edge
/// belongs to `lower`.
SolidAtlas rasterize(const Mesh& mesh, const Atlas& atlas, std::span<const Vec3d> positions);

enum class SolidSpace { unit, object };

/// Map from mesh coordinates to solid space: `unit` takes the box's centre to the origin and its
/// longest side to 1, `object` is the identity.
Affine3 solid_from_mesh(const Mesh& mesh, SolidSpace space);

/// All points of the mesh through `map`, in double.
std::vector<Vec3d> map_positions(const Mesh& mesh, const Affine3& map);

}  // namespace burl
