#pragma once
// Noise together with its gradient (Hart et al. 1999, eq. 10, and DNoise, Perlin 1985), on streams
// of texels: filters need the change of f along a texel's two sides. The gradients of all octaves
// of a stream are added up in its lattice coordinates, and only their sum is multiplied by the
// sides. Kernels are vectorised as in texel_batch.h, with the same bits on every instruction set.
#include "procedural/kernels/stream_kernels.h"
#include "procedural/model/octaves.h"

namespace burl {

/// Sums of gradients, one array per axis of a stream's lattice.
struct GradientSums {
    alignas(64) float along[3][batch_capacity + batch_padding];
};

/// The change of f per texel along u and v.
struct SlopeBatch {
    alignas(64) float u[batch_capacity + batch_padding];
    alignas(64) float v[batch_capacity + batch_padding];
};

/// The kernel that gives the sums of direct_kernel, to the bit, and adds weight * dn /
/// stream_unit(kind) with respect to the stream's coordinates to the gradients. A component of dn
/// errs, for the same cell and place in the octave's own coordinates, by at most 1e-6 (measured
/// over 1.2e6 numbers each: 8.3e-7 for value noise and 8.8e-7 for Perlin's; rms 7e-8 and 9e-8).
OctaveKernel gradient_kernel(NoiseKind kind, Fade fade);

/// slopes += scale * gradients along the sides of the pieces' texels. A side's component of 2^50
/// cells or more counts as 0.
void add_slopes(const Affine3& lattice_from_solid, double scale, std::span<const Piece> pieces,
                const GradientSums& gradients, SlopeBatch& slopes);

/// slopes = the slopes of the quadric (eq. 11), which are linear along a line.
void fill_quadric_slopes(const Quadric& quadric, std::span<const Piece> pieces, SlopeBatch& slopes);

}  // namespace burl
