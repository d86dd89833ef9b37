#include "app/image/convert_image.h"

#include <utility>

#include "procedural/color/pixel_encoder.h"

namespace burl {
namespace {

template <class Code>
Image<Rgb<Code>> opaque(const Image<RgbF>& image) {
    const PixelEncoder<Rgb<Code>> encode;
    return converted<Rgb<Code>>(image, [&](const RgbF& p) { return encode({p.r, p.g, p.b}); });
}

template <class Code>
Image<Rgba<Code>> divided(const Image<RgbaF>& image, const RgbF& transparent) {
    const PixelEncoder<Rgba<Code>> encode;
    Rgba<Code> nothing = encode({transparent.r, transparent.g, transparent.b, 1.0});
    nothing.a = 0;
    return converted<Rgba<Code>>(image, [&](const RgbaF& p) {
        return p.a > 0.0f ? encode({p.r, p.g, p.b, p.a}) : nothing;
    });
}

template <class Code>
Image<Rgb<Code>> numbers(const Image<RgbF>& image) {
    const auto code = [](float v) { return linear_code<Code>(double(v)); };
    return converted<Rgb<Code>>(image, [&](const RgbF& p) {
        return Rgb<Code>{code(p.r), code(p.g), code(p.b)};
    });
}

template <class Code>
Image<Rgba<Code>> numbers(const Image<RgbaF>& image) {
    const auto code = [](float v) { return linear_code<Code>(double(v)); };
    return converted<Rgba<Code>>(image, [&](const RgbaF& p) {
        return Rgba<Code>{code(p.r), code(p.g), code(p.b), code(p.a)};
    });
}

}  // namespace

Image<Rgb8> to_rgb8(const Image<RgbF>& image) {
    return opaque<std::uint8_t>(image);
}

Image<Rgb16> to_rgb16(const Image<RgbF>& image) {
    return opaque<std::uint16_t>(image);
}

Image<Rgba8> to_rgba8(const Image<RgbaF>& image, const RgbF& transparent) {
    return divided<std::uint8_t>(image, transparent);
}

Image<Rgba16> to_rgba16(const Image<RgbaF>& image, const RgbF& transparent) {
    return divided<std::uint16_t>(image, transparent);
}

void ColorMean::add(const Image<RgbaF>& rows) {
    Vec4d sum = sum_;
    for (const RgbaF& p : rows.pixels()) sum += Vec4d(p.r, p.g, p.b, p.a);
    sum_ = sum;
}

RgbF ColorMean::mean() const {
    if (!(sum_.w > 0.0)) return {};
    return {float(sum_.x / sum_.w), float(sum_.y / sum_.w), float(sum_.z / sum_.w)};
}

RgbF mean_color(const Image<RgbaF>& image) {
    ColorMean mean;
    mean.add(image);
    return mean.mean();
}

Image<Grey8> to_grey8(const Image<float>& image) {
    return converted<Grey8>(image, linear_code<Grey8>);
}

Image<Grey16> to_grey16(const Image<float>& image) {
    return converted<Grey16>(image, linear_code<Grey16>);
}

Image<Rgb8> to_linear8(const Image<RgbF>& image) {
    return numbers<std::uint8_t>(image);
}

Image<Rgb16> to_linear16(const Image<RgbF>& image) {
    return numbers<std::uint16_t>(image);
}

Image<Rgba8> to_linear8(const Image<RgbaF>& image) {
    return numbers<std::uint8_t>(image);
}

Image<Rgba16> to_linear16(const Image<RgbaF>& image) {
    return numbers<std::uint16_t>(image);
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
