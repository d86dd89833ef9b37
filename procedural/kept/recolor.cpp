#include "procedural/kept/recolor.h"

#include <memory>

#include "procedural/batch/row_tasks.h"
#include "procedural/color/point_colors.h"

namespace burl {

namespace {

/// Recolours all rows; color(at, count, buffers, painter) paints the batch of `count` numbers from
/// index `at` on.
template <class Pixel, class Color>
void recolor(const RecolorTask& task, const Pixel& background, Image<Pixel>& image,
             const Color& color) {
    const auto color_rows = [&](const RowRange& range) {
        const auto buffers = std::make_unique_for_overwrite<ColorBuffers>();
        for (std::size_t y = range.begin(); y != range.end(); ++y) {
            RowPainter<Pixel> painter(task.rows.runs(y), image.row(y), background);
            task.rows.for_each_batch(
                y, [&](std::size_t at, std::size_t count) { color(at, count, *buffers, painter); });
        }
    };
    for_row_ranges(task.size, 8 * batch_capacity, task.threads, color_rows, task.economy.stop);
}

}  // namespace

template <class Pixel>
void recolor_field(const RecolorTask& task, const ColorMap& map, const double* field,
                   Image<Pixel>& image) {
    const PointColors<Pixel> colors(map);
    recolor(task, colors(0.0), image,
            [&](std::size_t at, std::size_t count, ColorBuffers& buffers, auto& painter) {
                colors.look_up(field + at, count, buffers);
                painter(count, [&](std::size_t first, std::size_t part, Pixel* pixels) {
                    colors.pixels(field + at, first, part, buffers, pixels);
                });
            });
}

template void recolor_field(const RecolorTask&, const ColorMap&, const double*, Image<Rgb8>&);
template void recolor_field(const RecolorTask&, const ColorMap&, const double*, Image<Rgb16>&);
template void recolor_field(const RecolorTask&, const ColorMap&, const double*, Image<RgbF>&);

void recolor_places(const RecolorTask& task, const ColorMap& map, const double* field, bool known,
                    std::int32_t* places, Image<Rgb8>& image) {
    const PointColors<Rgb8> colors(map);
    recolor(task, colors(0.0), image,
            [&](std::size_t at, std::size_t count, ColorBuffers& buffers, auto& painter) {
                const double* f = field + at;
                if (!known) colors.index(f, count, places + at);
                colors.look_up(places + at, f, count, buffers);
                painter(count, [&](std::size_t first, std::size_t part, Rgb8* pixels) {
                    colors.pixels(f, first, part, buffers, pixels);
                });
            });
}

}  // namespace burl
