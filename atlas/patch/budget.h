#pragma once
// The texel budget: the number of texels of each patch. The error of a bilinear lookup with K
// texels is (XY)/K^2 per area, and the sum over patches is least for K ~ (XY / A)^(1/3). Gutters
// and the half texels of the border come on top: they take a larger share of a small block, so that
// blocks are not simply in proportion to K.
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/chart/stretch.h"

namespace burl {

/// The data of a patch that its layout in the texture needs.
struct PatchDemand {
    Stretch stretch;    ///< stretch of its map from the unit square
    double area = 0.0;  ///< area in mesh units^2
    Vec3d centre{0.0};  ///< centroid of its surface; the tree joins near ones
};

/// Side, in texels, of the grid's cells: blocks begin and end on multiples of it.
constexpr std::uint32_t cell_texels(std::uint32_t gutter) {
    return gutter > 0 ? 2 * gutter : 2;
}

/// Inner texels that a patch should get in relation to other patches: (XY / A)^(1/3); 0 for a patch
/// without area.
double texel_demand(const PatchDemand& patch);

/// Texels of every block, gutter included, with which all blocks together fill size x size texels
/// and the inner texels are in proportion to the demand. At least one cell each, even where that
/// exceeds the texture.
std::vector<double> block_texels(std::span<const PatchDemand> patches, std::uint32_t size,
                                 std::uint32_t gutter);

}  // namespace burl
