#pragma once
// The solid (3-D) point of every texel (Carr & Hart 2001, section 5.1), as rows of spans:
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

/// The affine map that takes three places in the texture to points, anchored at the texel of a
/// rectangle (its low texel and its sides) that is nearest to the first place. It is constant where
/// the places are on a line or not finite.
TexelMap affine_map(const std::array<Vec2d, 3>& places, const std::array<Vec3d, 3>& points,
                    const std::array<std::uint32_t, 2>& low,
                    const std::array<std::uint32_t, 2>& sides);

/// Texels [x, x+count) of one row, all of which show (or extrapolate) one triangle by one map.
struct Span {
    std::uint32_t x = 0, count = 0, map = 0;
};

/// The uncut span that a part was cut from (cut_to() in texel_set.h).
struct WholeSpan {
    std::uint32_t x = 0, count = 0;
};

/// The solid points of all texels of a square texture; texels in no span show nothing.
struct SolidAtlas {
    std::uint32_t size = 0;              ///< N, the texture's side in texels
    std::vector<Span> spans;             ///< ordered by row, then x; spans of a row never overlap
    std::vector<std::size_t> row_begin;  ///< N+1 offsets into spans, row by row
    /// The maps of the triangles, in the space of the positions given, then one for each element of
    /// `turned`.
    std::vector<TexelMap> maps;
    /// Triangles of the additional maps: those shown a second time, turned by 180 degrees to fill
    /// up a block (no lookup reads them, averages over the block do), and those that a patch's
    /// gutters continue. turned[k] is shown by maps[maps.size() - turned.size() + k].
    std::vector<std::uint32_t> turned;
    /// Uncut span of each span, in an atlas cut to some of its texels; the host works out a part's
    /// texels from the uncut span's start on. Empty: all spans are whole.
    std::vector<WholeSpan> wholes{};

    /// The uncut span of `span`, which must be an element of `spans`.
    WholeSpan whole(const Span& span) const {
        if (wholes.empty()) return {span.x, span.count};
        return wholes[std::size_t(&span - spans.data())];
    }
    /// The spans of row y, from left to right.
    std::span<const Span> row(std::size_t y) const {
        return {spans.data() + row_begin[y], row_begin[y + 1] - row_begin[y]};
    }
    /// The triangle that map number `map` shows.
    std::uint32_t triangle_of(std::uint32_t map) const {
        const std::size_t triangles = maps.size() - turned.size();
        return map < triangles ? map : turned[map - triangles];
    }
};

/// The solid points of a strip or quad atlas's texels; `positions` are the mesh's points in the
/// space wanted (mesh.positions, or these mapped to the unit box). Every texel of every block has
/// exactly one owner; a centre exactly on a shared edge belongs to `lower`.
SolidAtlas rasterize(const Mesh& mesh, const Atlas& atlas, std::span<const Vec3d> positions);

/// The space of solid points: the mesh's box scaled to the unit box, or the mesh's own coordinates.
enum class SolidSpace { unit, object };
template <>
inline constexpr auto enum_names<SolidSpace> = enum_words("unit", "object");

/// The map from mesh coordinates to solid space: `unit` takes the box's centre to the origin and
/// its longest side to 1, `object` is the identity.
Affine3 solid_from_mesh(const Mesh& mesh, SolidSpace space);

/// All points of the mesh moved by `map`, in double.
std::vector<Vec3d> map_positions(const Mesh& mesh, const Affine3& map);

}  // namespace burl
