#pragma once
// The mesh atlas: a place in the texture for every triangle of the mesh (Carr & Hart, "Real-Time
// Procedural Solid Texturing", 2001, section 4). Pixel coordinates are texels: texel (i,j) has its
// centre at (i+0.5, j+0.5), row 0 is v = 0.
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "atlas/base/enum_names.h"
#include "atlas/mesh/connectivity.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// Kinds of layout: the strips of the paper's sections 4.1 and 4.2 with blocks of equal size
/// (uniform), weighted by triangle area (area) or by longest edge (length); `quad`, pairs in a
/// quadtree (docs/reference/atlases.md); `patch`, few patches on rectangles
/// (docs/reference/patch-atlas.md); `chart`, nearly isometric charts with free outlines
/// (docs/reference/chart-atlas.md); `uv`, the mesh's own texture coordinates
/// (docs/reference/uv-atlas.md).
enum class AtlasKind { uniform, area, length, quad, patch, chart, uv };
/// Whether the kind lays pairs of triangles in rows.
constexpr bool is_strips(AtlasKind kind) {
    return kind < AtlasKind::quad;
}
/// Whether charts of the kind have outlines of any form, and texels between charts show the nearest
/// one.
constexpr bool has_outlines(AtlasKind kind) {
    return kind == AtlasKind::chart || kind == AtlasKind::uv;
}
/// The texture lookup for which overscan is counted: it must not read texels of an unrelated
/// triangle.
enum class Overscan { nearest, bilinear };
/// The weight by which a quad atlas gives pairs their share of the texture: equal shares, area,
/// longest edge squared, or the predicted error of lookups. The other kinds have their weight in
/// their name.
enum class AtlasWeight { equal, area, length, error };
/// The method by which a quad atlas finds clusters: recursive bisection of the pairs' coordinates
/// (rcb), or of the graph of their neighbourhoods.
enum class AtlasPartition { rcb, graph };
/// Whether the two triangles of a quad atlas's pair meet on the block's diagonal, or lie apart with
/// overscan between them where they would meet in a kink: for outputs of more than 8 bits.
enum class Diagonals { shared, overscan };
/// Texels that several triangles of a uv atlas claim, as mirrored halves and stacked charts do:
/// refused, or shown as the first of these triangles.
enum class UvOverlap { refuse, first };

template <>
inline constexpr auto enum_names<AtlasKind> = enum_words("uniform", "area", "length", "quad",
                                                         "patch", "chart", "uv");
template <>
inline constexpr auto enum_names<Overscan> = enum_words("nearest", "bilinear");
template <>
inline constexpr auto enum_names<AtlasWeight> = enum_words("equal", "area", "length", "error");
template <>
inline constexpr auto enum_names<AtlasPartition> = enum_words("rcb", "graph");
template <>
inline constexpr auto enum_names<Diagonals> = enum_words("shared", "overscan");
template <>
inline constexpr auto enum_names<UvOverlap> = enum_words("refuse", "first");

/// A user's choices for an atlas.
struct AtlasOptions {
    AtlasKind kind = AtlasKind::chart;
    Overscan overscan = Overscan::bilinear;
    /// N: the texture is exactly N x N texels; a power of two for quad.
    std::uint32_t size = 1024;
    AtlasWeight weight = AtlasWeight::error;         ///< weight of pairs; quad only
    AtlasPartition partition = AtlasPartition::rcb;  ///< clustering; quad only
    /// Texels round each block's triangles; quad with bilinear overscan only.
    std::uint32_t gutter = 0;
    Diagonals diagonals = Diagonals::shared;  ///< quad with bilinear overscan only
    /// Partitions to choose from, 1 to 6, besides two along creases if any; patch only.
    int tries = 4;
    UvOverlap overlap = UvOverlap::refuse;  ///< uv only
    /// Columns and rows of a texture that is not square, the larger of which is `size`; 0: `size`;
    /// uv only.
    std::uint32_t width = 0, height = 0;
    /// The UDIM tile that the texture shows, such as 1001 for [0, 1] x [0, 1]; 0: the coordinates
    /// must lie in that square; uv only.
    std::uint32_t tile = 0;
    bool operator==(const AtlasOptions&) const = default;

    std::uint32_t columns() const { return width == 0 ? size : width; }
    std::uint32_t rows() const { return height == 0 ? size : height; }
};

/// Largest side of a texture, in texels.
inline constexpr std::uint32_t max_atlas_size = 16384;

/// Texels [x, x+width) x [y, y+height) shared by one or two right triangles whose legs lie along
/// the block's sides. `lower` has its right angle at the low-x, low-y end, `upper` (-1: none) is
/// turned by 180 degrees and moved right by `overscan` columns. In the block's row j (0-based) the
/// texels with column < split(j) belong to `lower`, the others to `upper` (atlas/solid/block.h).
/// In a rising block all this is mirrored in x, so that the hypotenuse rises with x.
struct Block {
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
    std::int32_t lower = -1, upper = -1;
    /// The two triangles are neighbours across the diagonal, so that they need no overscan.
    bool shares_hypotenuse = false;
    bool joins_left = false;  ///< left edge is the mesh edge on the right of the block before
    std::uint32_t leg_x = 0, leg_y = 0;  ///< legs of both triangles, in texels
    std::uint32_t overscan = 0;          ///< columns between the triangles' hypotenuses
    std::uint8_t lower_corner = 0, upper_corner = 0;  ///< corners of the triangles at right angles
    bool rising = false;                              ///< layout mirrored in x, not the triangles
    /// Texels of a block with one triangle that no lookup reads show that triangle turned by 180
    /// degrees.
    bool fills_up = false;
    /// Width, in texels, of the border on all four sides into which the triangles are continued;
    /// the legs lie inside it.
    std::uint32_t gutter = 0;
    /// The block lies on the one texel of an earlier block, which shows the earlier block's
    /// triangles.
    bool shares_texel = false;

    /// Whether the block is one texel wide or high with corners on texel centres, so that its
    /// triangles have no area in the texture.
    bool collapsed() const { return leg_x == 0 || leg_y == 0; }
};

/// Figures of the layout that metrics and reports print.
struct LayoutNotes {
    std::uint64_t texels_total = 0;      ///< N * N
    std::uint64_t overscan_texels = 0;   ///< texels spent on overscan columns
    std::uint64_t saved_texels = 0;      ///< overscan texels saved by shared hypotenuses and strips
    std::uint64_t paired_triangles = 0;  ///< triangles that share a block with a mesh neighbour
    std::uint64_t strips = 0;            ///< runs of blocks that share their vertical edges
    /// Triangles in the narrowest cell possible (leg_x = 1); for quad in blocks one texel wide or
    /// high.
    std::uint64_t minimal_cells = 0;
    std::uint64_t unread_texels = 0;     ///< texels of single triangles that no lookup reads (quad)
    std::uint64_t gutter_texels = 0;     ///< texels in gutters (quad)
    std::uint64_t narrowed_gutters = 0;  ///< blocks too small for the gutter asked for (quad)
    std::uint64_t shared_texels = 0;     ///< texels that stand for several pairs or singles (quad)
    std::uint64_t shared_triangles = 0;  ///< triangles on shared texels (quad)
    std::uint64_t overlapped_texels = 0;      ///< texels with more than one triangle's inside (uv)
    std::uint64_t overlapping_triangles = 0;  ///< triangles that share such a texel (uv)
    std::uint64_t flat_triangles = 0;         ///< triangles without area in the texture (uv)
    std::string fallback;  ///< one sentence on why the kind is not the one asked for; else empty
};

/// A laid-out texture: the texel-space corners of all triangles, and the layout they come from.
struct Atlas {
    AtlasOptions options;
    /// Texel-space places of each triangle's three corners, in the mesh's corner order.
    std::vector<std::array<Vec2d, 3>> corners;
    /// Chart that each triangle belongs to, < chart_count; triangles of a chart may share exported
    /// vertices.
    std::vector<std::uint32_t> charts;
    std::uint32_t chart_count = 0;
    /// For each triangle the earlier one on the same points whose place it shares, or itself;
    /// empty: no triangle shares another's place so (chart).
    std::vector<std::uint32_t> copy_of;
    std::vector<Block> blocks;
    LayoutNotes notes;
    /// Size in texels of a compressed texture (atlas/blocks/compress_blocks.h), or of one that is
    /// not square; 0: options.size both ways.
    std::uint32_t width = 0, height = 0;

    /// Whether triangle t shares the place of a triangle on the same points.
    bool is_copy(std::size_t t) const { return !copy_of.empty() && copy_of[t] != t; }

    /// Width and height of the texture in texels.
    Vec2d extent() const {
        return width == 0 ? Vec2d(options.size) : Vec2d(double(width), double(height));
    }
};

/// Packs the mesh into blocks; for `patch` use build_atlas() (atlas/build/mesh_atlas.h). Pure and
/// deterministic: the same mesh gives the same bytes.
/// Throws Error(runtime) with a sufficient size when the texture cannot hold the mesh (quad holds
/// any), and Error(usage) for an invalid size (see check_size()).
Atlas layout_atlas(const Mesh& mesh, const Connectivity& connectivity, const AtlasOptions& options);

/// Throws Error(usage) for a size outside the range of textures, or one that quad cannot halve.
void check_size(const AtlasOptions& options);

/// Smallest N that gives each of so many triangles texels of its own, whatever their connectivity.
/// Strips are refused below the size they need; in a quad atlas pairs then share texels.
std::uint32_t smallest_size(std::size_t triangles, const AtlasOptions& options);

}  // namespace burl
