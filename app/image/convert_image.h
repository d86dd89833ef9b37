#pragma once
// The three kinds of baked images, and how they are made of linear light.
#include <variant>
#include <vector>

#include "atlas/base/image.h"

namespace burl {

enum class ImageKind { rgb8, rgb16, rgb_float };

/// The pixels of a baked image, in the order of ImageKind. 8 and 16 bits are sRGB-encoded, floats
/// are linear light.
using BakedImage = std::variant<Image<Rgb8>, Image<Rgb16>, Image<RgbF>>;

/// The image, which is in linear light, in sRGB codes, rounded to the nearest. Values outside [0,1]
/// are clamped; NaN gives 0.
Image<Rgb8> to_rgb8(const Image<RgbF>& image);
Image<Rgb16> to_rgb16(const Image<RgbF>& image);

/// The image, which is in linear light, as an image of `kind`.
BakedImage convert_to(Image<RgbF> image, ImageKind kind);
/// The images, which are in linear light, as images of `kind`; each input is freed once it is
/// converted.
std::vector<BakedImage> convert_to(std::vector<Image<RgbF>> levels, ImageKind kind);

}  // namespace burl
