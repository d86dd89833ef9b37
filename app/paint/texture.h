#pragma once
// Paint laid over a texture's texels: decoded, mixed in linear light, encoded once. Texels without
// paint keep their bits.
#include <span>
#include <vector>

#include "app/paint/layer.h"
#include "atlas/base/image.h"
#include "procedural/color/pixel_encoder.h"

namespace burl {

/// Lays tiles of paint over pixels of a kind: Rgb8, Rgb16 or RgbF.
template <class Pixel>
class PaintMixer {
  public:
    PaintMixer();

    /// Writes the tile's texels of `image`: those of `base` under its paint. Both have the layer's
    /// rows, from number `first` of theirs on, and may be the same.
    void mix(const PaintLayer& layer, std::size_t tile, const Image<Pixel>& base,
             Image<Pixel>& image, std::size_t first = 0) const;

  private:
    Vec3f light(const Pixel& pixel) const;

    PixelEncoder<Pixel> encode_;
    std::vector<float> decoded_;  ///< per code; none for floats
};

/// Lays the strokes over the texture of an atlas, about a million texels at a time: paint takes 32
/// bytes a texel. For Rgb8, Rgb16 and RgbF. `threads` 0: all; the
/// result does not depend on it. The image may be some rows alone of the texture, from `first` on,
/// a multiple of PaintTiles::side. Gives the texels that it went through.
template <class Pixel>
std::uint64_t paint_over(const SolidAtlas& solid, std::span<const PaintStroke> strokes, int threads,
                         Image<Pixel>& image, std::size_t first = 0);

}  // namespace burl
