#pragma once
// The affine map of the node `transform`, for every evaluation that needs it.
#include "procedural/graph/batch.h"

namespace burl {

/// The map p -> matrix (translate + rotate_z rotate_y rotate_x scale p).
Affine3 transform_map(const NodeCall& call);

}  // namespace burl
