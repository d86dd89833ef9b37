#include "app/image/convert_image.h"

#include <utility>

#include "procedural/color/srgb.h"

namespace burl {
namespace {

template <class Code>
Image<Rgb<Code>> encoded(const Image<RgbF>& image) {
    const SrgbEncoder<Code> encode;
    const auto code = [&](float v) { return encode(double(v)); };
    Image<Rgb<Code>> result(image.width(), image.height());
    for (std::size_t y = 0; y < image.height(); ++y) {
        for (std::size_t x = 0; x < image.width(); ++x) {
            const RgbF& p = image(x, y);
            result(x, y) = {code(p.r), code(p.g), code(p.b)};
        }
    }
    return result;
}

}  // namespace

Image<Rgb8> to_rgb8(const Image<RgbF>& image) {
    return encoded<std::uint8_t>(image);
}

Image<Rgb16> to_rgb16(const Image<RgbF>& image) {
    return encoded<std::uint16_t>(image);
}

BakedImage convert_to(Image<RgbF> image, ImageKind kind) {
    if (kind == ImageKind::rgb16) return to_rgb16(image);
    if (kind == ImageKind::rgb_float) return image;
    return to_rgb8(image);
}

std::vector<BakedImage> convert_to(std::vector<Image<RgbF>> levels, ImageKind kind) {
    std::vector<BakedImage> result;
    for (Image<RgbF>& level : levels) {
        result.push_back(convert_to(std::move(level), kind));
        level = {};
    }
    return result;
}

}  // namespace burl
