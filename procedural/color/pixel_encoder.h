#pragma once
// The conversion of linear light to a pixel of any of the image formats: sRGB codes of 8 or 16
// bits, or floats of linear light.
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
