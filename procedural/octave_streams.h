#pragma once
// The octaves of a texture that vectorised kernels know, in groups that share one stream of lattice
// coordinates: an octave joins the one before it if its coordinates are exactly twice as large and
// its amplitude at most half as large, so that the shared coordinate's rounding, doubled too,
// weighs no more than in the first. The others have groups of their own.
#include <vector>

#include "procedural/kernel.h"
#include "procedural/octaves.h"
#include "procedural/share_kernels.h"

namespace burl {

/// What a thread works with.
struct StreamBuffers {
    LatticeStream lattice;
    CellRuns runs;
    alignas(64) float sums[batch_capacity + batch_padding];
};

/// Whether a vectorised kernel knows the octave's noise.
bool has_kernel(const Octave& octave);

class OctaveStreams {
  public:
    explicit OctaveStreams(std::span<const Octave> octaves, Kernel kernel = Kernel::automatic);

    /// values[j] += the octaves that have a kernel, without their offsets, at the centres of the
    /// pieces' texels, `count` in all. Within a group the sum is float32, from the finest octave to
    /// the coarsest; groups are added up in float64.
    void add(std::span<const Piece> pieces, std::size_t count, StreamBuffers& buffers,
             double* values) const;

  private:
    struct Group {
        NoiseKind kind = NoiseKind::value;
        Fade fade = Fade::smooth;
        Affine3 lattice_from_solid;
        double scale = 0.0;  ///< of the first octave
        std::vector<StreamOctave> octaves;
    };
    /// Number of a group's coarsest octaves that share corners where the first crosses so many
    /// planes of the lattice per texel.
    std::size_t sharing(const Group& group, double crossings) const;

    std::vector<Group> groups_;
    Kernel kernel_;
};

}  // namespace burl
