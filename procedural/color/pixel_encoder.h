#pragma once
// The conversion of linear light, without and with opacity, and of numbers to a pixel of any of the
// image formats: sRGB codes of 8 or 16 bits, linear codes, or floats.
#include <algorithm>
#include <limits>

#include "atlas/base/image.h"
#include "atlas/base/vec.h"
#include "procedural/batch/texel_batch.h"
#include "procedural/color/srgb.h"

namespace burl {

template <class Pixel>
class PixelEncoder;

template <class Code>
class PixelEncoder<Rgb<Code>> {
  public:
    Rgb<Code> operator()(const Vec3d& c) const {
        return {encode_(c.x), encode_(c.y), encode_(c.z)};
    }

  private:
    SrgbEncoder<Code> encode_;
};

template <>
class PixelEncoder<RgbF> {
  public:
    RgbF operator()(const Vec3d& c) const { return {float(c.x), float(c.y), float(c.z)}; }
};

/// The linear code of a number: 0..1 becomes 0 to the greatest code, rounded to the nearest;
/// numbers outside are clamped, NaN gives 0. Code: Grey8 or Grey16.
template <class Code>
Code linear_code(double value) {
    constexpr double max_code = std::numeric_limits<Code>::max();
    if (!(value > 0.0)) return 0;
    return Code(std::min(value, 1.0) * max_code + 0.5);
}

/// Encodes linear light with opacity, (r a, g a, b a, a): RgbaF keeps it, codes hold the colour
/// divided by the opacity and the opacity as a linear code. Transparent texels, which have no
/// colour, are black.
template <class Code>
class PixelEncoder<Rgba<Code>> {
  public:
    Rgba<Code> operator()(const Vec4d& c) const {
        if (!(c.w > 0.0)) return {};
        return {encode_(c.x / c.w), encode_(c.y / c.w), encode_(c.z / c.w), linear_code<Code>(c.w)};
    }

  private:
    SrgbEncoder<Code> encode_;
};

template <>
class PixelEncoder<RgbaF> {
  public:
    RgbaF operator()(const Vec4d& c) const {
        return {float(c.x), float(c.y), float(c.z), float(c.w)};
    }
};

/// PixelEncoder for streams of colours: stream.color[c] is the array of channel c, of at most
/// batch_capacity numbers and aligned to 64 bytes.
template <class Pixel>
class StreamEncoder {
  public:
    /// Calls emit(i, pixel) for the first `count` colours.
    template <class Stream, class Emit>
    void operator()(const Stream& stream, std::size_t count, const Emit& emit) const {
        for (std::size_t i = 0; i < count; ++i)
            emit(i, encode_({stream.color[0][i], stream.color[1][i], stream.color[2][i]}));
    }

  private:
    PixelEncoder<Pixel> encode_;
};

template <>
class StreamEncoder<Rgb8> {
  public:
    template <class Stream, class Emit>
    void operator()(const Stream& stream, std::size_t count, const Emit& emit) const {
        alignas(64) std::uint8_t codes[3][batch_capacity + batch_padding];
        for (std::size_t c = 0; c < 3; ++c) encode_(stream.color[c], count, codes[c]);
        for (std::size_t i = 0; i < count; ++i)
            emit(i, Rgb8{codes[0][i], codes[1][i], codes[2][i]});
    }

  private:
    SrgbStreamEncoder encode_;
};

}  // namespace burl
