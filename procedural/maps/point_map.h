#pragma once
// Point maps, solid maps and span maps filled on the host, from the atlas's spans (Carr & Hart
// 2001, section 5.1).
#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/point_map.h"
#include "procedural/field/lattice_map.h"

namespace burl {

/// The point map of an area. Start and step of every span go through `map`, and the texels lie on
/// the line of these. With `in_lattice`, a coordinate that reaches lattice_limit on a span is 0 on
/// all of it, as for octaves that are evaluated texel by texel (noise/lattice_site.h). `maps` has
/// as many elements as the atlas has maps.
PointMap fill_point_map(const SolidAtlas& solid, std::span<const TexelMap> maps, const Affine3& map,
                        bool in_lattice, const TexelArea& area, int threads);

/// The middle of the box of all points mapped by `map`. Offsets from it are at most half the
/// solid's size, so that float32 holds them to 2^-25 of that, wherever the solid lies.
Vec3d solid_base(const SolidAtlas& solid, const Affine3& map);

/// The solid map of an area: points mapped by `map`, less `base`, and their owners.
SolidMap fill_solid_map(const SolidAtlas& solid, const Affine3& map, const Vec3d& base,
                        const TexelArea& area, int threads);

/// The span map of an area, from which, and the maps of the triangles, a shader computes points
/// beside the texels' centres (shaders/maps/texel_line.glsl). It has four words per texel: the
/// number of its span's map, the first column and the number of texels of the whole span, and 0;
/// no_owner and zeros where no span shows anything. The area must lie in the atlas; `threads` 0
/// means all.
Image<MapTexel> fill_span_map(const SolidAtlas& solid, const TexelArea& area, int threads);

}  // namespace burl
