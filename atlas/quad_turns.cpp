#include "atlas/quad_turns.h"

#include <array>

#include "atlas/weights.h"

namespace burl {

namespace {

constexpr int sweeps = 3;  // later ones see how the neighbours have turned

/// What a block's four sides show in the middle, by QuadSide.
using Sides = std::array<Vec3d, 4>;

/// Corners on the mesh as they lie round the block, from the low-x, low-y one by way of the high-x
/// one, when nothing is turned.
std::array<Vec3d, 4> corners_of(const QuadCell& cell, const Mesh& mesh, double scale) {
    const auto corner = [&](std::int32_t face, std::size_t k) {
        return scale * mesh.positions[mesh.triangles[std::size_t(face)][k % 3]];
    };
    const Vec3d p = corner(cell.lower, cell.lower_corner),
                x = corner(cell.lower, cell.lower_corner + 1u),
                y = corner(cell.lower, cell.lower_corner + 2u);
    // A single's block shows the triangle turned by 180 degrees beside it.
    return {p, x, cell.upper < 0 ? p : corner(cell.upper, cell.upper_corner), y};
}

/// After so many quarter turns, the way `QuadLeaf::turned` is one.
Sides sides_after(const std::array<Vec3d, 4>& corners, std::size_t quarters) {
    const auto corner = [&](std::size_t k) { return corners[(k + 4 - quarters) % 4]; };
    const auto middle = [&](std::size_t k) { return 0.5 * (corner(k) + corner((k + 1) % 4)); };
    Sides sides;
    sides[quad_below] = middle(0);
    sides[quad_right] = middle(1);
    sides[quad_above] = middle(2);
    sides[quad_left] = middle(3);
    return sides;
}

std::size_t quarters_of(const QuadLeaf& leaf) {
    return (leaf.turned ? 1u : 0u) + (leaf.exchanged ? 2u : 0u);
}

QuadSide facing(QuadSide side) {
    constexpr std::array<QuadSide, 4> opposite{quad_right, quad_left, quad_above, quad_below};
    return opposite[side];
}

/// Squared distances to what is beside, by the length of the side.
double unlikeness(const QuadLeaf& leaf, const Sides& sides, std::span<const Sides> shown) {
    double sum = 0.0;
    for (const QuadSide side : {quad_left, quad_right, quad_below, quad_above}) {
        if (leaf.beside[side] == no_spot) continue;
        const Vec3d off = sides[side] - shown[leaf.beside[side]][facing(side)];
        const bool upright = side == quad_left || side == quad_right;
        sum += (upright ? leaf.height : leaf.width) * glm::dot(off, off);
    }
    return sum;
}

/// The number of quarter turns, of those the leaf may take, that suits its neighbours best.
std::size_t best_quarters(const QuadLeaf& leaf, bool pair, const std::array<Vec3d, 4>& corners,
                          std::span<const Sides> shown) {
    std::size_t best = quarters_of(leaf);
    double least = unlikeness(leaf, sides_after(corners, best), shown);
    for (std::size_t quarters = 0; quarters < (pair ? 4u : 2u); ++quarters) {
        if (!leaf.may_turn && (quarters % 2 == 1) != leaf.turned) continue;
        const double sum = unlikeness(leaf, sides_after(corners, quarters), shown);
        if (sum < least) least = sum, best = quarters;
    }
    return best;
}

}  // namespace

void turn_to_neighbours(std::span<QuadLeaf> leaves, std::span<const QuadCell> cells,
                        const Mesh& mesh) {
    const double scale = unit_scale(mesh);
    std::vector<Sides> shown;
    shown.reserve(leaves.size());
    for (const QuadLeaf& leaf : leaves)
        shown.push_back(sides_after(corners_of(cells[leaf.cell], mesh, scale), quarters_of(leaf)));
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (std::size_t i = 0; i < leaves.size(); ++i) {
            QuadLeaf& leaf = leaves[i];
            const QuadCell& cell = cells[leaf.cell];
            const std::array<Vec3d, 4> corners = corners_of(cell, mesh, scale);
            const std::size_t best = best_quarters(leaf, cell.upper >= 0, corners, shown);
            leaf.turned = best % 2 == 1;
            leaf.exchanged = best >= 2;
            shown[i] = sides_after(corners, best);
        }
}

}  // namespace burl
