#pragma once
// The unfiltered colours of field values, for runs of texels: 8-bit pixels by a table and
// vectorised, other pixels texel by texel.
#include "procedural/batch/texel_batch.h"
#include "procedural/color/pixel_encoder.h"
#include "procedural/color/table.h"

namespace burl {

/// A thread's buffers for the look-ups of up to batch_capacity texels.
struct ColorBuffers {
    alignas(64) std::int32_t places[batch_capacity + batch_padding];
    alignas(64) ColorCode codes[batch_capacity + batch_padding];
    std::uint32_t later[batch_capacity + 2 * batch_padding];
};

/// The colours of a map as pixels. A call of pixels() needs a call of look_up() with the same f and
/// buffers before it; look_up() reads f up to the end of a vector of floats.
template <class Pixel>
class PointColors {
  public:
    explicit PointColors(const ColorMap& map) : map_(map) {}
    void look_up(const double*, std::size_t, ColorBuffers&) const {}
    /// Writes the colours of f[at..at+count) to pixels[0..count).
    void pixels(const double* f, std::size_t at, std::size_t count, const ColorBuffers&,
                Pixel* pixels) const {
        for (std::size_t j = 0; j < count; ++j) pixels[j] = (*this)(f[at + j]);
    }
    /// The colour of one field value.
    Pixel operator()(double f) const { return encode_(map_(f)); }

  private:
    PreparedColorMap map_;
    PixelEncoder<Pixel> encode_;
};

template <>
class PointColors<Rgb8> {
  public:
    explicit PointColors(const ColorMap& map) : table_(map) {}
    void look_up(const double* f, std::size_t count, ColorBuffers& buffers) const {
        index(f, count, buffers.places);
        look_up(buffers.places, f, count, buffers);
    }
    /// The table's places of f, which do not depend on the map's colours; written up to the end of
    /// a vector of floats.
    void index(const double* f, std::size_t count, std::int32_t* places) const {
        index_colors(table_.wrap(), f, count, ColorTable8::places, places);
    }
    /// Looks colours up by places, which must be aligned to 64 bytes; f, which takes twice their
    /// memory, is read only where a place does not decide the colour.
    void look_up(const std::int32_t* places, const double* f, std::size_t count,
                 ColorBuffers& buffers) const {
        table_.look_up(places, f, count, buffers.codes, buffers.later);
    }
    void pixels(const double*, std::size_t at, std::size_t count, const ColorBuffers& buffers,
                Rgb8* pixels) const {
        pack_pixels(buffers.codes + at, count, pixels);
    }
    Rgb8 operator()(double f) const { return table_(f); }

  private:
    ColorTable8 table_;
};

}  // namespace burl
