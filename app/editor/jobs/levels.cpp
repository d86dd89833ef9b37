#include "app/editor/jobs/levels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "procedural/batch/row_tasks.h"
#include "procedural/color/srgb.h"

namespace burl {

namespace {

constexpr std::size_t texels_per_task = 1 << 15;

std::uint8_t mean_code(std::uint8_t a, std::uint8_t b, std::uint8_t c, std::uint8_t d) {
    return std::uint8_t((a + b + c + d + 2) / 4);
}

void widen(std::span<const Rgb8> from, std::span<Rgba8> to) {
    for (std::size_t x = 0; x < from.size(); ++x) to[x] = {from[x].r, from[x].g, from[x].b, 255};
}

}  // namespace

EditLevels::EditLevels() : codes_((1 << 16) + 1) {
    const SrgbEncoder<std::uint8_t> encode;
    for (std::size_t code = 0; code < linear_.size(); ++code)
        linear_[code] = std::uint32_t(std::lround(one * srgb_decode(double(code) / 255.0)));
    for (std::size_t i = 0; i < codes_.size(); ++i)
        codes_[i] = encode((double(i) + 0.5) / double(codes_.size() - 1));
}

void EditLevels::halve_row(const Image<Rgba8>& fine, std::size_t y, bool is_color,
                           std::span<Rgba8> row) const {
    const std::span<const Rgba8> low = fine.row(std::min(2 * y, fine.height() - 1)),
                                 high = fine.row(std::min(2 * y + 1, fine.height() - 1));
    for (std::size_t x = 0; x < row.size(); ++x) {
        const std::size_t left = std::min(2 * x, low.size() - 1),
                          right = std::min(2 * x + 1, low.size() - 1);
        const Rgba8 &a = low[left], &b = low[right], &c = high[left], &d = high[right];
        const std::uint8_t alpha = mean_code(a.a, b.a, c.a, d.a);
        if (is_color)
            row[x] = {mean(a.r, b.r, c.r, d.r), mean(a.g, b.g, c.g, d.g), mean(a.b, b.b, c.b, d.b),
                      alpha};
        else
            row[x] = {mean_code(a.r, b.r, c.r, d.r), mean_code(a.g, b.g, c.g, d.g),
                      mean_code(a.b, b.b, c.b, d.b), alpha};
    }
}

Image<Rgba8> EditLevels::halved(const Image<Rgba8>& fine, bool is_color) const {
    auto coarse = Image<Rgba8>::unset(std::max<std::size_t>(fine.width() / 2, 1),
                                      std::max<std::size_t>(fine.height() / 2, 1));
    for_row_ranges(coarse.height(), texels_per_task, 0, [&](const RowRange& rows) {
        for (std::size_t y = rows.begin(); y != rows.end(); ++y)
            halve_row(fine, y, is_color, coarse.row(y));
    });
    return coarse;
}

std::vector<Image<Rgba8>> EditLevels::operator()(const Image<Rgb8>& texels) const {
    auto finest = Image<Rgba8>::unset(texels.width(), texels.height());
    for_row_ranges(texels.height(), texels_per_task, 0, [&](const RowRange& rows) {
        for (std::size_t y = rows.begin(); y != rows.end(); ++y)
            widen(texels.row(y), finest.row(y));
    });
    return (*this)(std::move(finest), true);
}

std::vector<Image<Rgba8>> EditLevels::operator()(Image<Rgba8> texels, bool is_color) const {
    std::vector<Image<Rgba8>> levels;
    levels.push_back(std::move(texels));
    const Image<Rgba8>& finest = levels.front();
    if (!std::has_single_bit(finest.width()) || !std::has_single_bit(finest.height()))
        return levels;
    while (levels.back().width() > 1 || levels.back().height() > 1)
        levels.push_back(halved(levels.back(), is_color));
    return levels;
}

}  // namespace burl
