// Dilation is exact: nearest owned texel of each column first, then the best column of each row
// (Felzenszwalb & Huttenlocher, "Distance Transforms of Sampled Functions", 2012, without the
// envelope: gaps are short).
#include "atlas/texture_values.h"

#include <cstdlib>
#include <utility>

#include <tbb/parallel_for.h>

namespace burl {

namespace {

constexpr std::uint32_t no_row = std::numeric_limits<std::uint32_t>::max();

void fill_row(const SolidAtlas& solid, const SolidFunction& f, std::size_t y,
              TextureValues& texture) {
    for (const Span& span : solid.row(y))
        for (std::uint32_t x = span.x; x < span.x + span.count; ++x) {
            texture.values(x, y) = float(f(solid.maps[span.map](x, std::int64_t(y))));
            texture.owner(x, y) = solid.triangle_of(span.map);
        }
}

/// Per texel the row of the nearest owned texel of its column, the upper of two.
Image<std::uint32_t> nearest_rows(const Image<std::uint32_t>& owner) {
    const std::size_t size = owner.width();
    Image<std::uint32_t> nearest(size, size, no_row);
    tbb::parallel_for(std::size_t{0}, size, [&](std::size_t x) {
        std::uint32_t last = no_row;
        for (std::uint32_t y = 0; y < size; ++y) {
            if (owner(x, y) != no_triangle) last = y;
            nearest(x, y) = last;
        }
        last = no_row;
        for (auto y = std::uint32_t(size); y-- > 0;) {
            if (owner(x, y) != no_triangle) last = y;
            if (last == no_row) continue;
            if (nearest(x, y) == no_row || last - y < y - nearest(x, y)) nearest(x, y) = last;
        }
    });
    return nearest;
}

/// The owned texel nearest to (x, y), or no_row in the second.
std::pair<std::size_t, std::uint32_t> nearest_owned(const Image<std::uint32_t>& rows, std::size_t x,
                                                    std::size_t y) {
    std::pair<std::size_t, std::uint32_t> best{x, no_row};
    std::uint64_t distance = std::numeric_limits<std::uint64_t>::max();
    const auto consider = [&](std::size_t column) {
        const std::uint32_t row = rows(column, y);
        if (row == no_row) return;
        const auto dx = std::int64_t(column) - std::int64_t(x),
                   dy = std::int64_t(row) - std::int64_t(y);
        const auto here = std::uint64_t(dx * dx + dy * dy);
        if (here < distance) distance = here, best = {column, row};
    };
    for (std::size_t step = 0; step < rows.width() && step * step < distance; ++step) {
        if (step <= x) consider(x - step);
        if (x + step < rows.width()) consider(x + step);
    }
    return best;
}

}  // namespace

TextureValues fill_texture(const SolidAtlas& solid, const SolidFunction& f) {
    const std::size_t size = solid.size;
    TextureValues texture{
        Image<float>(size, size), Image<std::uint32_t>(size, size, no_triangle), {}};
    tbb::parallel_for(std::size_t{0}, size, [&](std::size_t y) { fill_row(solid, f, y, texture); });
    texture.shown = texture.owner;
    const Image<std::uint32_t> rows = nearest_rows(texture.owner);
    tbb::parallel_for(std::size_t{0}, size, [&](std::size_t y) {
        for (std::size_t x = 0; x < size; ++x) {
            if (texture.owner(x, y) != no_triangle) continue;
            const auto [column, row] = nearest_owned(rows, x, y);
            if (row == no_row) continue;
            texture.values(x, y) = texture.values(column, row);  // owned texels are not written
            texture.shown(x, y) = texture.owner(column, row);
        }
    });
    return texture;
}

}  // namespace burl
