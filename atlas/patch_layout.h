#pragma once
// Places patches as rectangles that fill the square exactly: a treemap (Shneiderman, "Tree
// visualization with tree-maps", 1992) over a tree of neighbouring patches. How many texels a patch
// gets follows from the error of a bilinear lookup: with K texels it is (XY)/K^2 per area, and the
// sum over patches is least for K ~ (XY / A)^(1/3). Blocks lie on a grid of twice the gutter, so
// that no texel of a MIP level mixes two of them before the gutter itself is used up.
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "atlas/stretch.h"

namespace burl {

/// What placing needs to know of a patch.
struct PatchDemand {
    Stretch stretch;    ///< of its map from the unit square
    double area = 0.0;  ///< mesh units^2
    Vec3d centre{0.0};  ///< of its surface; neighbours in space become neighbours in the tree
};

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
};

struct PatchLayoutOptions {
    std::uint32_t size = 1024;  ///< N
    /// g to start from; default N / 128, at least 1. Halved until the patches fit.
    std::optional<std::uint32_t> gutter;
    int tries = 8;  ///< trees over differently turned centres; the least predicted stretch wins
};

/// Texels a patch should get, in relation to others: (XY / A)^(1/3).
double texel_demand(const PatchDemand& patch);

/// Nothing when the patches outnumber the cells even without a gutter (N^2 / 4 of them).
std::optional<PatchLayout> layout_patches(std::span<const PatchDemand> patches,
                                          const PatchLayoutOptions& options);

}  // namespace burl
