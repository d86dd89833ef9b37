#pragma once
// Between the three kinds of baked image. Float is linear light, the integer kinds sRGB-encoded.
#include "atlas/base/image.h"

namespace burl {

/// Rounded to the nearest code; values outside [0,1] are clamped, NaN gives 0.
Image<Rgb8> to_rgb8(const Image<Rgb16>& image);
Image<Rgb8> to_rgb8(const Image<RgbF>& image);
Image<Rgb16> to_rgb16(const Image<Rgb8>& image);
Image<Rgb16> to_rgb16(const Image<RgbF>& image);
Image<RgbF> to_linear(const Image<Rgb8>& image);
Image<RgbF> to_linear(const Image<Rgb16>& image);

}  // namespace burl
