#include "atlas/patch/tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "atlas/base/elementary.h"

namespace burl {
namespace {

constexpr double most_log_aspect = 4.0, steps_per_octave = 4.0;
/// Relative cost per squared log2 of the aspect: rounding to cells, which the dynamic programme
/// ignores, costs more in a narrow rectangle.
constexpr double per_octave = 0.02;
/// Smallest share of the inner texels asked for that an estimate assumes to be left.
constexpr double least_inside = 1.0 / 64.0;
/// Number of patches above which a node's halves have at least a `most_lopsided`-th of them each,
/// so that the tree does not get deep.
constexpr std::size_t many_patches = 64, most_lopsided = 16;

double at_log_aspect(const AspectCosts& costs, double log_aspect) {
    const double place = std::clamp((log_aspect + most_log_aspect) * steps_per_octave, 0.0,
                                    double(costs.size() - 1));
    const std::size_t i = std::min(static_cast<std::size_t>(place), costs.size() - 2);
    const double t = place - double(i);
    return (1.0 - t) * costs[i] + t * costs[i + 1];
}

/// The log2 of width over height at entry i of the table.
double log_aspect_at(std::size_t i) {
    return double(i) / steps_per_octave - most_log_aspect;
}

/// Number of members in the first half, so that the sorted members' texels are halved best.
std::size_t half_of(std::span<const std::uint32_t> members, std::span<const PatchNode> leaves,
                    double all) {
    const std::size_t least =
        members.size() > many_patches ? members.size() / most_lopsided : std::size_t(1);
    std::size_t half = 1;
    for (double sum = leaves[members[0]].texels; half + least < members.size(); ++half) {
        const double next = leaves[members[half]].texels;
        if (half >= least && sum + 0.5 * next > 0.5 * all) break;
        sum += next;
    }
    return half;
}

/// Builds the tree from the leaves up.
class TreeBuilder {
  public:
    TreeBuilder(std::span<const PatchNode> leaves, std::span<const Vec3d> centres)
        : leaves_(leaves), centres_(centres) {}

    std::vector<PatchNode> run() {
        std::vector<std::uint32_t> members(leaves_.size());
        std::iota(members.begin(), members.end(), 0u);
        nodes_.reserve(2 * members.size());
        build(members);
        return std::move(nodes_);
    }

  private:
    std::size_t build(std::span<std::uint32_t> members) {
        if (members.size() == 1) {
            nodes_.push_back(leaves_[members[0]]);
            return nodes_.size() - 1;
        }
        PatchNode node;
        node.leaves = members.size();
        for (const std::uint32_t p : members) {
            node.texels += leaves_[p].texels;
            node.inner += leaves_[p].inner;
        }
        sort_along_extent(members);
        const std::size_t half = half_of(members, leaves_, node.texels);
        node.first = build(members.first(half));
        node.second = build(members.subspan(half));
        add_costs(node);
        nodes_.push_back(node);
        return nodes_.size() - 1;
    }

    void sort_along_extent(std::span<std::uint32_t> members) const {
        Vec3d low(std::numeric_limits<double>::max()), high = -low;
        for (const std::uint32_t p : members) {
            low = glm::min(low, centres_[p]);
            high = glm::max(high, centres_[p]);
        }
        const Vec3d size = high - low;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        std::sort(members.begin(), members.end(), [&](std::uint32_t a, std::uint32_t b) {
            const double x = centres_[a][axis], y = centres_[b][axis];
            return x != y ? x < y : a < b;
        });
    }

    void add_costs(PatchNode& node) const {
        const PatchNode &first = nodes_[node.first], &second = nodes_[node.second];
        const double log_first = binary_log(first.texels / node.texels);
        const double log_second = binary_log(second.texels / node.texels);
        for (std::size_t i = 0; i < node.costs.size(); ++i) {
            const double a = log_aspect_at(i);
            const double across = at_log_aspect(first.costs, a + log_first) +
                                  at_log_aspect(second.costs, a + log_second);
            const double along = at_log_aspect(first.costs, a - log_first) +
                                 at_log_aspect(second.costs, a - log_second);
            node.costs[i] = std::min(across, along);
        }
    }

    std::span<const PatchNode> leaves_;
    std::span<const Vec3d> centres_;
    std::vector<PatchNode> nodes_;
};

}  // namespace

double PatchNode::estimate(double width, double height) const {
    // Gutters take a share of a side, so their texels grow with the root of the area.
    const double area = width * height / texels;
    const double inside = area * texels - std::sqrt(area) * (texels - inner);
    const double log_aspect = binary_log(width / height);
    return at_log_aspect(costs, log_aspect) * (1.0 + per_octave * log_aspect * log_aspect) * inner /
           std::max(inside, least_inside * inner);
}

std::vector<PatchNode> patch_leaves(std::span<const PatchDemand> patches,
                                    std::span<const double> texels, std::uint32_t gutter) {
    // A side's steps are at least a half: a block that does not fit must not look infinitely bad,
    // for it may fit after all once sides are rounded to cells.
    const auto steps = [gutter](double side) {
        return std::max(side - 1.0 - 2.0 * std::min(double(gutter), 0.25 * side), 0.5);
    };
    std::vector<PatchNode> result(patches.size());
    for (std::size_t p = 0; p < patches.size(); ++p) {
        const double side = std::sqrt(texels[p]);
        result[p].texels = texels[p];
        result[p].inner = steps(side) * steps(side);
        result[p].patch = static_cast<std::int32_t>(p);
        for (std::size_t i = 0; i < result[p].costs.size(); ++i) {
            const double root = binary_power(0.5 * log_aspect_at(i));
            const double w = steps(side * root), h = steps(side / root);
            const Stretch& s = patches[p].stretch;
            result[p].costs[i] =
                std::min(s.x / (w * w) + s.y / (h * h), s.x / (h * h) + s.y / (w * w));
        }
    }
    return result;
}

std::vector<PatchNode> build_patch_tree(std::span<const PatchNode> leaves,
                                        std::span<const Vec3d> centres) {
    return TreeBuilder(leaves, centres).run();
}

}  // namespace burl
