#pragma once
// How many texels each patch gets. The error of a bilinear lookup with K texels is (XY)/K^2 per
// area, and the sum over patches is least for K ~ (XY / A)^(1/3). Gutters and the half texels of
// the border come on top: they take a larger share of a small block, so that blocks are not simply
// in proportion to K.
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/patch/stretch.h"

namespace burl {

/// What placing needs to know of a patch.
struct PatchDemand {
    Stretch stretch;    ///< of its map from the unit square
    double area = 0.0;  ///< mesh units^2
    Vec3d centre{0.0};  ///< of its surface; neighbours in space become neighbours in the tree
};

/// Blocks begin and end on multiples of so many texels.
constexpr std::uint32_t cell_texels(std::uint32_t gutter) {
    return gutter > 0 ? 2 * gutter : 2;
}

/// Texels a patch should get, in relation to others: (XY / A)^(1/3); 0 for one without area.
double texel_demand(const PatchDemand& patch);

/// Texels of every block, gutter included, with which together they fill size x size texels and the
/// inner ones are in proportion to the demand. At least one cell each, even where those are more.
std::vector<double> block_texels(std::span<const PatchDemand> patches, std::uint32_t size,
                                 std::uint32_t gutter);

}  // namespace burl
