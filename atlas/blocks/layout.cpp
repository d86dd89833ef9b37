// The three strip atlases of Carr & Hart 2001, sections 4.1 and 4.2: weigh the triangles, pair
// neighbours, order pairs into strips, plan rows, and put every triangle's corners into its block.
// The quad atlas is laid out by atlas/blocks/layout_quad.
#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "atlas/base/error.h"
#include "atlas/blocks/layout_quad.h"
#include "atlas/blocks/layout_rows.h"
#include "atlas/blocks/pairing.h"
#include "atlas/blocks/strips.h"
#include "atlas/solid/atlas.h"
#include "atlas/solid/block.h"
#include "atlas/solid/weights.h"

namespace burl {

namespace {

/// Largest ratios of weights of partners and within a strip; measured in docs/reference/atlases.md.
struct Likeness {
    double pair_ratio = 2.0, strip_ratio = 3.0;
};

Block make_block(const Cell& cell, const AtlasOptions& options, const CellRow& row, std::uint32_t x,
                 std::uint32_t width, bool first) {
    const std::uint32_t border = border_texels(options.overscan);
    Block block;
    block.x = x;
    block.y = row.y;
    block.width = width;
    block.height = row.height;
    block.lower = cell.lower;
    block.upper = cell.upper;
    block.lower_corner = static_cast<std::uint8_t>(cell.lower_corner);
    block.upper_corner = static_cast<std::uint8_t>(cell.upper_corner);
    block.shares_hypotenuse = cell.shares_hypotenuse;
    block.joins_left = cell.joins_previous && !first;
    block.leg_y = row.height - border;
    block.leg_x = width - (block.joins_left ? 0 : border);
    if (cell.holds_strangers()) {
        block.leg_x = longest_leg(options.overscan, width, block.leg_y);
        block.overscan = width - border - block.leg_x;
    }
    return block;
}

std::vector<Block> make_blocks(std::span<const Cell> cells, const RowPlan& plan,
                               const AtlasOptions& options) {
    std::vector<Block> blocks;
    blocks.reserve(cells.size());
    for (const CellRow& row : plan.rows) {
        std::uint32_t x = 0;
        for (std::size_t i = row.first; i < row.first + row.count; ++i) {
            blocks.push_back(make_block(cells[i], options, row, x, plan.widths[i], i == row.first));
            x += plan.widths[i];
        }
    }
    return blocks;
}

bool joins_right(const Atlas& atlas, std::size_t block) {
    return block + 1 < atlas.blocks.size() && atlas.blocks[block + 1].joins_left;
}

/// Numbers the charts: a strip is one chart; two unrelated triangles in a block are two.
void number_charts(Atlas& atlas) {
    for (const Block& block : atlas.blocks) {
        const std::uint32_t chart = block.joins_left ? atlas.chart_count - 1 : atlas.chart_count++;
        atlas.charts[std::size_t(block.lower)] = chart;
        if (block.upper >= 0)
            atlas.charts[std::size_t(block.upper)] =
                block.shares_hypotenuse ? chart : atlas.chart_count++;
    }
}

void note_block(LayoutNotes& notes, const Block& block, Overscan mode) {
    const std::uint64_t rows = block.height;
    const std::uint64_t triangles = block.upper >= 0 ? 2 : 1;
    notes.overscan_texels += block.overscan * rows;
    if (block.leg_x == 1) notes.minimal_cells += triangles;
    if (block.shares_hypotenuse) {
        notes.paired_triangles += 2;
        notes.saved_texels += overscan_columns(mode, block.leg_x, block.leg_y) * rows;
    }
    if (block.joins_left) notes.saved_texels += border_texels(mode) * rows;
}

LayoutNotes layout_notes(const Atlas& atlas) {
    LayoutNotes notes;
    notes.texels_total = std::uint64_t{atlas.options.size} * atlas.options.size;
    for (std::size_t i = 0; i < atlas.blocks.size(); ++i) {
        note_block(notes, atlas.blocks[i], atlas.options.overscan);
        if (joins_right(atlas, i) && !atlas.blocks[i].joins_left) ++notes.strips;
    }
    return notes;
}

Error does_not_fit(const Mesh& mesh, const AtlasOptions& options) {
    const std::string name = mesh.name.empty() ? "the mesh" : mesh.name;
    const std::string problem = fmt::format(
        "{0} has {1} triangles, which do not fit a {2} x {2} texture with this overscan", name,
        mesh.triangles.size(), options.size);
    const std::uint32_t enough = smallest_size(mesh.triangles.size(), options);
    if (enough > max_atlas_size)
        return Error(ExitCode::runtime, problem + "; use a mesh with fewer triangles");
    return Error(ExitCode::runtime, fmt::format("{}; use --size {} or larger", problem, enough));
}

}  // namespace

void check_size(const AtlasOptions& options) {
    if (options.size < 1 || options.size > max_atlas_size)
        throw Error(ExitCode::usage, fmt::format("a texture of {0} x {0} texels cannot be made; "
                                                 "use --size with a number from 1 to {1}",
                                                 options.size, max_atlas_size));
    if (options.kind != AtlasKind::quad || std::has_single_bit(options.size)) return;
    throw Error(
        ExitCode::usage,
        fmt::format("the quad atlas halves its texture down to single texels, which {0} x "
                    "{0} texels do not allow; use --size {1} or {2}",
                    options.size, std::bit_floor(options.size), std::bit_ceil(options.size)));
}

Atlas layout_atlas(const Mesh& mesh, const Connectivity& connectivity,
                   const AtlasOptions& options) {
    check_size(options);
    if (options.kind == AtlasKind::quad) return layout_quad(mesh, connectivity, options);
    const Likeness likeness;
    const std::vector<float> weights = triangle_weights(mesh, options.kind);
    const std::vector<std::int32_t> opposite = opposite_half_edges(mesh, connectivity);
    const std::vector<std::int8_t> partner_edges =
        pair_triangles(mesh, opposite, weights, likeness.pair_ratio);
    std::vector<Cell> cells =
        order_cells(mesh, opposite, partner_edges, weights, likeness.strip_ratio);
    RowPlan plan = plan_rows(cells, options.overscan, options.size);
    if (plan.rows.empty()) {
        cells = part_strangers(cells, weights);
        plan = plan_rows(cells, options.overscan, options.size);
    }
    if (plan.rows.empty() && !cells.empty()) throw does_not_fit(mesh, options);
    Atlas atlas;
    atlas.options = options;
    atlas.corners.resize(mesh.triangles.size());
    atlas.charts.resize(mesh.triangles.size());
    atlas.blocks = make_blocks(cells, plan, options);
    for (std::size_t i = 0; i < atlas.blocks.size(); ++i)
        place_corners(atlas, atlas.blocks[i], joins_right(atlas, i));
    number_charts(atlas);
    atlas.notes = layout_notes(atlas);
    return atlas;
}

std::uint32_t smallest_size(std::size_t triangles, const AtlasOptions& options) {
    // A single triangle takes one texel step each way: 2 x 2 texels with corners on centres. In a
    // quad atlas one texel holds a triangle; a patch atlas that does not fit is replaced by it.
    const bool quad = options.kind == AtlasKind::quad || options.kind == AtlasKind::patch ||
                      options.kind == AtlasKind::chart;
    const std::uint64_t cell = !is_strips(options.kind) ? 1 : 1 + border_texels(options.overscan);
    auto side = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(triangles)));
    while (side * side < triangles) ++side;
    while (side > 1 && (side - 1) * (side - 1) >= triangles) --side;
    side = cell * std::max<std::uint64_t>(side, 1);
    return static_cast<std::uint32_t>(quad ? std::bit_ceil(side) : side);
}

}  // namespace burl
