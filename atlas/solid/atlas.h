#pragma once
// The mesh atlas: a place in the texture for every triangle of the mesh (Carr & Hart, "Real-Time
// Procedural Solid Texturing", 2001, section 4). Pixel coordinates are texels: texel (i,j) has its
// centre at (i+0.5, j+0.5), row 0 is v = 0.
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "atlas/mesh/connectivity.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// The strips of the paper's sections 4.1 and 4.2, `quad`: pairs in a quadtree
/// (docs/reference/atlases.md), and `patch`: few patches on rectangles
/// (docs/reference/patch-atlas.md).
enum class AtlasKind { uniform, area, length, quad, patch };
enum class Overscan { nearest, bilinear };
/// What a pair's share of a quad atlas follows: nothing, its area, its longest edge squared, or the
/// predicted error of lookups. The other kinds have their weight in their name.
enum class AtlasWeight { equal, area, length, error };
/// How a quad atlas finds clusters: by bisecting the pairs' coordinates, or the graph of their
/// neighbourhoods.
enum class AtlasPartition { rcb, graph };
/// Whether the two triangles of a quad atlas's pair meet on the block's diagonal, or lie apart with
/// overscan between them where they would meet in a kink: for outputs of more than 8 bits.
enum class Diagonals { shared, overscan };

struct AtlasOptions {
    AtlasKind kind = AtlasKind::patch;
    Overscan overscan = Overscan::bilinear;
    std::uint32_t size = 1024;  ///< N: the texture is exactly N x N texels; quad: a power of two
    AtlasWeight weight = AtlasWeight::error;         ///< quad only
    AtlasPartition partition = AtlasPartition::rcb;  ///< quad only
    std::uint32_t gutter = 0;  ///< quad with bilinear overscan: texels round each block's triangles
    Diagonals diagonals = Diagonals::shared;  ///< quad with bilinear overscan
    int tries = 4;  ///< patch: partitions to choose from, 1 to 6, and two along creases if any
    bool operator==(const AtlasOptions&) const = default;
};

inline constexpr std::uint32_t max_atlas_size = 16384;

/// Texels [x, x+width) x [y, y+height) shared by one or two right triangles whose legs lie along
/// the block's sides. `lower` has its right angle at the low-x, low-y end, `upper` (-1: none) is
/// turned by 180 degrees and moved right by `overscan` columns. In the block's row j (0-based) the
/// texels with column < split(j) belong to `lower`, the others to `upper` (atlas/solid/overscan.h).
/// A rising block is all this mirrored in x, so that its hypotenuse rises with x.
struct Block {
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
    std::int32_t lower = -1, upper = -1;
    bool shares_hypotenuse =
        false;                ///< the two triangles are neighbours across the diagonal: no overscan
    bool joins_left = false;  ///< its left edge is the mesh edge on the right of the block before
    std::uint32_t leg_x = 0, leg_y = 0;  ///< both triangles' legs, in texels
    std::uint32_t overscan = 0;          ///< columns between the triangles' hypotenuses
    std::uint8_t lower_corner = 0, upper_corner = 0;  ///< corners of the triangles at right angles
    bool rising = false;                              ///< mirrored in x; the triangles are not
    bool fills_up = false;  ///< a single: texels it does not read show it turned by 180 degrees
    /// Texels on all four sides that go on with the triangles; legs lie inside.
    std::uint32_t gutter = 0;
    bool shares_texel = false;  ///< lies on the one texel of a block before, which shows that one

    /// One texel wide or high with corners on texel centres: its triangles have no area there.
    bool collapsed() const { return leg_x == 0 || leg_y == 0; }
};

/// Figures of the layout that metrics and reports print.
struct LayoutNotes {
    std::uint64_t texels_total = 0;      ///< N * N
    std::uint64_t overscan_texels = 0;   ///< texels spent on overscan columns
    std::uint64_t saved_texels = 0;      ///< overscan texels saved by shared hypotenuses and strips
    std::uint64_t paired_triangles = 0;  ///< triangles whose block-mate is their mesh neighbour
    std::uint64_t strips = 0;            ///< runs of blocks that share their vertical edges
    std::uint64_t minimal_cells = 0;     ///< triangles in the narrowest cell possible: leg_x = 1;
                                         ///< quad: in blocks one texel wide or high
    std::uint64_t unread_texels = 0;     ///< quad: texels of singles that no lookup reads
    std::uint64_t gutter_texels = 0;     ///< quad: texels in gutters
    std::uint64_t narrowed_gutters = 0;  ///< quad: blocks too small for the gutter asked for
    std::uint64_t shared_texels = 0;     ///< quad: texels that stand for several pairs or singles
    std::uint64_t shared_triangles = 0;  ///< quad: triangles on those texels
    std::string fallback;  ///< why the kind is not the one asked for, one sentence; else empty
};

struct Atlas {
    AtlasOptions options;
    /// Per triangle the texel-space place of its three corners, in the mesh's corner order.
    std::vector<std::array<Vec2d, 3>> corners;
    /// Per triangle the chart it belongs to: triangles that may share exported vertices.
    std::vector<std::uint32_t> charts;
    std::uint32_t chart_count = 0;
    std::vector<Block> blocks;
    LayoutNotes notes;
    /// Of a compressed texture (atlas/blocks/compress_blocks.h), in texels; 0: options.size both
    /// ways.
    std::uint32_t width = 0, height = 0;

    Vec2d extent() const {
        return width == 0 ? Vec2d(options.size) : Vec2d(double(width), double(height));
    }
};

/// Packs the mesh into blocks; for `patch` use build_atlas (atlas/build/mesh_atlas.h). Pure and
/// deterministic: the same mesh gives the same bytes.
/// Throws Error(runtime) with the size that would do when the texture cannot hold the mesh (quad
/// holds any), and Error(usage) for a size no texture has, or quad cannot halve.
Atlas layout_atlas(const Mesh& mesh, const Connectivity& connectivity, const AtlasOptions& options);

/// Throws Error(usage) for a size no texture has, or quad cannot halve.
void check_size(const AtlasOptions& options);

/// Smallest N that gives every triangle of so many texels of its own, whatever their connectivity.
/// Strips are refused below what they need; in a quad atlas pairs then share texels.
std::uint32_t smallest_size(std::size_t triangles, const AtlasOptions& options);

std::string_view to_string(AtlasKind kind);
std::string_view to_string(Overscan overscan);
std::string_view to_string(AtlasWeight weight);
std::string_view to_string(AtlasPartition partition);
std::string_view to_string(Diagonals diagonals);

}  // namespace burl
