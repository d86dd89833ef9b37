#include "app/pipeline/kept_paint.h"

namespace burl {

template <class Pixel>
const Image<Pixel>& KeptPaint::show(const Image<Pixel>& base, std::uint64_t number,
                                    std::span<const PaintStroke> strokes, std::uint64_t& texels) {
    PaintWork work = layer_.update(strokes);
    auto* shown = std::get_if<Shown<Pixel>>(&shown_);
    if (!shown || number != number_) {
        if (!shown) shown = &shown_.emplace<Shown<Pixel>>();
        shown->image = base;
        work.tiles = layer_.painted_tiles();
        work.texels = work.tiles.size() * PaintTiles::side * PaintTiles::side;
    }
    number_ = number;
    for (const std::uint32_t tile : work.tiles) shown->mixer.mix(layer_, tile, base, shown->image);
    texels += work.texels;
    return shown->image;
}

template const Image<Rgb8>& KeptPaint::show(const Image<Rgb8>&, std::uint64_t,
                                            std::span<const PaintStroke>, std::uint64_t&);
template const Image<Rgb16>& KeptPaint::show(const Image<Rgb16>&, std::uint64_t,
                                             std::span<const PaintStroke>, std::uint64_t&);
template const Image<RgbF>& KeptPaint::show(const Image<RgbF>&, std::uint64_t,
                                            std::span<const PaintStroke>, std::uint64_t&);

}  // namespace burl
