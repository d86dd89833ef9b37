#pragma once
// Noise together with how fast it changes along a texel's two axes: the gradient of f that a filter
// needs (Hart et al. 1999, eq. 10 and DNoise, Perlin 1985), vectorised as in noise_kernels.h and
// with the same bits on every instruction set.
#include "procedural/noise_kernels.h"

namespace burl {

/// What one step in the texture, to the next column (u) and to the next row (v), does to the
/// lattice coordinate of each texel of a batch; per axis of the lattice.
struct DirectionBatch {
    alignas(64) float along_u[3][batch_capacity + batch_padding];
    alignas(64) float along_v[3][batch_capacity + batch_padding];
};

/// Change of f per texel along u and v.
struct SlopeBatch {
    alignas(64) float u[batch_capacity + batch_padding];
    alignas(64) float v[batch_capacity + batch_padding];
};

/// sums[j] += scale * n_seed(texel j), with add_noise's bits, and slopes.u[j] += scale * dn/du,
/// slopes.v[j] likewise. Error of dn/du against float64, for the same cell, place and direction d:
/// at most 1.5e-6 |d|_1 for value noise and 2e-6 |d|_1 for Perlin's.
void add_noise_and_slopes(NoiseKind kind, Fade fade, std::uint32_t seed, double scale,
                          const LatticeBatch& batch, const DirectionBatch& directions,
                          std::size_t count, double* sums, SlopeBatch& slopes);

}  // namespace burl
