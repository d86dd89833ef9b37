#pragma once
// What both renderers agree on: the headlight, the background, and how samples become pixels.
// shaders/draw/mesh.frag repeats headlight().
#include <cstdint>

#include "app/scene/camera.h"
#include "atlas/base/image.h"
#include "atlas/base/vec.h"
#include "procedural/color/srgb.h"

namespace burl {

/// What a picture is asked to show, for both renderers.
struct PictureOptions {
    PictureSize size;
    bool lit = true;      ///< false: the surface colour itself
    int supersample = 2;  ///< n: each pixel is the linear-light mean of n x n samples, 1..16
    bool operator==(const PictureOptions&) const = default;
};

inline constexpr int max_supersample = 16;

/// The colour behind everything drawn, as stored and in linear light.
inline constexpr Rgb8 background_srgb{176, 176, 176};
Vec3d background_linear();

inline constexpr double ambient = 0.25;  ///< the headlight gives the rest, 1 - ambient

/// Share of the surface colour that reaches the eye: ambient + (1 - ambient) |n.v|, two-sided.
/// `normal` and `to_eye` need not be unit vectors; a zero normal counts as facing the eye.
double headlight(const Vec3d& normal, const Vec3d& to_eye);

/// The same with a bumped normal in place of n, on the side of the surface that n says is seen:
/// ambient alone where the bumped one faces away from it.
double headlight(const Vec3d& normal, const Vec3d& bumped, const Vec3d& to_eye);

/// Averages supersample x supersample blocks of linear-light samples, encodes them and stores them
/// in `picture` with their corner at pixel (x, y). The sample image's sides are multiples of
/// `supersample` >= 1.
void resolve_samples(const Image<RgbF>& samples, int supersample,
                     const SrgbEncoder<std::uint8_t>& encode, Image<Rgb8>& picture,
                     std::size_t x = 0, std::size_t y = 0);

}  // namespace burl
