// Division of a node's rectangle: in proportion to its halves' texels, in either direction and
// rounded to either cell. The tree's costs estimate which of the four is best; where only few
// patches are below, all are tried.
#include "atlas/patch/layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "atlas/patch/tree.h"

namespace burl {
namespace {

/// Number of patches in a node up to which every division is tried.
constexpr std::size_t few_patches = 8;
constexpr double no_room = std::numeric_limits<double>::infinity();
/// Limit of trees times patches: with many patches trees differ little.
constexpr std::size_t most_leaves = 1024;

/// A rectangle of cells.
struct CellRectangle {
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
    bool operator==(const CellRectangle&) const = default;
};

/// The tree's nodes as rectangles on the square's cells.
class Treemap {
  public:
    Treemap(std::span<const PatchDemand> patches, std::vector<PatchNode> nodes, std::uint32_t size,
            std::uint32_t gutter)
        : patches_(patches),
          nodes_(std::move(nodes)),
          size_(size),
          gutter_(gutter),
          cell_(cell_texels(gutter)),
          cells_(std::max(size / cell_, 1u)) {}

    /// Sets the blocks; returns the sum of X/w^2 + Y/h^2 over the patches, infinite when they do
    /// not fit.
    double place(std::vector<PatchBlock>& blocks) const {
        blocks.resize(patches_.size());
        return place(nodes_.back(), {0, 0, cells_, cells_}, blocks);
    }

  private:
    struct Division {
        double cost = no_room;
        CellRectangle first, second;
    };
    struct Leaf {
        double cost = no_room;
        PatchBlock block;
    };

    double place(const PatchNode& node, const CellRectangle& r,
                 std::vector<PatchBlock>& blocks) const {
        if (std::size_t{r.width} * r.height < node.leaves) return no_room;
        if (node.patch >= 0) {
            const Leaf here = leaf(node, r);
            blocks[std::size_t(node.patch)] = here.block;
            return here.cost;
        }
        const Division division = best_division(node, r);
        if (!(division.cost < no_room)) return no_room;
        return place(nodes_[node.first], division.first, blocks) +
               place(nodes_[node.second], division.second, blocks);
    }

    /// The cost of the best divisions of the node all the way down.
    double exact_cost(const PatchNode& node, const CellRectangle& r) const {
        if (std::size_t{r.width} * r.height < node.leaves) return no_room;
        return node.patch >= 0 ? leaf(node, r).cost : best_division(node, r).cost;
    }

    double cost_below(const PatchNode& whole, const PatchNode& node, const CellRectangle& r) const {
        return whole.leaves <= few_patches
                   ? exact_cost(node, r)
                   : node.estimate(double(r.width) * cell_, double(r.height) * cell_);
    }

    Division best_division(const PatchNode& node, const CellRectangle& r) const {
        Division best;
        for (const bool across : {r.width >= r.height, r.width < r.height})
            try_divisions(node, r, across, best);
        return best;
    }

    /// Tries the divisions in one direction that leave a cell for every patch; updates `best`.
    void try_divisions(const PatchNode& node, const CellRectangle& r, bool across,
                       Division& best) const {
        const PatchNode &first = nodes_[node.first], &second = nodes_[node.second];
        const std::uint32_t whole = across ? r.width : r.height,
                            other = across ? r.height : r.width;
        const auto lines = [&](std::size_t leaves) { return double((leaves + other - 1) / other); };
        const double least = lines(first.leaves), most = whole - lines(second.leaves);
        if (most < least) return;
        const double share = whole * (first.texels / node.texels);
        const double nearest = std::round(share), beside = 2.0 * std::floor(share) + 1.0 - nearest;
        for (const double rounded : {nearest, beside}) {
            const auto part = static_cast<std::uint32_t>(std::clamp(rounded, least, most));
            Division division{0.0, r, r};
            (across ? division.first.width : division.first.height) = part;
            (across ? division.second.width : division.second.height) = whole - part;
            (across ? division.second.x : division.second.y) += part;
            if (division.first == best.first) continue;
            division.cost = cost_below(node, first, division.first);
            if (division.cost < best.cost)
                division.cost += cost_below(node, second, division.second);
            if (division.cost < best.cost) best = division;
        }
    }

    Leaf leaf(const PatchNode& node, const CellRectangle& r) const {
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
    std::vector<PatchNode> nodes_;
    std::uint32_t size_, gutter_, cell_, cells_;
};

/// The patches' centres rotated at random by seed `turn` (0: not at all), for another tree of the
/// same patches.
std::vector<Vec3d> turned_centres(std::span<const PatchDemand> patches, int turn) {
    Mat3d rotation(1.0);
    if (turn > 0) {
        std::mt19937 random(static_cast<std::uint32_t>(turn));
        const auto any = [&] { return double(random()) / 4294967296.0 - 0.5; };
        const double z = 0.75 + any(), y = any(), x = any();
        const Vec3d a = glm::normalize(Vec3d(x, y, z));
        const Vec3d b = glm::normalize(glm::cross(a, Vec3d(1.0, any(), 0.0)));
        rotation = Mat3d(a, b, glm::cross(a, b));
    }
    std::vector<Vec3d> centres;
    for (const PatchDemand& patch : patches) centres.push_back(rotation * patch.centre);
    return centres;
}

/// The best layout of `tries` trees with this gutter. Its predicted_stretch is the plain sum of
/// X/w^2 + Y/h^2, infinite if none fits.
PatchLayout best_treemap(std::span<const PatchDemand> patches, std::uint32_t size,
                         std::uint32_t gutter, int tries) {
    PatchLayout best;
    best.gutter = gutter;
    best.predicted_stretch = no_room;
    // Budgets that count gutters favour small patches, budgets without them large ones; either may
    // pack better.
    const std::array<std::vector<PatchNode>, 2> leaves{
        patch_leaves(patches, block_texels(patches, size, gutter), gutter),
        patch_leaves(patches, block_texels(patches, size, 0), gutter)};
    std::vector<PatchBlock> blocks;
    for (int turn = 0; turn < tries; ++turn) {
        const Treemap treemap(
            patches,
            build_patch_tree(leaves[std::size_t(turn) % 2], turned_centres(patches, turn / 2)),
            size, gutter);
        const double stretch = treemap.place(blocks);
        if (!(stretch < best.predicted_stretch)) continue;
        best.predicted_stretch = stretch;
        best.blocks = blocks;
    }
    return best;
}

bool has_cells(std::size_t patches, std::uint32_t size, std::uint32_t gutter) {
    const std::size_t cells = std::max(size / cell_texels(gutter), 1u);
    return cells * cells >= patches;
}

}  // namespace

Vec2d PatchBlock::place(const Vec2d& uv) const {
    const Vec2d q = turned ? Vec2d(1.0 - uv.y, uv.x) : uv;
    return Vec2d(x + gutter + 0.5, y + gutter + 0.5) + q * Vec2d(columns(), rows());
}

double PatchBlock::aspect() const {
    return turned ? double(rows()) / columns() : double(columns()) / rows();
}

std::optional<PatchLayout> layout_patches(std::span<const PatchDemand> patches,
                                          const PatchLayoutOptions& options) {
    if (patches.empty() || options.size < 2) return std::nullopt;
    double area = 0.0;
    for (const PatchDemand& patch : patches) area += patch.area;
    const double ideal = 2.0 * area * area / (double(options.size) * options.size);
    const int most = static_cast<int>(std::max<std::size_t>(most_leaves / patches.size(), 1));
    std::optional<PatchLayout> best;
    double penalty = 1.0;
    for (std::uint32_t gutter = options.gutter.value_or(std::max(options.size / 128, 1u));;
         gutter /= 2, penalty *= halved_gutter) {
        // The predicted stretch is at least 1, whatever the gutter.
        if (best && penalty >= best->cost()) break;
        if (has_cells(patches.size(), options.size, gutter)) {
            PatchLayout layout =
                best_treemap(patches, options.size, gutter, std::min(options.tries, most));
            layout.predicted_stretch /= ideal;
            layout.penalty = penalty;
            if (layout.cost() < (best ? best->cost() : no_room)) best = std::move(layout);
        }
        if (gutter == 0) break;
    }
    return best;
}

}  // namespace burl
