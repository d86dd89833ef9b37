#pragma once
// A binary tree of neighbouring patches with an estimate of every node's cost in a rectangle of any
// proportions: a dynamic programme over the logarithm of width over height from the leaves up, in
// which a node's rectangle is divided in proportion to its halves' texels, one way or the other. It
// tells a treemap which way to divide without looking further down.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/patch/budget.h"

namespace burl {

/// Costs by log2(width / height) from -4 to 4 in steps of 1/4, in a rectangle with the node's
/// texels.
using AspectCosts = std::array<double, 33>;

/// A node of the tree: one patch, or two halves.
struct PatchNode {
    double texels = 0.0;                ///< texels of the blocks below, gutters included
    double inner = 0.0;                 ///< texels of the blocks below between the patches' borders
    std::size_t leaves = 1;             ///< number of patches below
    std::int32_t patch = -1;            ///< patch of a leaf; -1: not a leaf
    std::size_t first = 0, second = 0;  ///< numbers of the halves
    AspectCosts costs{};

    /// Estimated cost of the node in a rectangle of any size, given in texels.
    double estimate(double width, double height) const;
};

/// Leaves of the tree: every patch alone on a block of so many texels, where it costs X / w^2 + Y /
/// h^2.
std::vector<PatchNode> patch_leaves(std::span<const PatchDemand> patches,
                                    std::span<const double> texels, std::uint32_t gutter);

/// The tree over the patches: their texels are halved recursively along the longest extent of the
/// centres. Halves come before the whole, which is the last node. `leaves` and `centres` have one
/// entry per patch.
std::vector<PatchNode> build_patch_tree(std::span<const PatchNode> leaves,
                                        std::span<const Vec3d> centres);

}  // namespace burl
