#pragma once
// Streams of points beside the texels' centres, which supersampling needs.
#include "procedural/kernels/stream_kernels.h"

namespace burl {

/// The offsets of a batch's points from the texels' centres, in texels, -1 to 1.
struct TexelOffsets {
    alignas(64) float u[batch_capacity + batch_padding];
    alignas(64) float v[batch_capacity + batch_padding];
};

/// Moves a stream that fill_stream filled with the same pieces from the texels' centres to these
/// points, rounding once more to 2^-32 cells. A component of a texel's side of 2^50 cells or more
/// counts as 0.
void move_stream(const Affine3& lattice_from_solid, std::span<const Piece> pieces,
                 const TexelOffsets& offsets, LatticeStream& stream);

}  // namespace burl
