#pragma once
// The octaves of a texture that have a vectorised kernel, in groups that share one stream of
// lattice coordinates. An octave joins the group of the octave before it if its coordinates are
// exactly twice as large and its amplitude at most half as large: the shared coordinate's rounding
// error doubles with the coordinates but weighs no more than in the first octave. Any other octave
// begins a group.
#include <span>
#include <vector>

#include "procedural/kernels/stream_kernels.h"
#include "procedural/model/octaves.h"

namespace burl {

/// Octaves of one kind of noise whose lattice coordinates are those of the first times 1, 2, 4, ...
struct OctaveGroup {
    NoiseKind kind = NoiseKind::value;
    Fade fade = Fade::smooth;
    /// Squared radius of simplex noise's kernel.
    double radius2 = 0.0;
    Affine3 lattice_from_solid;  ///< map of the first octave
    double scale = 0.0;          ///< scale of the first octave, to which all weights are relative
    std::vector<StreamOctave> octaves;

    /// The number of doublings of the finest octave.
    int finest() const { return octaves.back().doublings; }
    /// The period of the cells in the group's stream (fill_stream); 0: none.
    double period() const;
};

/// Whether the octave's noise has a vectorised kernel: plain value, Perlin or simplex noise of
/// three dimensions without a period.
bool has_kernel(const Octave& octave);

/// The groups of all octaves that have a kernel, in the order given; octaves without one are in
/// none.
std::vector<OctaveGroup> group_octaves(std::span<const Octave> octaves);

}  // namespace burl
