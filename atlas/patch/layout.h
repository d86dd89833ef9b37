#pragma once
// Layout of patches as rectangles that fill the square exactly: a treemap (Shneiderman, "Tree
// visualization with tree-maps", 1992) over a tree of neighbouring patches, each with the texels
// that its map and its gutter ask for (budget.h). Blocks lie on a grid of twice the gutter, so that
// no texel of a MIP level mixes two of them before the gutter itself is used up.
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "atlas/patch/budget.h"

namespace burl {

/// The block of one patch: texels [x, x+width) x [y, y+height). The outermost `gutter` texels on
/// each side continue the surface beyond the patch; the patch's border runs through the centres of
/// the outermost inner texels.
struct PatchBlock {
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
    std::uint32_t gutter = 0;
    bool turned = false;  ///< quarter turn: u runs along +y, v along -x

    /// Number of texel steps from border to border, along x and along y.
    std::uint32_t columns() const { return width - 2 * gutter - 1; }
    std::uint32_t rows() const { return height - 2 * gutter - 1; }
    /// Place in the texture of a point of the patch's unit square, in texels (centres at .5).
    Vec2d place(const Vec2d& uv) const;
    /// Width over height of the block in the patch's own directions, u over v.
    double aspect() const;
    bool operator==(const PatchBlock&) const = default;
};

/// The blocks of all patches in a square texture.
struct PatchLayout {
    std::vector<PatchBlock> blocks;  ///< block of each patch
    std::uint32_t gutter = 0;        ///< width g in texels: blocks lie on multiples of 2 max(g, 1)
    /// S1: the mean over the surface of (|ds/dx|^2 + |ds/dy|^2) / 2 per texel, relative to that of
    /// a square without loss: 1 is ideal.
    double predicted_stretch = 0.0;
    double penalty = 1.0;  ///< halved_gutter to the power of the number of halvings of the gutter
    /// The cost by which layouts are chosen.
    double cost() const { return predicted_stretch * penalty; }
};

/// Factor by which half the gutter must reduce the stretch to be worth it: half a gutter bleeds one
/// MIP level earlier.
inline constexpr double halved_gutter = 1.5;

/// Size of the texture, gutter and effort of a layout.
struct PatchLayoutOptions {
    std::uint32_t size = 1024;  ///< N, the texture's side in texels
    /// The gutter in texels to start from; default N / 128, at least 1. It is halved until the
    /// patches fit, and where that makes up for the bleeding.
    std::optional<std::uint32_t> gutter{};
    int tries = 8;  ///< trees over differently rotated centres to try
};

/// The layout with the least cost. Time is linear in the number of patches (but for sorting) and
/// independent of the size. Nothing when the patches outnumber the cells even without a gutter (N^2
/// / 4 cells).
std::optional<PatchLayout> layout_patches(std::span<const PatchDemand> patches,
                                          const PatchLayoutOptions& options);

}  // namespace burl
