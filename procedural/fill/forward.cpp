#include "procedural/fill/forward.h"

#include <vector>

#include "procedural/batch/economy.h"
#include "procedural/batch/row_tasks.h"
#include "procedural/bresenham/field.h"
#include "procedural/color/pixel_encoder.h"
#include "procedural/color/table.h"

namespace burl {

namespace {

/// An image of pixel(f) for every texel in a span, and of `background` elsewhere.
template <class Pixel, class Shade>
Image<Pixel> fill(const SolidAtlas& solid, const Texture& texture, const Affine3& map,
                  ForwardPrecision precision, int threads, const Economy& economy,
                  const RowWindow& window, const Pixel& background, const Shade& pixel) {
    constexpr std::size_t texels_per_task = 8192;
    const std::vector<Octave> octaves = expand_octaves(texture);
    const RowWindow own_rows = window.of(solid.size);
    Image<Pixel> rows_of_image(solid.size, own_rows.count(), background);
    const RowBand image(rows_of_image, own_rows.first);
    WorkSum total(economy.work);
    const auto fill_rows = [&](const RowRange& rows) {
        SynthesisWork work;
        std::vector<double> f(solid.size);
        for (std::size_t y = image.first + rows.begin(); y != image.first + rows.end(); ++y)
            for (const Span& span : solid.row(y)) {
                const TexelMap& texel = solid.maps[span.map];
                // Differences add up from the whole span's start.
                const WholeSpan whole = solid.whole(span);
                const LatticeLine line{map(texel(whole.x, std::int64_t(y))),
                                       map.linear * texel.step_x, 0.0, whole.count};
                forward_values(texture.quadric, octaves, line, {.precision = precision}, f.data());
                const double* own = f.data() + (span.x - whole.x);
                Pixel* pixels = &image(span.x, y);
                for (std::size_t j = 0; j < span.count; ++j) pixels[j] = pixel(own[j]);
                work.texels += span.count;
            }
        work.octaves = work.texels * octaves.size();
        total.add(work);
        economy.count(1, work.texels);
    };
    for_row_ranges(own_rows.count(), texels_per_task, threads, fill_rows, economy.stop);
    return rows_of_image;
}

}  // namespace

template <class Pixel>
Image<Pixel> synthesize_forward(const SolidAtlas& solid, const Texture& texture, const Affine3& map,
                                ForwardPrecision precision, int threads, const Economy& economy,
                                const RowWindow& rows) {
    const PreparedColorMap color(texture.colors);
    const PixelEncoder<Pixel> encode;
    const auto pixel = [&](double f) { return encode(color(f)); };
    return fill(solid, texture, map, precision, threads, economy, rows, pixel(0.0), pixel);
}

template <>
Image<Rgb8> synthesize_forward(const SolidAtlas& solid, const Texture& texture, const Affine3& map,
                               ForwardPrecision precision, int threads, const Economy& economy,
                               const RowWindow& rows) {
    const ColorTable8 color(texture.colors);
    return fill(solid, texture, map, precision, threads, economy, rows, color(0.0), color);
}

template Image<Rgb16> synthesize_forward(const SolidAtlas&, const Texture&, const Affine3&,
                                         ForwardPrecision, int, const Economy&, const RowWindow&);
template Image<RgbF> synthesize_forward(const SolidAtlas&, const Texture&, const Affine3&,
                                        ForwardPrecision, int, const Economy&, const RowWindow&);

Image<double> forward_field_of_atlas(const SolidAtlas& solid, const Texture& texture,
                                     const Affine3& map, ForwardPrecision precision, int threads) {
    return fill(solid, texture, map, precision, threads, {}, {}, 0.0, [](double f) { return f; });
}

}  // namespace burl
