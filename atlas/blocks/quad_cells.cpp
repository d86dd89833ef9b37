// The texel budget: with X = sum A |e_x|^2 and Y = sum A |e_y|^2 over a cell (A area, e legs on the
// mesh) a block of n texels is best at width/height = sqrt(X/Y), where its squared error is in
// proportion to X Y / (A n^2); a given number of texels then does best when n ~ (X Y / A)^(1/3).
#include "atlas/blocks/quad_cells.h"

#include <algorithm>
#include <cmath>

#include "atlas/base/each_index.h"
#include "atlas/blocks/pairing.h"
#include "atlas/solid/weights.h"

namespace burl {

namespace {

/// A triangle's squared edge lengths and its area, in scaled mesh units.
struct CornerSides {
    std::array<double, 3> squared{};  ///< squared length of edge k, from corner k to corner k+1
    double area = 0.0;
};

std::vector<CornerSides> sides_of_corners(const Mesh& mesh) {
    const double scale = unit_scale(mesh);
    const std::vector<double> areas = triangle_areas(mesh).areas;
    std::vector<CornerSides> sides(mesh.triangles.size());
    for_each_index(sides.size(), [&](std::size_t t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& triangle = mesh.triangles[t];
            const Vec3d edge =
                scale * mesh.positions[triangle[(k + 1) % 3]] - scale * mesh.positions[triangle[k]];
            sides[t].squared[k] = glm::dot(edge, edge);
        }
        sides[t].area = areas[t];
    });
    return sides;
}

/// Sums over the triangles of a block: area, X and Y of the budget, error coefficients (see
/// QuadCell) and the longest squared edge.
struct Extent {
    double area = 0.0, x = 0.0, y = 0.0, longest = 0.0;
    std::array<double, 3> error{};

    void add(const CornerSides& sides, std::size_t right_angle) {
        const double x2 = sides.squared[right_angle], y2 = sides.squared[(right_angle + 2) % 3];
        area += sides.area;
        x += sides.area * x2;
        y += sides.area * y2;
        error[0] += sides.area * x2 * x2;
        error[1] += 2.0 * sides.area * x2 * y2;
        error[2] += sides.area * y2 * y2;
        longest = std::max({longest, sides.squared[0], sides.squared[1], sides.squared[2]});
    }
    double budget() const { return area > 0.0 ? std::cbrt(x * y / area) : 0.0; }
};

/// The corner between the two shorter edges, where a right angle costs the fewest texels.
std::size_t best_right_angle(const CornerSides& sides) {
    const auto longest = std::max_element(sides.squared.begin(), sides.squared.end());
    return std::size_t(longest - sides.squared.begin() + 2) % 3;
}

double single_budget(const CornerSides& sides) {
    Extent extent;
    extent.add(sides, best_right_angle(sides));
    return extent.budget();
}

/// Sorting key of a pair: its texel budget relative to two singles', low for good pairs; never_pair
/// above `most_cost`.
std::uint32_t pair_key(double pair, double singles, double most_cost) {
    const double ratio = singles > 0.0 ? pair / singles : 1.0;
    if (ratio > most_cost) return never_pair;
    return static_cast<std::uint32_t>(std::ldexp(std::min(ratio, 128.0), 24));
}

std::vector<std::uint32_t> pair_keys(std::span<const CornerSides> sides,
                                     std::span<const std::int32_t> opposite, double most_cost) {
    std::vector<double> budgets(sides.size());
    for_each_index(sides.size(), [&](std::size_t t) { budgets[t] = single_budget(sides[t]); });
    std::vector<std::uint32_t> keys(opposite.size(), never_pair);
    for_each_index(opposite.size(), [&](std::size_t h) {
        if (opposite[h] < 0 || std::size_t(opposite[h]) < h) return;
        const auto o = std::size_t(opposite[h]);
        Extent extent;
        extent.add(sides[h / 3], (h + 2) % 3);
        extent.add(sides[o / 3], (o + 2) % 3);
        keys[h] = keys[o] = pair_key(extent.budget(), budgets[h / 3] + budgets[o / 3], most_cost);
    });
    return keys;
}

double demand(const Extent& extent, AtlasWeight weight) {
    switch (weight) {
        case AtlasWeight::equal:
            return 1.0;
        case AtlasWeight::area:
            return extent.area;
        case AtlasWeight::length:
            return extent.area > 0.0 ? extent.longest : 0.0;
        case AtlasWeight::error:
            break;
    }
    return extent.budget();
}

/// Best aspect of the block, 1/64 to 64; 1 for cells of equal weight, whatever their shape.
double aspect(const Extent& extent, AtlasWeight weight) {
    constexpr double most = 64.0;
    if (weight == AtlasWeight::equal || !(extent.x > 0.0) || !(extent.y > 0.0)) return 1.0;
    return std::clamp(std::sqrt(extent.x / extent.y), 1.0 / most, most);
}

Vec3d centre(const Mesh& mesh, const QuadCell& cell, double scale) {
    Vec3d sum{0.0};
    for (const std::uint32_t p : mesh.triangles[std::size_t(cell.lower)])
        sum += scale * mesh.positions[p];
    if (cell.upper < 0) return sum / 3.0;
    const Triangle& upper = mesh.triangles[std::size_t(cell.upper)];
    return 0.25 * (sum + scale * mesh.positions[upper[cell.upper_corner]]);
}

double kink(const Mesh& mesh, const QuadCell& cell, double scale) {
    const auto corner = [&](std::int32_t face, std::size_t k) {
        return scale * mesh.positions[mesh.triangles[std::size_t(face)][k % 3]];
    };
    const Vec3d a = corner(cell.lower, cell.lower_corner + 1u),
                b = corner(cell.lower, cell.lower_corner + 2u);
    const Vec3d off =
        corner(cell.lower, cell.lower_corner) - a + (corner(cell.upper, cell.upper_corner) - b);
    const double diagonal = glm::distance(a, b);
    return diagonal > 0.0 ? glm::length(off) / diagonal : 0.0;
}

/// A cell as its lower triangle and that triangle's edge towards the other one, -1 without one.
struct Pair {
    std::int32_t lower = -1;
    std::int8_t edge = -1;
};

std::vector<Pair> pairs_of(std::span<const std::int32_t> opposite,
                           std::span<const std::int8_t> partner_edges) {
    std::vector<Pair> pairs;
    pairs.reserve(partner_edges.size());
    for (std::size_t t = 0; t < partner_edges.size(); ++t) {
        const std::int8_t edge = partner_edges[t];
        if (edge >= 0 && std::size_t(opposite[3 * t + std::size_t(edge)] / 3) < t) continue;
        pairs.push_back({static_cast<std::int32_t>(t), edge});
    }
    return pairs;
}

QuadCell make_cell(const Pair& pair, const Mesh& mesh, std::span<const std::int32_t> opposite,
                   std::span<const CornerSides> sides, AtlasWeight weight, double scale) {
    const auto t = std::size_t(pair.lower);
    QuadCell cell;
    Extent extent;
    cell.lower = pair.lower;
    const std::size_t corner =
        pair.edge < 0 ? best_right_angle(sides[t]) : std::size_t(pair.edge + 2) % 3;
    cell.lower_corner = static_cast<std::uint8_t>(corner);
    extent.add(sides[t], corner);
    if (pair.edge >= 0) {
        const std::int32_t o = opposite[3 * t + std::size_t(pair.edge)];
        cell.upper = o / 3;
        cell.upper_corner = static_cast<std::uint8_t>((o + 2) % 3);
        extent.add(sides[std::size_t(o / 3)], cell.upper_corner);
        cell.kink = kink(mesh, cell, scale);
    }
    cell.centre = centre(mesh, cell, scale);
    cell.demand = demand(extent, weight);
    cell.aspect = aspect(extent, weight);
    cell.error = extent.error;
    return cell;
}

}  // namespace

std::vector<QuadCell> make_quad_cells(const Mesh& mesh, std::span<const std::int32_t> opposite,
                                      AtlasWeight weight, double most_cost) {
    const std::vector<CornerSides> sides = sides_of_corners(mesh);
    const std::vector<Pair> pairs =
        pairs_of(opposite, match_triangles(opposite, pair_keys(sides, opposite, most_cost)));
    const double scale = unit_scale(mesh);
    std::vector<QuadCell> cells(pairs.size());
    for_each_index(cells.size(), [&](std::size_t i) {
        cells[i] = make_cell(pairs[i], mesh, opposite, sides, weight, scale);
    });
    return cells;
}

}  // namespace burl
