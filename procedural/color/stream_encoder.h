#pragma once
// PixelEncoder for streams of colours whose channels are separate arrays.
#include "procedural/color/map_filter_kernels.h"
#include "procedural/color/pixel_encoder.h"
#include "procedural/color/srgb_kernels.h"

namespace burl {

template <class Pixel>
class StreamEncoder {
  public:
    /// Calls emit(i, pixel) for the first `count` colours.
    template <class Emit>
    void operator()(const FootprintStream& stream, std::size_t count, const Emit& emit) const {
        for (std::size_t i = 0; i < count; ++i)
            emit(i, encode_({stream.color[0][i], stream.color[1][i], stream.color[2][i]}));
    }

  private:
    PixelEncoder<Pixel> encode_;
};

template <>
class StreamEncoder<Rgb8> {
  public:
    template <class Emit>
    void operator()(const FootprintStream& stream, std::size_t count, const Emit& emit) const {
        alignas(64) std::uint8_t codes[3][batch_capacity + batch_padding];
        for (std::size_t c = 0; c < 3; ++c) encode_(stream.color[c], count, codes[c]);
        for (std::size_t i = 0; i < count; ++i)
            emit(i, Rgb8{codes[0][i], codes[1][i], codes[2][i]});
    }

  private:
    SrgbStreamEncoder encode_;
};

}  // namespace burl
