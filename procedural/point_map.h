#pragma once
// The points that an atlas's texels show, as images: in float64 for octaves that no stream serves,
// and as float32 offsets from one base with each texel's owner, the solid map of an atlas (Carr &
// Hart 2001, section 5.1) that a shader textures from elsewhere.
#include "atlas/image.h"
#include "procedural/lattice_map.h"

namespace burl {

/// Of texels outside every span.
inline constexpr std::uint32_t no_owner = 0xffffffffu;

/// Points as halves of float64 numbers, the lower first; not numbers outside every span.
struct PointMap {
    Image<MapTexel> xy;
    Image<MapTexel> z_owner;  ///< z, the number of the texel's map (Span::map) and 0
};

/// Points through `map`: start and step of every span are mapped, texels lie on the line of these.
/// With `in_lattice`, a span that reaches lattice_limit on an axis is at 0 on it, as octaves that
/// are evaluated texel by texel have it (lattice_line.h). `maps` as many as the atlas has.
PointMap fill_point_map(const SolidAtlas& solid, std::span<const TexelMap> maps, const Affine3& map,
                        bool in_lattice, const TexelArea& area, int threads);

/// Every texel's point is base + local.
struct SolidMap {
    Image<Vec4f> local;  ///< x, y, z; w is 1 in spans, all is 0 elsewhere
    Image<std::uint32_t> owners;
};

/// The middle of all points through `map`: offsets from it are at most half the solid's size, so
/// that float32 holds them to 2^-25 of that, wherever the solid lies.
Vec3d solid_base(const SolidAtlas& solid, const Affine3& map);

SolidMap fill_solid_map(const SolidAtlas& solid, const Affine3& map, const Vec3d& base,
                        const TexelArea& area, int threads);

}  // namespace burl
