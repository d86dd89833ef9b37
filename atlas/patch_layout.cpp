// The tree halves the demand recursively along the longest extent of the patches' centres. A node's
// rectangle is divided in proportion to its halves' demand, in either direction and rounded to
// either cell; every combination is tried while there are few patches (a balanced tree of n leaves
// has about n^2 of them to look at per direction), else the longer side is divided.
#include "atlas/patch_layout.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <random>

namespace burl {
namespace {

constexpr std::size_t few_patches = 12, some_patches = 64;

struct CellRectangle {
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
};

struct Node {
    double demand = 0.0;
    std::size_t leaves = 1;
    std::int32_t patch = -1;
    std::unique_ptr<Node> first, second;
};

std::unique_ptr<Node> build_tree(std::span<const PatchDemand> patches,
                                 const std::vector<Vec3d>& centres,
                                 std::span<std::uint32_t> members) {
    auto node = std::make_unique<Node>();
    node->leaves = members.size();
    Vec3d low(std::numeric_limits<double>::max()), high = -low;
    for (const std::uint32_t p : members) {
        node->demand += texel_demand(patches[p]);
        low = glm::min(low, centres[p]);
        high = glm::max(high, centres[p]);
    }
    if (members.size() == 1) {
        node->patch = static_cast<std::int32_t>(members[0]);
        return node;
    }
    const Vec3d size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    std::sort(members.begin(), members.end(), [&](std::uint32_t a, std::uint32_t b) {
        return centres[a][axis] != centres[b][axis] ? centres[a][axis] < centres[b][axis] : a < b;
    });
    std::size_t half = 1;
    for (double sum = texel_demand(patches[members[0]]); half + 1 < members.size(); ++half) {
        const double next = texel_demand(patches[members[half]]);
        if (sum + 0.5 * next > 0.5 * node->demand) break;
        sum += next;
    }
    node->first = build_tree(patches, centres, members.first(half));
    node->second = build_tree(patches, centres, members.subspan(half));
    return node;
}

class Treemap {
  public:
    Treemap(std::span<const PatchDemand> patches, std::uint32_t size, std::uint32_t gutter)
        : patches_(patches),
          size_(size),
          gutter_(gutter),
          cell_(2 * std::max(gutter, 1u)),
          cells_(std::max(size / cell_, 1u)) {}

    bool can_hold(std::size_t count) const { return std::size_t{cells_} * cells_ >= count; }

    /// Sum of X/w^2 + Y/h^2 over the patches; infinite when they do not fit.
    double cost(const Node& tree) const { return cost(tree, {0, 0, cells_, cells_}); }

    void place(const Node& tree, std::vector<PatchBlock>& blocks) const {
        place(tree, {0, 0, cells_, cells_}, blocks);
    }

  private:
    struct Division {
        double cost = std::numeric_limits<double>::infinity();
        CellRectangle first, second;
    };
    struct Leaf {
        double cost = std::numeric_limits<double>::infinity();
        PatchBlock block;
    };

    double cost(const Node& node, const CellRectangle& r) const {
        if (std::size_t{r.width} * r.height < node.leaves)
            return std::numeric_limits<double>::infinity();
        return node.patch >= 0 ? leaf(node, r).cost : best_division(node, r).cost;
    }

    void place(const Node& node, const CellRectangle& r, std::vector<PatchBlock>& blocks) const {
        if (node.patch >= 0) {
            blocks[std::size_t(node.patch)] = leaf(node, r).block;
            return;
        }
        const Division division = best_division(node, r);
        place(*node.first, division.first, blocks);
        place(*node.second, division.second, blocks);
    }

    Division best_division(const Node& node, const CellRectangle& r) const {
        Division best;
        for (const bool across : {r.width >= r.height, r.width < r.height}) {
            if ((across ? r.width : r.height) < 2) continue;
            try_divisions(node, r, across, best);
            if (node.leaves > some_patches && std::isfinite(best.cost)) break;
        }
        return best;
    }

    void try_divisions(const Node& node, const CellRectangle& r, bool across,
                       Division& best) const {
        const std::uint32_t whole = across ? r.width : r.height;
        const double share = whole * (node.first->demand / node.demand);
        const double nearest = std::round(share), other = 2.0 * std::floor(share) + 1.0 - nearest;
        for (const double rounded : {nearest, other}) {
            const auto part =
                static_cast<std::uint32_t>(std::clamp(rounded, 1.0, double(whole - 1)));
            Division division{0.0, r, r};
            (across ? division.first.width : division.first.height) = part;
            (across ? division.second.width : division.second.height) = whole - part;
            (across ? division.second.x : division.second.y) += part;
            division.cost = cost(*node.first, division.first);
            if (division.cost < best.cost) division.cost += cost(*node.second, division.second);
            if (division.cost < best.cost) best = division;
            if (node.leaves > few_patches) return;
        }
    }

    Leaf leaf(const Node& node, const CellRectangle& r) const {
        const auto texel = [&](std::uint32_t cell) {
            return cell == cells_ ? size_ : cell * cell_;
        };
        const PatchDemand& patch = patches_[std::size_t(node.patch)];
        PatchBlock block;
        block.x = texel(r.x);
        block.y = texel(r.y);
        block.width = texel(r.x + r.width) - block.x;
        block.height = texel(r.y + r.height) - block.y;
        block.gutter = std::min({gutter_, block.width / 4, block.height / 4});
        const double w = block.columns(), h = block.rows();
        if (block.columns() < 1 || block.rows() < 1) return {};
        const Stretch& s = patch.stretch;
        const double upright = s.x / (w * w) + s.y / (h * h);
        const double turned = s.x / (h * h) + s.y / (w * w);
        block.turned = turned < upright;
        return {std::min(upright, turned), block};
    }

    std::span<const PatchDemand> patches_;
    std::uint32_t size_, gutter_, cell_, cells_;
};

/// The centres turned at random (the first time not at all): another tree of the same patches.
std::vector<Vec3d> turned_centres(std::span<const PatchDemand> patches, int turn) {
    Mat3d rotation(1.0);
    if (turn > 0) {
        std::mt19937 random(static_cast<std::uint32_t>(turn));
        const auto any = [&] { return double(random()) / 4294967296.0 - 0.5; };
        const Vec3d a = glm::normalize(Vec3d(any(), any(), 0.75 + any()));
        const Vec3d b = glm::normalize(glm::cross(a, Vec3d(1.0, any(), 0.0)));
        rotation = Mat3d(a, b, glm::cross(a, b));
    }
    std::vector<Vec3d> centres;
    for (const PatchDemand& patch : patches) centres.push_back(rotation * patch.centre);
    return centres;
}

}  // namespace

Vec2d PatchBlock::place(const Vec2d& uv) const {
    const Vec2d q = turned ? Vec2d(1.0 - uv.y, uv.x) : uv;
    return Vec2d(x + gutter + 0.5, y + gutter + 0.5) + q * Vec2d(columns(), rows());
}

double PatchBlock::aspect() const {
    return turned ? double(rows()) / columns() : double(columns()) / rows();
}

double texel_demand(const PatchDemand& patch) {
    const Stretch& s = patch.stretch;
    return std::cbrt(std::sqrt(s.x / s.area) * std::sqrt(s.y / s.area) * std::sqrt(s.x) *
                     std::sqrt(s.y));
}

std::optional<PatchLayout> layout_patches(std::span<const PatchDemand> patches,
                                          const PatchLayoutOptions& options) {
    if (patches.empty() || options.size < 2) return std::nullopt;
    double area = 0.0;
    for (const PatchDemand& patch : patches) area += patch.area;
    const double ideal = 2.0 * area * area / (double(options.size) * options.size);
    for (std::uint32_t gutter = options.gutter.value_or(std::max(options.size / 128, 1u));;
         gutter /= 2) {
        const Treemap treemap(patches, options.size, gutter);
        PatchLayout best;
        best.predicted_stretch = std::numeric_limits<double>::infinity();
        for (int turn = 0; turn < options.tries && treemap.can_hold(patches.size()); ++turn) {
            std::vector<std::uint32_t> members(patches.size());
            std::iota(members.begin(), members.end(), 0u);
            const auto tree = build_tree(patches, turned_centres(patches, turn), members);
            const double stretch = treemap.cost(*tree) / ideal;
            if (!(stretch < best.predicted_stretch)) continue;
            best = {std::vector<PatchBlock>(patches.size()), gutter, stretch};
            treemap.place(*tree, best.blocks);
        }
        if (std::isfinite(best.predicted_stretch)) return best;
        if (gutter == 0) return std::nullopt;
    }
}

}  // namespace burl
