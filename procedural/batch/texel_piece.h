#pragma once
// Pieces of an atlas's spans, of which batches of texels are made.
#include "procedural/batch/texel_batch.h"

namespace burl {

/// Consecutive texels of one row of the image, with the line of solid points that they show.
struct Piece {
    std::size_t x = 0, y = 0;
    LatticeLine solid;
    /// The change of the solid point to the next row.
    Vec3d down{0.0};
    double length = 0.0;  ///< texels of the whole span, or 0 where this piece is all of it
};

}  // namespace burl
