#pragma once
// The octaves of a texture that vectorised kernels know, in groups that share one stream of lattice
// coordinates: an octave joins the one before it if its coordinates are exactly twice as large and
// its amplitude at most half as large, so that the shared coordinate's rounding, doubled too,
// weighs no more than in the first. The others have groups of their own.
#include <span>
#include <vector>

#include "procedural/kernels/stream_kernels.h"
#include "procedural/model/octaves.h"

namespace burl {

struct OctaveGroup {
    NoiseKind kind = NoiseKind::value;
    Fade fade = Fade::smooth;
    double radius2 = 0.0;
    Affine3 lattice_from_solid;  ///< of the first octave
    double scale = 0.0;          ///< of the first octave; the others' weights are relative to it
    std::vector<StreamOctave> octaves;

    /// Doublings of the finest octave.
    int finest() const { return octaves.back().doublings; }
    /// Of the cells in its stream (fill_stream).
    double period() const;
};

/// Whether a vectorised kernel knows the octave's noise.
bool has_kernel(const Octave& octave);

/// Every octave that has a kernel, in the order given; those without are left out.
std::vector<OctaveGroup> group_octaves(std::span<const Octave> octaves);

}  // namespace burl
