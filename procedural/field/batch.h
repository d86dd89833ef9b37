#pragma once
// Texels whose field is evaluated together, and the arrays that takes.
#include <vector>

#include "procedural/batch/texel_piece.h"
#include "procedural/field/octave_streams.h"
#include "procedural/kernels/quadric_kernel.h"
#include "procedural/kernels/slope_kernels.h"

namespace burl {

/// What a thread works with: pieces of several spans packed into one stream of texels.
struct FieldBatch {
    std::vector<Piece> pieces;
    std::size_t count = 0;
    alignas(64) double field[batch_capacity + batch_padding];
    SlopeBatch slopes;
    TexelOffsets offsets;  ///< for values_at_offsets

    std::vector<ParabolaLine> parabolas;
    StreamBuffers streams;
};

}  // namespace burl
