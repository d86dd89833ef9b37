#pragma once
// Compositing of paint over a texture's texels: each is decoded, mixed in linear light and encoded
// once. Texels without paint keep their bits.
#include <span>
#include <vector>

#include "app/paint/layer.h"
#include "atlas/base/image.h"
#include "procedural/color/pixel_encoder.h"

namespace burl {

/// Composites tiles of paint over an image of Rgb8, Rgb16 or RgbF.
template <class Pixel>
class PaintMixer {
  public:
    PaintMixer();

    /// Writes the tile's texels of `image`: those of `base` with the tile's paint over them. Row
    /// `first` of both images is the layer's first row; they may be the same image.
    void mix(const PaintLayer& layer, std::size_t tile, const Image<Pixel>& base,
             Image<Pixel>& image, std::size_t first = 0) const;

  private:
    Vec3f light(const Pixel& pixel) const;

    PixelEncoder<Pixel> encode_;
    std::vector<float> decoded_;  ///< linear light by sRGB code; empty for floats
};

/// Composites the strokes of colour over an atlas's texture in bands of about a million texels,
/// since paint takes 32 bytes per texel. Pixel is Rgb8, Rgb16 or RgbF. 0 threads means all; the
/// result does not depend on the number. The image may be a band of the texture's rows that begins
/// at row `first`, a multiple of PaintTiles::side. Returns the number of texels in tiles that a
/// stroke reaches.
template <class Pixel>
std::uint64_t paint_over(const SolidAtlas& solid, std::span<const PaintStroke> strokes, int threads,
                         Image<Pixel>& image, std::size_t first = 0);

}  // namespace burl
