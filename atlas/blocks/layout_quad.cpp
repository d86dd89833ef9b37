#include "atlas/blocks/layout_quad.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "atlas/base/each_index.h"
#include "atlas/blocks/pairing.h"
#include "atlas/blocks/quad_cells.h"
#include "atlas/blocks/quad_order.h"
#include "atlas/blocks/quad_tree.h"
#include "atlas/mesh/mesh.h"
#include "atlas/solid/block.h"
#include "atlas/solid/weights.h"

namespace burl {

namespace {

constexpr int turn_sweeps = 3;  // passes; the later ones see the neighbours' turns

/// Surface points at the middles of a block's four sides when nothing is turned, in the order of
/// quarter turns: below, right, above, left.
using TurnSides = std::array<Vec3d, 4>;

/// The side points of a cell, whose corners go round the block from the low-x, low-y one by way of
/// the high-x one.
TurnSides sides_of(const QuadCell& cell, const Mesh& mesh, double scale) {
    const auto corner = [&](std::int32_t face, std::size_t k) {
        return scale * mesh.positions[mesh.triangles[std::size_t(face)][k % 3]];
    };
    const Vec3d p = corner(cell.lower, cell.lower_corner),
                x = corner(cell.lower, cell.lower_corner + 1u),
                y = corner(cell.lower, cell.lower_corner + 2u);
    // The block of a single triangle shows it a second time, turned by 180 degrees.
    const Vec3d q = cell.upper < 0 ? p : corner(cell.upper, cell.upper_corner);
    return {0.5 * (p + x), 0.5 * (x + q), 0.5 * (q + y), 0.5 * (y + p)};
}

/// Surface point on a side after so many quarter turns; QuadLeaf::turned is one of them,
/// QuadLeaf::exchanged two.
const Vec3d& shown(const TurnSides& sides, QuadSide side, std::size_t quarters) {
    constexpr std::array<std::size_t, 4> order{3, 1, 0, 2};  // index in TurnSides by QuadSide
    return sides[(order[side] + 4 - quarters) % 4];
}

std::size_t quarters_of(const QuadLeaf& leaf) {
    return (leaf.turned ? 1u : 0u) + (leaf.exchanged ? 2u : 0u);
}

QuadSide facing(QuadSide side) {
    constexpr std::array<QuadSide, 4> opposite{quad_right, quad_left, quad_above, quad_below};
    return opposite[side];
}

/// Surface points beside a leaf's sides by QuadSide, weighted by the sides' lengths; weight 0 where
/// nothing lies beside.
struct Beside {
    std::array<Vec3d, 4> places{};
    std::array<double, 4> weights{};
};

Beside beside(std::span<const QuadLeaf> leaves, std::size_t i, std::span<const TurnSides> sides) {
    const QuadLeaf& leaf = leaves[i];
    Beside result;
    for (const QuadSide side : quad_sides) {
        const std::uint32_t other = leaf.beside[side];
        if (other == no_spot) continue;
        result.places[side] = shown(sides[other], facing(side), quarters_of(leaves[other]));
        const bool upright = side == quad_left || side == quad_right;
        result.weights[side] = upright ? leaf.height : leaf.width;
    }
    return result;
}

double unlikeness(const TurnSides& sides, std::size_t quarters, const Beside& beside) {
    double sum = 0.0;
    for (const QuadSide side : quad_sides) {
        if (beside.weights[side] == 0.0) continue;
        const Vec3d off = shown(sides, side, quarters) - beside.places[side];
        sum += beside.weights[side] * glm::dot(off, off);
    }
    return sum;
}

/// The number of quarter turns, among those the leaf may take, that suits its neighbours best.
std::size_t best_quarters(const QuadLeaf& leaf, bool pair, const TurnSides& sides,
                          const Beside& beside) {
    std::size_t best = quarters_of(leaf);
    double least = unlikeness(sides, best, beside);
    for (std::size_t quarters = 0; quarters < (pair ? 4u : 2u); ++quarters) {
        if (!leaf.may_turn && (quarters % 2 == 1) != leaf.turned) continue;
        const double sum = unlikeness(sides, quarters, beside);
        if (sum < least) least = sum, best = quarters;
    }
    return best;
}

/// Sets `turned` of the leaves that may turn, and `exchanged` of pairs: of the half and quarter
/// turns that cost nothing, those that bring surface points on both sides of a border between
/// blocks near each other. Every leaf must have at least one texel of its own; places stay as they
/// are.
void turn_to_neighbours(std::span<QuadLeaf> leaves, std::span<const QuadCell> cells,
                        const Mesh& mesh) {
    const double scale = unit_scale(mesh);
    std::vector<TurnSides> sides(leaves.size());
    for_each_index(leaves.size(),
                   [&](std::size_t i) { sides[i] = sides_of(cells[leaves[i].cell], mesh, scale); });
    for (int sweep = 0; sweep < turn_sweeps; ++sweep)
        for (std::size_t i = 0; i < leaves.size(); ++i) {
            QuadLeaf& leaf = leaves[i];
            const bool pair = cells[leaf.cell].upper >= 0;
            const std::size_t best = best_quarters(leaf, pair, sides[i], beside(leaves, i, sides));
            leaf.turned = best % 2 == 1;
            leaf.exchanged = best >= 2;
        }
}

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
        place_corners(atlas, atlas.blocks[i], false);
    });
    for (const Block& block : atlas.blocks) {
        number_charts(atlas, block);
        note_block(atlas.notes, block, options);
    }
    note_shared(atlas);
    return atlas;
}

}  // namespace burl
