#pragma once
// Octaves on streams of texels that often lie in the same cell as the texel before: the corners of
// a cell are hashed once and given to all its texels. Perlin's lattice noise spends most of its
// time on corners, and neighbouring texels of an atlas cross a lattice plane only every so many
// texels. The bits are those of the direct kernel, in which everything after the hash is the same.
#include <span>

#include "procedural/kernels/slope_kernels.h"

namespace burl {

/// Texels of a stream in runs that stay in one cell: of the finest octave that shares the runs, and
/// so of all coarser ones.
struct CellRuns {
    std::size_t count = 0;
    LatticeStream first;  ///< the runs' first texels
    /// Per texel, the number of its run.
    alignas(64) std::uint32_t run[batch_capacity + 2 * batch_padding];
};

/// Runs after `doublings`, of `count` texels.
void find_runs(const LatticeStream& stream, int doublings, std::size_t count, CellRuns& runs);

/// As add_octave_direct, to the bit. `runs` are those of at least octave.doublings.
void add_octave_shared(NoiseKind kind, Fade fade, const StreamOctave& octave,
                       const LatticeStream& stream, const CellRuns& runs, std::size_t count,
                       float* sums);

/// As add_octave_and_gradient, to the bit.
void add_octave_and_gradient_shared(NoiseKind kind, Fade fade, const StreamOctave& octave,
                                    const LatticeStream& stream, const CellRuns& runs,
                                    std::size_t count, float* sums, GradientSums& gradients);

}  // namespace burl
