#pragma once
// The images and tables that a filter on a graphics processor needs besides lattice maps
// (procedural/field/lattice_map.h): the quadric's slopes along a texel's sides (Hart et al. 1999,
// eq. 11), and the number of its triangle's map, by which shaders find the sides in the octaves'
// lattices.
#include "atlas/solid/solid_atlas.h"
#include "procedural/field/lattice_map.h"
#include "procedural/field/octave_groups.h"

namespace burl {

/// Four words per texel: the bits of the quadric's slopes along u and v in float32 (those of
/// fill_quadric_slopes), the number of the texel's map, and 0; all 0 where no span shows anything.
Image<MapTexel> fill_slope_map(const SolidAtlas& solid, std::span<const TexelMap> maps,
                               const Quadric& quadric, const TexelArea& area, int threads);

/// Two texels for each map of the atlas and each group: the sides along u and v in the group's
/// lattice, times its scale and unit, as x, y, z (with add_slopes' bits) and 0.
std::vector<Vec4f> lattice_sides(std::span<const TexelMap> maps,
                                 std::span<const OctaveGroup> groups);

/// The share of each octave of the groups that a map's texels show (model/band_limit.h), for each
/// map of the atlas.
std::vector<float> octave_shares(std::span<const TexelMap> maps,
                                 std::span<const OctaveGroup> groups);

/// Two numbers for each map of the atlas and each octave, none of which has a stream kernel: the
/// octave's scale times the share that the map's texels show, and the mean of the rest.
std::vector<Vec2d> lone_terms(std::span<const TexelMap> maps, std::span<const Octave> octaves);

}  // namespace burl
