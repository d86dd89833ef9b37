#pragma once
// Lookups of a texture as graphics hardware defines them, in double, clamped to the image's edge:
// bilinear, trilinear, and anisotropic by trilinear probes on a line, weighted by the footprint
// (McCormack, Perry, Farkas, Jouppi, "Feline: Fast Elliptical Lines for Anisotropic Texture
// Mapping", 1999), at most eight of them, as many as graphics hardware set to 8x takes.
#include <algorithm>
#include <array>
#include <cmath>

#include "atlas/base/image.h"
#include "atlas/base/mip_chain.h"
#include "atlas/base/vec.h"
#include "atlas/measure/surface_points.h"

namespace burl {

/// The four texels of a lookup and their weights, which add to 1.
struct BilinearTaps {
    std::array<std::size_t, 2> x{}, y{};
    std::array<double, 2> weight_x{}, weight_y{};
};

/// The taps of a lookup at `at`, in texels of an image of that size; texel (i,j) has its centre at
/// (i+0.5, j+0.5).
inline BilinearTaps bilinear_taps(const Vec2d& at, std::size_t width, std::size_t height) {
    BilinearTaps taps;
    const auto axis = [](double coordinate, std::size_t size, auto& index, auto& weight) {
        const double last = double(size) - 1.0;
        const double c = std::clamp(coordinate - 0.5, 0.0, last);
        const double low = std::floor(c);
        index = {std::size_t(low), std::size_t(std::min(low + 1.0, last))};
        weight = {1.0 - (c - low), c - low};
    };
    axis(at.x, width, taps.x, taps.weight_x);
    axis(at.y, height, taps.y, taps.weight_y);
    return taps;
}

/// The bilinearly filtered value at `at`, in texels of the image.
inline Vec3d bilinear(const Image<Vec3f>& image, const Vec2d& at) {
    const BilinearTaps t = bilinear_taps(at, image.width(), image.height());
    Vec3d sum(0.0);
    for (std::size_t j : {0u, 1u})
        for (std::size_t i : {0u, 1u})
            sum += t.weight_x[i] * t.weight_y[j] * Vec3d(image(t.x[i], t.y[j]));
    return sum;
}

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

/// Steps of a place from pixel to pixel along the screen's axes, in texels of level 0.
struct TexelSteps {
    Vec2d x{0.0}, y{0.0};
};

/// The axes, at right angles, of the ellipse that the pixel's round shape covers in the texture
/// (Heckbert, "Fundamentals of Texture Mapping and Image Warping", 1989), as steps.
TexelSteps ellipse_steps(const TexelSteps& steps);

/// The lookup of a sampler of GL_LINEAR_MIPMAP_LINEAR with TEXTURE_MAX_ANISOTROPY `most` >= 1 by
/// the example algorithm of GL_EXT_texture_filter_anisotropic (1 is plain trilinear filtering): N =
/// min(ceil(longer / shorter step), most) equally weighted trilinear probes lie on the longer step
/// at i / (N + 1) - 1/2 of it, i = 1..N, in level log2(longer / N).
Vec3d sampler_lookup(const MipChain<Vec3f>& levels, const Vec2d& at, const TexelSteps& steps,
                     int most);

/// Linear interpolation between bilinear lookups in the two nearest levels; `at` is in texels of
/// level 0, and `level` is clamped to the levels of the chain.
Vec3d trilinear(const MipChain<Vec3f>& levels, const Vec2d& at, double level);

}  // namespace burl
