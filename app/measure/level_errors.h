#pragma once
// Errors of a texture's MIP levels against the surface's mean (atlas/measure/surface_truth.h), by
// bilinear lookups within a level; independent of how the levels were computed.
#include <cstdint>
#include <span>
#include <vector>

#include "app/pipeline/pipeline.h"
#include "atlas/measure/lookup_errors.h"

namespace burl {

/// The true means for levels `first` to `last` of the pipeline's texture, at about `points` points
/// of its atlas's mesh; without points for level 0 and for grazing views.
SurfaceTruth level_truth(Pipeline& pipeline, std::uint32_t first, std::uint32_t last,
                         std::size_t points);

/// RMS errors of `levels`, the first of which is level 1, as far as the truth has levels; 0 for
/// levels without means.
std::vector<double> level_errors(const Atlas& atlas, std::span<const Image<RgbF>> levels,
                                 const SurfaceTruth& truth);

}  // namespace burl
