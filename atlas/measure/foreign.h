#pragma once
// Bleeding: how much of a lookup's weight falls on texels that are not the point's own chart's.
#include <span>

#include "atlas/measure/surface_points.h"
#include "atlas/measure/texture_values.h"

namespace burl {

struct ForeignShare {
    double foreign = 0.0;      ///< texels of another chart or of none
    double other_chart = 0.0;  ///< texels holding another chart's value
};

/// Mean over the points of plain bilinear lookups in level `level`, whose texels are means of
/// 4^level texels (sizes that are no power of two: of the texels they touch). `charts`: chart per
/// triangle.
ForeignShare foreign_share(const Atlas& atlas, const TextureValues& texture,
                           std::span<const std::uint32_t> charts,
                           std::span<const SurfacePoint> points, std::uint32_t level);

}  // namespace burl
