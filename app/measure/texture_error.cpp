#include "app/measure/texture_error.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/base/mapped_box.h"
#include "app/image/image_diff.h"
#include "app/measure/metrics_pictures.h"
#include "app/paint/texture.h"
#include "app/pipeline/fill_texture.h"
#include "app/recipe/lattice_check.h"
#include "atlas/base/error.h"
#include "atlas/solid/level.h"
#include "procedural/batch/row_tasks.h"
#include "procedural/color/srgb.h"
#include "procedural/graph/masks.h"

namespace burl {

namespace {

constexpr std::size_t error_texels_per_task = 8192;

double difference(std::uint8_t code, float linear) {
    const double exact = 255.0 * srgb_encode(std::clamp(double(linear), 0.0, 1.0));
    return std::abs(double(code) - exact);
}

/// Sums over the channels of a row's texels.
struct RowSum {
    double largest = 0.0, squares = 0.0, texels = 0.0;
};

RowSum compare_row(std::span<const Span> spans, std::span<const Rgb8> texels,
                   std::span<const RgbF> exact, std::span<float> codes) {
    RowSum sum;
    for (const Span& span : spans)
        for (std::uint32_t x = span.x; x < span.x + span.count; ++x) {
            const std::array<double, 3> off{difference(texels[x].r, exact[x].r),
                                            difference(texels[x].g, exact[x].g),
                                            difference(texels[x].b, exact[x].b)};
            const double most = std::ranges::max(off);
            codes[x] = float(most);
            sum.largest = std::max(sum.largest, most);
            for (const double d : off) sum.squares += d * d;
            sum.texels += 1.0;
        }
    return sum;
}

Image<float> largest_of(const Image<float>& finer) {
    const auto halved = [](std::size_t side) { return std::max<std::size_t>(1, side / 2); };
    Image<float> coarser(halved(finer.width()), halved(finer.height()), -1.0f);
    for (std::size_t y = 0; y < finer.height(); ++y)
        for (std::size_t x = 0; x < finer.width(); ++x) {
            float& texel = coarser(std::min(x / 2, coarser.width() - 1),
                                   std::min(y / 2, coarser.height() - 1));
            texel = std::max(texel, finer(x, y));
        }
    return coarser;
}

Image<Rgb8> colored(const Image<float>& codes, double scale) {
    Image<Rgb8> picture(codes.width(), codes.height());
    const Rgb8 empty = encoded(gap_color);
    for (std::size_t y = 0; y < codes.height(); ++y)
        for (std::size_t x = 0; x < codes.width(); ++x)
            picture(x, y) = codes(x, y) < 0.0f ? empty : false_color(double(codes(x, y)) / scale);
    return picture;
}

}  // namespace

std::string no_reference(const Recipe& recipe, const Box3& box) {
    const std::string mask = first_mask_node(recipe.texture, GraphOutput::color);
    if (!mask.empty()) return "texture: " + no_texels_for(mask);
    try {
        check_lattice(recipe, mapped(texture_from_solid(recipe), box));
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

std::optional<TextureError> texture_error(const SolidAtlas& solid, const Recipe& recipe,
                                          const Image<Rgb8>& texels, const std::stop_token& stop) {
    Recipe reference = recipe;
    reference.precision.kind = PrecisionKind::float64;
    auto exact = fill_unpainted<RgbF>(solid, reference, HostWay{}, {{}, nullptr, stop});
    if (stop.stop_requested()) return {};
    paint_over(solid, recipe.paint, 0, exact);
    TextureError error{Image<float>(solid.size, solid.size, -1.0f)};
    std::vector<RowSum> rows(solid.size);
    for_row_ranges(
        solid.size, error_texels_per_task, 0,
        [&](const RowRange& range) {
            for (std::size_t y = range.begin(); y != range.end(); ++y)
                rows[y] =
                    compare_row(solid.row(y), texels.row(y), exact.row(y), error.codes.row(y));
        },
        stop);
    if (stop.stop_requested()) return {};
    RowSum all;
    for (const RowSum& row : rows) {
        all.largest = std::max(all.largest, row.largest);
        all.squares += row.squares;
        all.texels += row.texels;
    }
    error.largest = all.largest;
    error.rms = all.texels > 0.0 ? std::sqrt(all.squares / (3.0 * all.texels)) : 0.0;
    return error;
}

double error_scale(double largest) {
    double scale = 2.0;
    while (scale < largest && scale < 256.0) scale *= 2.0;
    return scale;
}

std::vector<Image<Rgb8>> error_levels(const TextureError& error) {
    const double scale = error_scale(error.largest);
    std::vector<Image<Rgb8>> levels;
    for (Image<float> codes = error.codes;; codes = largest_of(codes)) {
        levels.push_back(colored(codes, scale));
        if (codes.width() <= 1 && codes.height() <= 1) return levels;
    }
}

}  // namespace burl
