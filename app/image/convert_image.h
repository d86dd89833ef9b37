#pragma once
// Conversions between the three pixel types of baked images. RgbF is linear light; Rgb8 and Rgb16
// are sRGB-encoded.
#include "atlas/base/image.h"

namespace burl {

/// The image in 8-bit sRGB codes, rounded to the nearest. Values outside [0,1] are clamped; NaN
/// gives 0.
Image<Rgb8> to_rgb8(const Image<Rgb16>& image);
Image<Rgb8> to_rgb8(const Image<RgbF>& image);
/// The image in 16-bit sRGB codes; an 8-bit code c becomes 257 c, floats are rounded as by to_rgb8.
Image<Rgb16> to_rgb16(const Image<Rgb8>& image);
Image<Rgb16> to_rgb16(const Image<RgbF>& image);
/// The image decoded to linear light, each component in [0,1].
Image<RgbF> to_linear(const Image<Rgb8>& image);
Image<RgbF> to_linear(const Image<Rgb16>& image);

}  // namespace burl
