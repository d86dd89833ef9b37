#pragma once
// Bleeding: the share of a lookup's weight on texels that do not belong to the point's own chart.
#include <span>

#include "atlas/measure/surface_points.h"
#include "atlas/measure/texture_values.h"

namespace burl {

/// Shares, 0 to 1, of the weight of lookups.
struct ForeignShare {
    double foreign = 0.0;      ///< share on texels of another chart or of none
    double other_chart = 0.0;  ///< share on texels that hold another chart's value
};

/// Mean shares over the points for plain bilinear lookups in level `level`, whose texels are means
/// of 4^level texels (for sizes that are no power of two, of the texels they touch). `charts` holds
/// each triangle's chart.
ForeignShare foreign_share(const Atlas& atlas, const TextureValues& texture,
                           std::span<const std::uint32_t> charts,
                           std::span<const SurfacePoint> points, std::uint32_t level);

}  // namespace burl
