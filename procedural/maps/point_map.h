#pragma once
// Fills point maps and solid maps on the host, from the atlas's spans (Carr & Hart 2001, section
// 5.1).
#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/point_map.h"

namespace burl {

/// Points through `map`: start and step of every span are mapped, texels lie on the line of these.
/// With `in_lattice`, a span that reaches lattice_limit on an axis is at 0 on it, as octaves that
/// are evaluated texel by texel have it (lattice_line.h). `maps` as many as the atlas has.
PointMap fill_point_map(const SolidAtlas& solid, std::span<const TexelMap> maps, const Affine3& map,
                        bool in_lattice, const TexelArea& area, int threads);

/// The middle of all points through `map`: offsets from it are at most half the solid's size, so
/// that float32 holds them to 2^-25 of that, wherever the solid lies.
Vec3d solid_base(const SolidAtlas& solid, const Affine3& map);

SolidMap fill_solid_map(const SolidAtlas& solid, const Affine3& map, const Vec3d& base,
                        const TexelArea& area, int threads);

}  // namespace burl
