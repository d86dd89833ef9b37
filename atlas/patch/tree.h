#pragma once
// A binary tree of neighbouring patches, and what every node of it would cost in a rectangle of any
// proportions: a dynamic programme over the logarithm of width over height from the leaves up, in
// which a node's rectangle is divided in proportion to its halves' texels, one way or the other. It
// tells a treemap which way to divide without looking further down.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/patch/budget.h"

namespace burl {

/// Cost by log2(width / height) from -4 to 4, in a rectangle with the node's texels.
using AspectCosts = std::array<double, 33>;

struct PatchNode {
    double texels = 0.0;  ///< of the blocks below, gutters included
    double inner = 0.0;   ///< of those, between the patches' borders
    std::size_t leaves = 1;
    std::int32_t patch = -1;
    std::size_t first = 0, second = 0;  ///< numbers of the halves
    AspectCosts costs{};

    /// Estimate for a rectangle of whatever size.
    double estimate(double width, double height) const;
};

/// Every patch alone on a block of so many texels, where it costs X / w^2 + Y / h^2.
std::vector<PatchNode> patch_leaves(std::span<const PatchDemand> patches,
                                    std::span<const double> texels, std::uint32_t gutter);

/// Texels halved recursively along the longest extent of the centres; halves come before the whole,
/// which is the last. `leaves` and `centres` have one entry per patch.
std::vector<PatchNode> build_patch_tree(std::span<const PatchNode> leaves,
                                        std::span<const Vec3d> centres);

}  // namespace burl
