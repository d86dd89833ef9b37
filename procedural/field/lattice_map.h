#pragma once
// Lattice coordinates and quadric of every texel as two images for a graphics processor: the
// texel's position in the lattice of a group of octaves, in 32.32 fixed point, and the quadric's
// value (Hart et al. 1999, eq. 1 and 3). The numbers have the bits of host synthesis, so that
// shaders need no float64 to agree with it.
#include <cstdint>

#include "atlas/base/image.h"
#include "procedural/batch/map_texel.h"
#include "procedural/field/octave_groups.h"

namespace burl {

/// Cache key of a stream's lattice coordinates: all that they depend on besides the atlas.
struct LatticeStreamKey {
    Affine3 lattice_from_solid;
    int doublings = 0;  ///< number of doublings of the finest octave that reads them (fill_stream)
    double period = 0.0;  ///< period of the cells (fill_stream); 0: none
    bool operator==(const LatticeStreamKey&) const = default;
};

/// The key of the coordinates that all octaves of `group` share.
inline LatticeStreamKey stream_key(const OctaveGroup& group) {
    return {group.lattice_from_solid, group.finest(), group.period()};
}

/// Bits of the quadric's value at texels in no span: a NaN, which stays NaN whatever is added to it
/// and has the colour of field 0.
inline constexpr std::uint64_t no_quadric = 0x7ff80000'00000000;

/// Lattice map of one atlas. Cells and places are 0 if no stream was asked for, the quadric's value
/// is 0 at the texels of spans if no quadric was.
struct LatticeMap {
    Image<MapTexel> cells;   ///< cells along x, y and z modulo 2^32; upper half of the float64 q
    Image<MapTexel> places;  ///< places in the cells in units of 2^-32 cells; lower half of q
};

}  // namespace burl
