#pragma once
// Where the texels of a batch come from: pieces of the atlas's spans.
#include "procedural/batch/texel_batch.h"

namespace burl {

/// Consecutive texels of one row of the image, the line of solid coordinates they show and the step
/// to the next row.
struct Piece {
    std::size_t x = 0, y = 0;
    LatticeLine solid;
    Vec3d down{0.0};
    double length = 0.0;  ///< texels of the whole span, if it is longer than this
};

}  // namespace burl
