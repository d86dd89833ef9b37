#pragma once
// How far MIP levels of a recipe's texture are from what the surface shows there, whatever rule
// they were made by: plain bilinear lookups against the surface's mean
// (atlas/measure/surface_truth.h).
#include <cstdint>
#include <span>
#include <vector>

#include "app/pipeline/pipeline.h"
#include "atlas/measure/lookup_errors.h"

namespace burl {

/// The truth about levels `first` to `last` of the pipeline's texture at about `points` points of
/// its atlas's mesh. It has no points for level 0 and no grazing ones.
SurfaceTruth level_truth(Pipeline& pipeline, std::uint32_t first, std::uint32_t last,
                         std::size_t points);

/// RMS errors of `levels`, of which the first is level 1; as many as the truth has, 0 for those
/// that it has no means of.
std::vector<double> level_errors(const Atlas& atlas, std::span<const Image<RgbF>> levels,
                                 const SurfaceTruth& truth);

}  // namespace burl
