#pragma once
// A batch of texels whose field is evaluated together, with the scratch arrays of the evaluation.
#include <vector>

#include "procedural/batch/texel_batch.h"
#include "procedural/field/octave_streams.h"
#include "procedural/kernels/quadric_kernel.h"
#include "procedural/kernels/slope_kernels.h"

namespace burl {

/// Batch of at most batch_capacity texels, packed from pieces of several spans; one per thread.
struct FieldBatch {
    std::vector<Piece> pieces;
    /// Number of texels in all pieces.
    std::size_t count = 0;
    /// f of every texel, in the order of the pieces.
    alignas(64) double field[batch_capacity + batch_padding];
    /// df/du and df/dv per texel, filled by FieldSampler::values_and_slopes or
    /// average_with_corners.
    SlopeBatch slopes;
    /// Sample positions of FieldSampler::values_at_offsets.
    TexelOffsets offsets;

    std::vector<ParabolaLine> parabolas;
    StreamBuffers streams;
};

}  // namespace burl
