#include "app/paint/texture.h"

#include <algorithm>
#include <type_traits>

#include "procedural/batch/row_tasks.h"

namespace burl {

namespace {

/// The number of texels in a band of paint_over().
constexpr std::size_t texels_at_once = std::size_t(1) << 20;

}  // namespace

template <class Pixel>
PaintMixer<Pixel>::PaintMixer() {
    if constexpr (!std::is_same_v<Pixel, RgbF>)
        decoded_.resize(std::size_t(SrgbEncoder<decltype(Pixel::r)>::max_code) + 1);
    for (std::size_t code = 0; code < decoded_.size(); ++code)
        decoded_[code] = float(srgb_decode(double(code) / double(decoded_.size() - 1)));
}

template <class Pixel>
Vec3f PaintMixer<Pixel>::light(const Pixel& pixel) const {
    if constexpr (std::is_same_v<Pixel, RgbF>)
        return {pixel.r, pixel.g, pixel.b};
    else
        return {decoded_[pixel.r], decoded_[pixel.g], decoded_[pixel.b]};
}

template <class Pixel>
void PaintMixer<Pixel>::mix(const PaintLayer& layer, std::size_t tile, const Image<Pixel>& base,
                            Image<Pixel>& image, std::size_t first) const {
    constexpr std::size_t side = PaintTiles::side;
    const std::span<const PaintLight> paint = layer.paint(tile);
    const std::size_t column = tile % layer.tiles().columns();
    const std::size_t y_begin = first + tile / layer.tiles().columns() * side;
    const std::size_t x_end = std::min(base.width(), (column + 1) * side),
                      y_end = std::min(base.height(), y_begin + side);
    for (std::size_t y = y_begin; y < y_end; ++y) {
        for (std::size_t x = column * side; x < x_end; ++x) {
            const Pixel& below = base(x, y);
            Pixel& texel = image(x, y);
            texel = below;
            if (paint.empty()) continue;
            const PaintLight& over = paint[(y - y_begin) * side + x % side];
            if (over.a > 0.0f) texel = encode_(Vec3d(painted(over, light(below))));
        }
    }
}

template <class Pixel>
std::uint64_t paint_over(const SolidAtlas& solid, std::span<const PaintStroke> strokes, int threads,
                         Image<Pixel>& image, std::size_t first) {
    const std::vector<PaintStroke> colors = strokes_of(strokes, 0);
    if (colors.empty()) return 0;
    const PaintMixer<Pixel> mixer;
    const std::size_t at_once =
        PaintTiles::side *
        std::max<std::size_t>(1, texels_at_once / (PaintTiles::side * image.width()));
    std::uint64_t texels = 0;
    for (std::size_t begin = 0; begin < image.height(); begin += at_once) {
        const std::size_t end = std::min(begin + at_once, image.height());
        PaintLayer layer(solid, threads, {first + begin, first + end});
        texels += layer.update(colors).texels;
        for (const std::uint32_t tile : layer.painted_tiles())
            mixer.mix(layer, tile, image, image, begin);
    }
    return texels;
}

template class PaintMixer<Rgb8>;
template class PaintMixer<Rgb16>;
template class PaintMixer<RgbF>;
template std::uint64_t paint_over(const SolidAtlas&, std::span<const PaintStroke>, int,
                                  Image<Rgb8>&, std::size_t);
template std::uint64_t paint_over(const SolidAtlas&, std::span<const PaintStroke>, int,
                                  Image<Rgb16>&, std::size_t);
template std::uint64_t paint_over(const SolidAtlas&, std::span<const PaintStroke>, int,
                                  Image<RgbF>&, std::size_t);

}  // namespace burl
