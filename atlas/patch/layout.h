#pragma once
// Places patches as rectangles that fill the square exactly: a treemap (Shneiderman, "Tree
// visualization with tree-maps", 1992) over a tree of neighbouring patches, each with the texels
// its map and its gutter ask for (patch_budget). Blocks lie on a grid of twice the gutter, so that
// no texel of a MIP level mixes two of them before the gutter itself is used up.
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "atlas/patch/budget.h"

namespace burl {

/// Texels [x, x+width) x [y, y+height) of one patch. The outermost `gutter` texels on each side
/// repeat nothing of the surface; the patch's border runs through the centres of the outermost
/// inner texels.
struct PatchBlock {
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
    std::uint32_t gutter = 0;
    bool turned = false;  ///< a quarter turn: u runs along +y, v along -x

    /// Steps from border to border.
    std::uint32_t columns() const { return width - 2 * gutter - 1; }
    std::uint32_t rows() const { return height - 2 * gutter - 1; }
    /// Where a point of the patch's unit square lies, in texels (centres at .5).
    Vec2d place(const Vec2d& uv) const;
    /// Width over height of the block as the patch sees it.
    double aspect() const;
    bool operator==(const PatchBlock&) const = default;
};

struct PatchLayout {
    std::vector<PatchBlock> blocks;  ///< per patch
    std::uint32_t gutter = 0;        ///< g: blocks lie on multiples of 2 max(g, 1)
    /// Mean over the surface of (|ds/dx|^2 + |ds/dy|^2) / 2 per texel, over what a square without
    /// loss would have: 1 is ideal.
    double predicted_stretch = 0.0;
    double penalty = 1.0;  ///< halved_gutter to the power of how often the gutter was halved
    /// What layouts are chosen by.
    double cost() const { return predicted_stretch * penalty; }
};

/// How much less stretch a gutter of half the width must bring: it bleeds one MIP level earlier.
inline constexpr double halved_gutter = 1.5;

struct PatchLayoutOptions {
    std::uint32_t size = 1024;  ///< N
    /// g to start from; default N / 128, at least 1. Halved until the patches fit, and where that
    /// makes up for the bleeding.
    std::optional<std::uint32_t> gutter;
    int tries = 8;  ///< trees over differently turned centres; the least predicted stretch wins
};

/// Time is linear in the patches (but for sorting) and independent of the size. Nothing when the
/// patches outnumber the cells even without a gutter (N^2 / 4 of them).
std::optional<PatchLayout> layout_patches(std::span<const PatchDemand> patches,
                                          const PatchLayoutOptions& options);

}  // namespace burl
