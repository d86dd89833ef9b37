#pragma once
// Patches are the better atlas and take long to lay out: an editor shows a large mesh with pairs
// first, which take a tenth of the time, and lays out patches meanwhile.
#include <optional>
#include <stop_token>

#include "app/pipeline/pipeline.h"

namespace burl {

/// Meshes with more triangles: patches of so many take about a second on two cores.
inline constexpr std::size_t many_faces = 40000;

/// What to show a mesh with at once: the atlas that is wanted, or for patches of many faces a quad
/// atlas of the largest size not above it.
AtlasOptions atlas_at_once(const AtlasOptions& wanted, std::size_t triangles);

/// Makes the atlas of the pipeline's recipe and its texels' points on all cores but one, where
/// there are several, and behind whatever else they are wanted for. False: `stop` came first.
bool lay_out_aside(Pipeline& pipeline, const std::stop_token& stop);

}  // namespace burl
