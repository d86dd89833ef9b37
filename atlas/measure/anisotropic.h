#pragma once
// Anisotropic lookup: trilinear probes on a line, weighted by the footprint (McCormack, Perry,
// Farkas, Jouppi, "Feline: Fast Elliptical Lines for Anisotropic Texture Mapping", 1999), at most
// eight of them, as many as graphics hardware set to 8x takes.
#include "atlas/base/mip_chain.h"
#include "atlas/measure/surface_points.h"

namespace burl {

/// Largest number of probes of a lookup.
inline constexpr int most_probes = 8;

/// A Gaussian footprint in the texture, in texels of level 0: the vector of one standard deviation
/// along its longer axis, and the standard deviation across it.
struct TexelFootprint {
    Vec2d major{0.0};
    double minor = 0.0;
};

/// The footprint whose standard deviations form the ellipse with a and b as conjugate half axes:
/// the image of the unit circle under the matrix (a, b).
TexelFootprint texel_footprint(const Vec2d& a, const Vec2d& b);

/// The image of a vector of the triangle's plane under the triangle's map, in texels; 0 for
/// triangles without area.
Vec2d mapped(const Mesh& mesh, const Atlas& atlas, std::uint32_t triangle, const Vec3d& vector);

/// The filtered colour at `at`, in texels of level 0; `levels` are in linear light from level 0.
/// Probes read level log2(2 minor), or log2(2 major / 8) where eight probes are too few for the
/// footprint's length. They lie on its longer axis, in the middles of equal parts of a line that
/// ends gaussian_cut times sqrt(major^2 - minor^2) from `at` on either side.
Vec3d anisotropic(const MipChain<Vec3f>& levels, const Vec2d& at, const TexelFootprint& footprint);

/// Linear interpolation between bilinear lookups in the two nearest levels; `at` is in texels of
/// level 0, and `level` is clamped to the levels of the chain.
Vec3d trilinear(const MipChain<Vec3f>& levels, const Vec2d& at, double level);

}  // namespace burl
