#pragma once
// Octaves on streams of texels that often lie in the same cell as the texel before: the corners of
// a cell are hashed once and used for all its texels. Perlin's lattice noise spends most of its
// time on corners, and a row of texels crosses a lattice plane only every so many texels. The bits
// are those of the direct kernel, in which everything after the hash is the same.
#include <span>

#include "procedural/kernels/slope_kernels.h"

namespace burl {

/// The runs of a stream's texels that stay in one cell of the finest octave that shares the runs,
/// and so in one cell of all coarser octaves.
struct CellRuns {
    std::size_t count = 0;
    LatticeStream first;  ///< first texels of the runs
    /// The number of each texel's run.
    alignas(64) std::uint32_t run[batch_capacity + 2 * batch_padding];
};

/// Finds the runs of `count` texels in the lattice of the octave after `doublings`.
void find_runs(const LatticeStream& stream, int doublings, std::size_t count, CellRuns& runs);

/// The kernel that reads `runs`, with the bits of direct_kernel or, with `gradients`, of
/// gradient_kernel.
OctaveKernel sharing_kernel(NoiseKind kind, Fade fade, bool gradients);

}  // namespace burl
