#include "atlas/blocks/quad_turns.h"

#include <array>

#include "atlas/base/each_index.h"
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

}  // namespace

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

}  // namespace burl
