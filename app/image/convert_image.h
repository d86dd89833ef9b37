#pragma once
// The three kinds of baked images, and how they are made of linear light.
#include <variant>
#include <vector>

#include "atlas/base/image.h"
#include "atlas/base/vec.h"

namespace burl {

enum class ImageKind { rgb8, rgb16, rgb_float };

/// The pixels of a baked image, opaque ones first, in the order of ImageKind. 8 and 16 bits are
/// sRGB-encoded, floats are linear light.
using BakedImage =
    std::variant<Image<Rgb8>, Image<Rgb16>, Image<RgbF>, Image<Rgba8>, Image<Rgba16>, Image<RgbaF>>;

/// Whether the image has an alpha channel.
inline bool has_alpha(const BakedImage& image) {
    return std::holds_alternative<Image<Rgba8>>(image) ||
           std::holds_alternative<Image<Rgba16>>(image) ||
           std::holds_alternative<Image<RgbaF>>(image);
}

/// The image, which is in linear light, in sRGB codes, rounded to the nearest. Values outside [0,1]
/// are clamped; NaN gives 0.
Image<Rgb8> to_rgb8(const Image<RgbF>& image);
Image<Rgb16> to_rgb16(const Image<RgbF>& image);

/// The image, which is premultiplied linear light, with colours divided by opacity in sRGB codes
/// and opacity in linear ones, as PNG and glTF have it. Texels of opacity 0 get the colour
/// `transparent`, which viewers mix into borders when they interpolate. A division's rounding stays
/// below every half code: 8 and 16 bits that are multiplied by opacity in floats come back as they
/// were.
Image<Rgba8> to_rgba8(const Image<RgbaF>& image, const RgbF& transparent = {});
Image<Rgba16> to_rgba16(const Image<RgbaF>& image, const RgbF& transparent = {});

/// The mean colour of an image in premultiplied linear light, weighted by opacity; black where all
/// is transparent. The least wrong colour for its transparent texels.
RgbF mean_color(const Image<RgbaF>& image);

/// The mean_color() of an image that comes in rows from the top down.
class ColorMean {
  public:
    void add(const Image<RgbaF>& rows);
    RgbF mean() const;

  private:
    Vec4d sum_{0.0};
};

/// Numbers from 0 to 1 (roughness, metalness, heights) as linear codes, rounded to the nearest.
/// Values outside are clamped; NaN gives 0.
Image<Grey8> to_grey8(const Image<float>& image);
Image<Grey16> to_grey16(const Image<float>& image);

/// Numbers in three or four components as linear codes, rounded to the nearest.
Image<Rgb8> to_linear8(const Image<RgbF>& image);
Image<Rgb16> to_linear16(const Image<RgbF>& image);
Image<Rgba8> to_linear8(const Image<RgbaF>& image);
Image<Rgba16> to_linear16(const Image<RgbaF>& image);

/// The image, which is in linear light, as an image of `kind`.
BakedImage convert_to(Image<RgbF> image, ImageKind kind);
/// The images, which are in linear light, as images of `kind`; each input is freed once it is
/// converted.
std::vector<BakedImage> convert_to(std::vector<Image<RgbF>> levels, ImageKind kind);

}  // namespace burl
