// Strips of pairs (Carr & Hart 2001, section 4.1): the corners of the right angles, the sequence of
// pairs in a strip, and the order of the strips.
#include "atlas/blocks/strips.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace burl {

namespace {

using HalfEdge = std::int32_t;

/// A run of cells that stays together in the layout, with its sort key.
struct Strip {
    std::size_t first = 0, count = 0;
    float mean_weight = 0.0f;
    std::int32_t lowest_face = 0;
};

/// Links pairs through opposite edges into strips.
class StripBuilder {
  public:
    StripBuilder(std::span<const HalfEdge> opposite, std::span<const std::int8_t> partner_edges,
                 std::span<const float> weights)
        : opposite_(opposite),
          partner_edges_(partner_edges),
          weights_(weights),
          placed_(weights.size(), false) {}

    /// Whether the triangle is in a pair that has no strip yet.
    bool waits(std::int32_t t) const {
        return partner_edges_[std::size_t(t)] >= 0 && !placed_[std::size_t(t)];
    }
    void add_strips_through(std::int32_t t, double most_ratio);
    std::vector<Cell> sorted_with(std::vector<Cell> singles);

  private:
    std::int32_t partner(std::int32_t t) const {
        return opposite_[std::size_t(3 * t + partner_edges_[std::size_t(t)])] / 3;
    }
    /// The half-edge of the vertical leg, when the right angle is at the corner opposite the
    /// hypotenuse.
    HalfEdge vertical_leg(std::int32_t t) const {
        return 3 * t + (partner_edges_[std::size_t(t)] + 1) % 3;
    }
    /// The triangle that can lie on the other side of t's vertical leg, or -1.
    std::int32_t beyond(std::int32_t t) const {
        const HalfEdge o = opposite_[std::size_t(vertical_leg(t))];
        if (o < 0 || !waits(o / 3) || vertical_leg(o / 3) != o) return -1;
        return o / 3;
    }
    std::int32_t leftmost(std::int32_t t) const;
    Cell pair_cell(std::int32_t lower) const;

    std::span<const HalfEdge> opposite_;
    std::span<const std::int8_t> partner_edges_;
    std::span<const float> weights_;
    std::vector<bool> placed_;
    std::vector<Cell> cells_;
    std::vector<Strip> strips_;
};

/// Lower triangle of the first pair of t's strip; t itself when the strip is a ring.
std::int32_t StripBuilder::leftmost(std::int32_t t) const {
    std::int32_t lower = t;
    for (std::int32_t left = beyond(lower); left >= 0; left = beyond(lower)) {
        lower = partner(left);
        if (lower == t) return t;
    }
    return lower;
}

Cell StripBuilder::pair_cell(std::int32_t lower) const {
    Cell cell;
    cell.lower = lower;
    cell.upper = partner(lower);
    cell.lower_corner = static_cast<std::uint8_t>((partner_edges_[std::size_t(lower)] + 2) % 3);
    cell.upper_corner =
        static_cast<std::uint8_t>((partner_edges_[std::size_t(cell.upper)] + 2) % 3);
    cell.shares_hypotenuse = true;
    cell.weight = double(weights_[std::size_t(cell.lower)]) + weights_[std::size_t(cell.upper)];
    return cell;
}

void StripBuilder::add_strips_through(std::int32_t t, double most_ratio) {
    double least = 0.0, most = 0.0;
    for (std::int32_t lower = leftmost(t); lower >= 0;) {
        Cell cell = pair_cell(lower);
        const bool fits = !cells_.empty() && most > 0.0 &&
                          std::max(most, cell.weight) <= most_ratio * std::min(least, cell.weight);
        least = fits ? std::min(least, cell.weight) : cell.weight;
        most = fits ? std::max(most, cell.weight) : cell.weight;
        cell.joins_previous = fits;
        if (!fits) strips_.push_back({cells_.size(), 0, 0.0f, lower});
        Strip& strip = strips_.back();
        strip.lowest_face = std::min({strip.lowest_face, cell.lower, cell.upper});
        ++strip.count;
        cells_.push_back(cell);
        placed_[std::size_t(cell.lower)] = placed_[std::size_t(cell.upper)] = true;
        lower = beyond(cell.upper);
    }
}

/// Layout order of strips: non-increasing weight, then lower face.
bool before(const Strip& a, const Strip& b) {
    if (a.mean_weight != b.mean_weight) return a.mean_weight > b.mean_weight;
    return a.lowest_face < b.lowest_face;
}

std::vector<Cell> StripBuilder::sorted_with(std::vector<Cell> singles) {
    for (const Cell& cell : singles) {
        strips_.push_back({cells_.size(), 1, 0.0f, cell.lower});
        cells_.push_back(cell);
    }
    for (Strip& strip : strips_) {
        double sum = 0.0;
        for (std::size_t i = strip.first; i < strip.first + strip.count; ++i)
            sum += cells_[i].weight;
        strip.mean_weight = static_cast<float>(sum / double(strip.count));
    }
    std::sort(strips_.begin(), strips_.end(), before);
    std::vector<Cell> sorted;
    sorted.reserve(cells_.size());
    for (const Strip& strip : strips_)
        sorted.insert(sorted.end(), cells_.begin() + std::ptrdiff_t(strip.first),
                      cells_.begin() + std::ptrdiff_t(strip.first + strip.count));
    return sorted;
}

/// The corner opposite the longest edge; ties go to the first.
std::uint8_t widest_corner(const Mesh& mesh, std::int32_t t) {
    const Triangle& triangle = mesh.triangles[std::size_t(t)];
    std::uint8_t best = 0;
    double longest = -1.0;
    for (std::uint8_t k = 0; k < 3; ++k) {
        const double length = glm::distance(mesh.positions[triangle[(k + 1u) % 3]],
                                            mesh.positions[triangle[(k + 2u) % 3]]);
        if (length > longest) {
            longest = length;
            best = k;
        }
    }
    return best;
}

Cell cell_of_single(std::int32_t t, std::uint8_t corner, float weight) {
    Cell cell;
    cell.lower = t;
    cell.lower_corner = corner;
    cell.weight = 2.0 * double(weight);
    return cell;
}

/// Whether two unrelated triangles may share a block: weights that differ by more than a factor of
/// 4 would give the smaller one far too much texture.
bool can_share(float larger, float smaller) {
    constexpr float most_ratio = 4.0f;
    return smaller > 0.0f ? larger <= most_ratio * smaller : larger == 0.0f;
}

std::vector<Cell> single_cells(const Mesh& mesh, std::span<const std::int8_t> partner_edges,
                               std::span<const float> weights) {
    std::vector<std::int32_t> singles;
    for (std::size_t t = 0; t < weights.size(); ++t)
        if (partner_edges[t] < 0) singles.push_back(static_cast<std::int32_t>(t));
    std::stable_sort(singles.begin(), singles.end(), [&](std::int32_t a, std::int32_t b) {
        return weights[std::size_t(a)] > weights[std::size_t(b)];
    });
    std::vector<Cell> cells;
    for (std::size_t i = 0; i < singles.size(); ++i) {
        const std::int32_t t = singles[i];
        const float weight = weights[std::size_t(t)];
        Cell cell = cell_of_single(t, widest_corner(mesh, t), weight);
        if (i + 1 < singles.size() && can_share(weight, weights[std::size_t(singles[i + 1])])) {
            cell.upper = singles[++i];
            cell.upper_corner = widest_corner(mesh, cell.upper);
            cell.weight = double(weight) + weights[std::size_t(cell.upper)];
        }
        cells.push_back(cell);
    }
    return cells;
}

}  // namespace

std::vector<Cell> order_cells(const Mesh& mesh, std::span<const std::int32_t> opposite,
                              std::span<const std::int8_t> partner_edges,
                              std::span<const float> weights, double most_ratio) {
    StripBuilder builder(opposite, partner_edges, weights);
    for (std::int32_t t = 0; std::size_t(t) < weights.size(); ++t)
        if (builder.waits(t)) builder.add_strips_through(t, most_ratio);
    return builder.sorted_with(single_cells(mesh, partner_edges, weights));
}

std::vector<Cell> part_strangers(std::span<const Cell> cells, std::span<const float> weights) {
    std::vector<Cell> parted;
    for (const Cell& cell : cells) {
        if (!cell.holds_strangers()) {
            parted.push_back(cell);
            continue;
        }
        parted.push_back(
            cell_of_single(cell.lower, cell.lower_corner, weights[std::size_t(cell.lower)]));
        parted.push_back(
            cell_of_single(cell.upper, cell.upper_corner, weights[std::size_t(cell.upper)]));
    }
    return parted;
}

}  // namespace burl
