#pragma once
// What a texture's octaves and its quadric are evaluated from, texel by texel, as two images that a
// graphics processor reads: where the texel lies in the lattice of a group of octaves, in 32.32
// fixed point, and the quadric's value (Hart et al. 1999, eq. 1 and 3). The numbers are those that
// host synthesis works with, to the bit, so that shaders need no float64 to agree with it.
#include <cstdint>

#include "atlas/base/image.h"
#include "procedural/batch/map_texel.h"
#include "procedural/field/octave_groups.h"

namespace burl {

/// All that the lattice coordinates of a stream depend on, besides the atlas.
struct LatticeStreamKey {
    Affine3 lattice_from_solid;
    int doublings = 0;    ///< of the finest octave that reads them: fill_stream
    double period = 0.0;  ///< of the cells: fill_stream
    bool operator==(const LatticeStreamKey&) const = default;
};

inline LatticeStreamKey stream_key(const OctaveGroup& group) {
    return {group.lattice_from_solid, group.finest(), group.period()};
}

/// Upper and lower half of the quadric's value where no span shows anything: not a number, which
/// stays so whatever is added, and whose colour is that of field 0.
inline constexpr std::uint64_t no_quadric = 0x7ff80000'00000000;

/// Without a stream, cells and places are 0; without a quadric, its value is 0 in spans.
struct LatticeMap {
    Image<MapTexel> cells;   ///< cells along x, y and z modulo 2^32, upper half of q as float64
    Image<MapTexel> places;  ///< places in them in units of 2^-32 cells, lower half of q
};

}  // namespace burl
