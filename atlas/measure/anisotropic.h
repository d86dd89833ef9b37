#pragma once
// Anisotropic lookup: trilinear probes on a line, weighted as the footprint is (McCormack, Perry,
// Farkas, Jouppi, "Feline: Fast Elliptical Lines for Anisotropic Texture Mapping", 1999), at most
// eight of them as graphics hardware set to 8x takes.
#include "atlas/base/mip_chain.h"
#include "atlas/measure/surface_points.h"

namespace burl {

inline constexpr int most_probes = 8;

/// A Gaussian footprint in the texture, in texels of level 0: one standard deviation along its
/// longer axis, and how much it is across.
struct TexelFootprint {
    Vec2d major{0.0};
    double minor = 0.0;
};

/// The ellipse with a + b cos, sin as conjugate half axes: the image of a circle under (a, b).
TexelFootprint texel_footprint(const Vec2d& a, const Vec2d& b);

/// Where the triangle's map takes a vector of its plane, in texels; 0 for triangles without area.
Vec2d mapped(const Mesh& mesh, const Atlas& atlas, std::uint32_t triangle, const Vec3d& vector);

/// `levels` in linear light from level 0, `at` in texels of level 0. Level log2(2 minor), or where
/// eight probes are too few for the length the one that major / 8 asks for; probes lie in the
/// middles of equal parts of the line on which the footprint, cut at gaussian_cut, is longer than
/// wide.
Vec3d anisotropic(const MipChain<Vec3f>& levels, const Vec2d& at, const TexelFootprint& footprint);

/// Linear between bilinear lookups in the two nearest levels; `level` is held to those there are.
Vec3d trilinear(const MipChain<Vec3f>& levels, const Vec2d& at, double level);

}  // namespace burl
