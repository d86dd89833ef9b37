#pragma once
// The shading that both renderers agree on: headlight, background, and the resolve of samples to
// pixels. shaders/draw/mesh.frag repeats headlight().
#include <cstdint>

#include "app/light/background.h"
#include "app/light/light.h"
#include "app/scene/camera.h"
#include "atlas/base/image.h"
#include "atlas/base/vec.h"
#include "procedural/color/srgb.h"

namespace burl {

/// Options of a picture, for both renderers.
struct PictureOptions {
    PictureSize size;
    bool lit = true;      ///< false: the unlit surface colour
    int supersample = 2;  ///< n in 1..16: a pixel is the linear-light mean of n x n samples
    LightOptions light{};
    Background background{};
    bool ground = false;  ///< whether the object throws a shadow on the ground below it
    bool operator==(const PictureOptions&) const = default;
};

inline constexpr int max_supersample = 16;

/// The background colour in linear light.
Vec3d background_linear();

/// The share of ambient light; the headlight gives 1 - ambient.
inline constexpr double ambient = 0.25;

/// The share of the surface colour that reaches the eye: ambient + (1 - ambient) |n.v|, two-sided.
/// `normal` and `to_eye` need not be unit vectors; a zero normal counts as facing the eye.
double headlight(const Vec3d& normal, const Vec3d& to_eye);

/// The share of the surface colour that reaches the eye with a bumped normal: `normal` decides
/// which side of the surface is seen, and where the bumped normal faces away on that side only
/// ambient light remains.
double headlight(const Vec3d& normal, const Vec3d& bumped, const Vec3d& to_eye);

/// Averages blocks of options.supersample^2 samples, linear light premultiplied by the alpha that
/// hides the background, develops the mean (app/light/tone.h), puts it over the background and
/// stores the codes in `picture` with their corner at pixel (x, y). Alpha is 255 unless the
/// background is transparent; the sample image's sides are multiples of options.supersample.
void resolve_samples(const Image<RgbaF>& samples, const PictureOptions& options,
                     const SrgbEncoder<std::uint8_t>& encode, Image<Rgba8>& picture, std::size_t x,
                     std::size_t y);

/// Averages supersample x supersample blocks of linear-light samples, encodes them and stores them
/// in `picture` with their corner at pixel (x, y). The sample image's sides are multiples of
/// `supersample` >= 1.
void resolve_samples(const Image<RgbF>& samples, int supersample,
                     const SrgbEncoder<std::uint8_t>& encode, Image<Rgb8>& picture,
                     std::size_t x = 0, std::size_t y = 0);

}  // namespace burl
