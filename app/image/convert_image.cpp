// One loop for all conversions, and a function per component type.
#include "app/image/convert_image.h"

#include "procedural/color/srgb.h"

namespace burl {
namespace {

template <class To, class From, class Function>
Image<Rgb<To>> convert(const Image<Rgb<From>>& image, const Function& component) {
    Image<Rgb<To>> result(image.width(), image.height());
    for (std::size_t y = 0; y < image.height(); ++y) {
        for (std::size_t x = 0; x < image.width(); ++x) {
            const Rgb<From>& p = image(x, y);
            result(x, y) = {component(p.r), component(p.g), component(p.b)};
        }
    }
    return result;
}

/// Linear light by sRGB code.
template <class Code>
std::vector<float> decoding_table() {
    const std::size_t count = std::size_t(std::numeric_limits<Code>::max()) + 1;
    std::vector<float> table(count);
    for (std::size_t c = 0; c < count; ++c) {
        table[c] = float(srgb_decode(double(c) / double(count - 1)));
    }
    return table;
}

template <class Code>
Image<RgbF> decoded(const Image<Rgb<Code>>& image) {
    const std::vector<float> table = decoding_table<Code>();
    return convert<float>(image, [&](Code c) { return table[c]; });
}

template <class Code>
Image<Rgb<Code>> encoded(const Image<RgbF>& image) {
    const SrgbEncoder<Code> encode;
    return convert<Code>(image, [&](float v) { return encode(double(v)); });
}

}  // namespace

Image<Rgb8> to_rgb8(const Image<Rgb16>& image) {
    return convert<std::uint8_t>(
        image, [](std::uint16_t c) { return std::uint8_t((c * 255u + 32767u) / 65535u); });
}

Image<Rgb8> to_rgb8(const Image<RgbF>& image) {
    return encoded<std::uint8_t>(image);
}

Image<Rgb16> to_rgb16(const Image<Rgb8>& image) {
    return convert<std::uint16_t>(image, [](std::uint8_t c) { return std::uint16_t(c * 257u); });
}

Image<Rgb16> to_rgb16(const Image<RgbF>& image) {
    return encoded<std::uint16_t>(image);
}

Image<RgbF> to_linear(const Image<Rgb8>& image) {
    return decoded(image);
}

Image<RgbF> to_linear(const Image<Rgb16>& image) {
    return decoded(image);
}

}  // namespace burl
