#include "atlas/layout_quad.h"

#include <limits>

#include "atlas/block_corners.h"
#include "atlas/overscan.h"
#include "atlas/pairing.h"
#include "atlas/quad_cells.h"
#include "atlas/quad_tree.h"

namespace burl {

namespace {

// Slivers across a short edge make pairs worse than two singles; measured in docs/atlases.md.
constexpr double good_pair_cost = 1.5;
constexpr double any_pair_cost = std::numeric_limits<double>::infinity();

Block make_block(const QuadLeaf& leaf, const QuadCell& cell, Overscan mode) {
    Block block;
    block.x = leaf.x;
    block.y = leaf.y;
    block.width = leaf.width;
    block.height = leaf.height;
    block.lower = cell.lower;
    block.upper = cell.upper;
    block.lower_corner = cell.lower_corner;
    block.upper_corner = cell.upper_corner;
    block.shares_hypotenuse = cell.upper >= 0;
    block.fills_up = cell.upper < 0;
    block.rising = leaf.turned;
    block.leg_x = leaf.width - border_texels(mode);
    block.leg_y = leaf.height - border_texels(mode);
    return block;
}

void place_block(Atlas& atlas, const Block& block) {
    const BlockCorners places = block_corners(block, atlas.options.overscan, false);
    const std::uint32_t chart = atlas.chart_count++;
    const auto place = [&](std::int32_t face, std::size_t first,
                           const std::array<Vec2d, 3>& corners) {
        for (std::size_t k = 0; k < 3; ++k)
            atlas.corners[std::size_t(face)][(first + k) % 3] = corners[k];
        atlas.charts[std::size_t(face)] = chart;
    };
    place(block.lower, block.lower_corner, places.lower);
    if (block.upper >= 0) place(block.upper, block.upper_corner, places.upper);
}

void note_block(LayoutNotes& notes, const Block& block, Overscan mode) {
    const bool narrow = block.width == 1 || block.height == 1;
    if (narrow) notes.minimal_cells += block.upper >= 0 ? 2 : 1;
    if (block.shares_hypotenuse) {
        notes.paired_triangles += 2;
        if (!block.collapsed())
            notes.saved_texels +=
                std::uint64_t{overscan_columns(mode, block.leg_x, block.leg_y)} * block.height;
        return;
    }
    for (std::uint32_t j = 0; j < block.height; ++j)
        notes.unread_texels += block.width - split(block, mode, j);
}

}  // namespace

std::optional<Atlas> layout_quad(const Mesh& mesh, const Connectivity& connectivity,
                                 const AtlasOptions& options) {
    Atlas atlas;
    atlas.options = options;
    atlas.notes.texels_total = std::uint64_t{options.size} * options.size;
    const std::vector<std::int32_t> opposite = opposite_half_edges(mesh, connectivity);
    std::vector<QuadCell> cells = make_quad_cells(mesh, opposite, options.weight, good_pair_cost);
    if (cells.size() > atlas.notes.texels_total)
        cells = make_quad_cells(mesh, opposite, options.weight, any_pair_cost);
    if (cells.size() > atlas.notes.texels_total) return std::nullopt;
    atlas.corners.resize(mesh.triangles.size());
    atlas.charts.resize(mesh.triangles.size());
    atlas.blocks.reserve(cells.size());
    for (const QuadLeaf& leaf : plan_quad_tree(cells, options.size, options.overscan)) {
        atlas.blocks.push_back(make_block(leaf, cells[leaf.cell], options.overscan));
        place_block(atlas, atlas.blocks.back());
        note_block(atlas.notes, atlas.blocks.back(), options.overscan);
    }
    return atlas;
}

}  // namespace burl
