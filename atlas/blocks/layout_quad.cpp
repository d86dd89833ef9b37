#include "atlas/blocks/layout_quad.h"

#include <algorithm>
#include <limits>

#include "atlas/base/each_index.h"
#include "atlas/blocks/pairing.h"
#include "atlas/blocks/quad_cells.h"
#include "atlas/blocks/quad_graph.h"
#include "atlas/blocks/quad_tree.h"
#include "atlas/blocks/quad_turns.h"
#include "atlas/solid/block_corners.h"
#include "atlas/solid/overscan.h"

namespace burl {

namespace {

// Largest number of texels of a pair relative to that of two singles: slivers across a short edge
// make pairs worse than two singles (measured in docs/reference/atlases.md).
constexpr double good_pair_cost = 1.5;
constexpr double any_pair_cost = std::numeric_limits<double>::infinity();

// Kink (QuadCell::kink) from which the bend on a pair's diagonal is most of the error, in blocks
// whose shorter leg has at least `least_parted_leg` texels; overscan between the triangles removes
// it, at the price of shorter legs.
constexpr double noticed_kink = 0.2;
constexpr std::uint32_t least_parted_leg = 20;

/// Moves the two triangles of a pair apart, with overscan between them, where they meet in a
/// noticed kink and the columns cost at most a third of the block's width.
void part_diagonal(Block& block, const QuadCell& cell, Overscan mode) {
    if (cell.kink < noticed_kink || std::min(block.leg_x, block.leg_y) < least_parted_leg) return;
    const std::uint32_t columns = block.leg_x + border_texels(mode);
    const std::uint32_t leg = longest_leg(mode, columns, block.leg_y);
    if (3 * (block.leg_x - leg) > block.width) return;
    block.shares_hypotenuse = false;
    block.overscan = block.leg_x - leg;
    block.leg_x = leg;
}

Block make_block(const QuadLeaf& leaf, const QuadCell& cell, const AtlasOptions& options) {
    const Overscan mode = options.overscan;
    Block block;
    block.x = leaf.x;
    block.y = leaf.y;
    block.width = leaf.width;
    block.height = leaf.height;
    block.lower = cell.lower;
    block.upper = cell.upper;
    block.lower_corner = cell.lower_corner;
    block.upper_corner = cell.upper_corner;
    if (leaf.exchanged) {
        std::swap(block.lower, block.upper);
        std::swap(block.lower_corner, block.upper_corner);
    }
    block.shares_hypotenuse = cell.upper >= 0;
    block.fills_up = cell.upper < 0;
    block.rising = leaf.turned;
    block.shares_texel = leaf.shares_texel;
    if (leaf.shares_texel) return block;  // without legs
    block.gutter = quad_gutter(options, leaf.width, leaf.height);
    block.leg_x = leaf.width - border_texels(mode) - 2 * block.gutter;
    block.leg_y = leaf.height - border_texels(mode) - 2 * block.gutter;
    if (options.diagonals == Diagonals::overscan && mode == Overscan::bilinear && cell.upper >= 0)
        part_diagonal(block, cell, mode);
    return block;
}

void place_corners(Atlas& atlas, const Block& block) {
    const BlockCorners places = block_corners(block, atlas.options.overscan, false);
    const auto place = [&](std::int32_t face, std::size_t first,
                           const std::array<Vec2d, 3>& corners) {
        for (std::size_t k = 0; k < 3; ++k)
            atlas.corners[std::size_t(face)][(first + k) % 3] = corners[k];
    };
    place(block.lower, block.lower_corner, places.lower);
    if (block.upper >= 0) place(block.upper, block.upper_corner, places.upper);
}

/// Numbers the charts of a block's triangles: triangles moved apart are charts of their own; all
/// triangles on a shared texel are one chart.
void number_charts(Atlas& atlas, const Block& block) {
    if (!block.shares_texel) ++atlas.chart_count;
    atlas.charts[std::size_t(block.lower)] = atlas.chart_count - 1;
    if (block.upper < 0) return;
    if (block.overscan > 0) ++atlas.chart_count;
    atlas.charts[std::size_t(block.upper)] = atlas.chart_count - 1;
}

std::uint64_t gutter_texels(const Block& block) {
    return std::uint64_t{block.width} * block.height -
           std::uint64_t{block.width - 2 * block.gutter} * (block.height - 2 * block.gutter);
}

void note_block(LayoutNotes& notes, const Block& block, const AtlasOptions& options) {
    const Overscan mode = options.overscan;
    const bool narrow = block.width == 1 || block.height == 1;
    if (narrow) notes.minimal_cells += block.upper >= 0 ? 2 : 1;
    notes.gutter_texels += gutter_texels(block);
    if (mode == Overscan::bilinear && block.gutter < options.gutter) ++notes.narrowed_gutters;
    notes.overscan_texels += std::uint64_t{block.overscan} * block.height;
    if (block.upper >= 0) {
        notes.paired_triangles += 2;
        if (!block.collapsed() && block.shares_hypotenuse)
            notes.saved_texels +=
                std::uint64_t{overscan_columns(mode, block.leg_x, block.leg_y)} * block.height;
        return;
    }
    if (block.shares_texel) return;
    for (std::uint32_t j = 0; j < block.height; ++j)
        notes.unread_texels += block.width - split(block, mode, j);
}

void note_shared(Atlas& atlas) {
    const auto triangles = [](const Block& block) { return block.upper >= 0 ? 2u : 1u; };
    for (std::size_t i = 1; i < atlas.blocks.size(); ++i) {
        if (!atlas.blocks[i].shares_texel) continue;
        atlas.notes.shared_triangles += triangles(atlas.blocks[i]);
        if (atlas.blocks[i - 1].shares_texel) continue;
        ++atlas.notes.shared_texels;
        atlas.notes.shared_triangles += triangles(atlas.blocks[i - 1]);
    }
}

std::vector<QuadLeaf> plan(const Mesh& mesh, std::span<const std::int32_t> opposite,
                           std::span<const QuadCell> cells, const AtlasOptions& options) {
    if (options.partition == AtlasPartition::rcb)
        return plan_quad_tree(cells, options, {halve_by_place, true});
    QuadGraph graph(mesh, opposite, cells);
    const auto halve = [&graph](std::span<QuadItem> items, const HalfBounds& bounds) {
        return graph.halve(items, bounds);
    };
    return plan_quad_tree(cells, options, {halve, false});
}

}  // namespace

Atlas layout_quad(const Mesh& mesh, const Connectivity& connectivity, const AtlasOptions& options) {
    Atlas atlas;
    atlas.options = options;
    atlas.notes.texels_total = std::uint64_t{options.size} * options.size;
    const std::vector<std::int32_t> opposite = opposite_half_edges(mesh, connectivity);
    std::vector<QuadCell> cells = make_quad_cells(mesh, opposite, options.weight, good_pair_cost);
    if (cells.size() > atlas.notes.texels_total)
        cells = make_quad_cells(mesh, opposite, options.weight, any_pair_cost);
    atlas.corners.resize(mesh.triangles.size());
    atlas.charts.resize(mesh.triangles.size());
    std::vector<QuadLeaf> leaves = plan(mesh, opposite, cells, options);
    if (leaves.size() <= atlas.notes.texels_total) turn_to_neighbours(leaves, cells, mesh);
    atlas.blocks.resize(leaves.size());
    for_each_index(leaves.size(), [&](std::size_t i) {
        atlas.blocks[i] = make_block(leaves[i], cells[leaves[i].cell], options);
        place_corners(atlas, atlas.blocks[i]);
    });
    for (const Block& block : atlas.blocks) {
        number_charts(atlas, block);
        note_block(atlas.notes, block, options);
    }
    note_shared(atlas);
    return atlas;
}

}  // namespace burl
