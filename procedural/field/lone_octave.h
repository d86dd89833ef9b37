#pragma once
// A single octave that moves, on lines of spans that are kept: from the lines to the sum in one go.
// Nobody shares its coordinates, so that of a texel's cell only the hash leaves the registers, and
// its noise goes straight to the sum. Vectorised as in texel_batch.h.
#include "procedural/kernels/stream_kernels.h"

namespace burl {

/// An octave with a stream of its own, of `value` or `perlin`.
struct LoneOctave {
    NoiseKind kind = NoiseKind::value;
    Fade fade = Fade::smooth;
    std::uint32_t seed = 0;
    Affine3 lattice_from_solid;
    double scale = 0.0;  ///< of the octave in the sum, stream_unit included
};

/// How many planes of the lattice the lines cross per texel, about: as a rule of thumb for kernels.
double crossings_per_texel(const Affine3& lattice_from_solid, const SpanLines& lines);

/// values[j] = lines.needed[j] + the octave: the bits of fill_stream, add_octave_direct and
/// add_sums_to. Whole vectors are written: both arrays are padded. Nothing, and false, where lines
/// are far from the lattice's origin.
bool add_lone_octave(const LoneOctave& octave, const SpanLines& lines, double* values);

}  // namespace burl
