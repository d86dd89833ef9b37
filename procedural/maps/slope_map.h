#pragma once
// What a filter on a graphics processor needs of a texel besides its lattice maps
// (procedural/field/lattice_map.h): the quadric's slopes along its sides (Hart et al. 1999, eq.
// 11), and the number of its triangle's map, by which shaders find the sides in the lattices of the
// octaves.
#include "atlas/solid/solid_atlas.h"
#include "procedural/field/lattice_map.h"
#include "procedural/field/octave_groups.h"

namespace burl {

/// The bits of the slopes along u and v in float32, those of fill_quadric_slopes; the map's number;
/// 0. Where no span shows anything 0.
Image<MapTexel> fill_slope_map(const SolidAtlas& solid, std::span<const TexelMap> maps,
                               const Quadric& quadric, const TexelArea& area, int threads);

/// For each map of the atlas and each group two texels: the sides along u and v in the group's
/// lattice times its scale and unit, x, y, z, as add_slopes has them; 0.
std::vector<Vec4f> lattice_sides(std::span<const TexelMap> maps,
                                 std::span<const OctaveGroup> groups);

/// For each map of the atlas and each octave of the groups the share of it that the map's texels
/// show (band_limit.h).
std::vector<float> octave_shares(std::span<const TexelMap> maps,
                                 std::span<const OctaveGroup> groups);

/// For each map of the atlas and each of the octaves, which have no stream kernel, two numbers: the
/// scale of what the map's texels show of it, and the mean of what they do not.
std::vector<Vec2d> lone_terms(std::span<const TexelMap> maps, std::span<const Octave> octaves);

}  // namespace burl
