// Exact dilation: the nearest owned texel of each column first, then the best column of each row
// (Felzenszwalb & Huttenlocher, "Distance Transforms of Sampled Functions", 2012, without the
// envelope: gaps are short).
#include "atlas/measure/texture_values.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include <tbb/parallel_for.h>

namespace burl {

namespace {

constexpr std::uint32_t no_row = std::numeric_limits<std::uint32_t>::max();

constexpr std::int64_t continued_texels = 2;  // largest number of texels that a map is continued by

void fill_row(const SolidAtlas& solid, const SolidColor& f, std::size_t y, TextureValues& texture,
              Image<std::uint32_t>& maps) {
    for (const Span& span : solid.row(y))
        for (std::uint32_t x = span.x; x < span.x + span.count; ++x) {
            texture.values(x, y) = Vec3f(f(solid.maps[span.map](x, std::int64_t(y))));
            texture.owner(x, y) = solid.triangle_of(span.map);
            maps(x, y) = span.map;
        }
}

/// The row, for each texel, of the nearest owned texel of its column, the upper of two; no_row
/// without one.
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

/// Column and row of the owned texel nearest to (x, y); the row is no_row without one.
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

/// The value of an owned texel's map at the texel nearest to `texel` to which the map is continued.
Vec3f continued(const SolidAtlas& solid, const SolidColor& f, std::uint32_t map,
                std::array<std::int64_t, 2> owned, std::array<std::int64_t, 2> texel) {
    for (std::size_t axis : {0u, 1u})
        texel[axis] =
            std::clamp(texel[axis], owned[axis] - continued_texels, owned[axis] + continued_texels);
    return Vec3f(f(solid.maps[map](texel[0], texel[1])));
}

}  // namespace

TextureValues fill_texture(const SolidAtlas& solid, const SolidColor& f, GapFill fill) {
    const std::size_t size = solid.size;
    TextureValues texture{
        Image<Vec3f>(size, size, Vec3f(0.0f)), Image<std::uint32_t>(size, size, no_triangle), {}};
    Image<std::uint32_t> maps(size, size);
    tbb::parallel_for(std::size_t{0}, size,
                      [&](std::size_t y) { fill_row(solid, f, y, texture, maps); });
    texture.shown = texture.owner;
    if (fill == GapFill::black) return texture;
    const Image<std::uint32_t> rows = nearest_rows(texture.owner);
    tbb::parallel_for(std::size_t{0}, size, [&](std::size_t y) {
        for (std::size_t x = 0; x < size; ++x) {
            if (texture.owner(x, y) != no_triangle) continue;
            const auto [column, row] = nearest_owned(rows, x, y);
            if (row == no_row) continue;
            texture.shown(x, y) = texture.owner(column, row);  // owned texels are not written
            texture.values(x, y) = fill == GapFill::nearest
                                       ? texture.values(column, row)
                                       : continued(solid, f, maps(column, row),
                                                   {std::int64_t(column), std::int64_t(row)},
                                                   {std::int64_t(x), std::int64_t(y)});
        }
    });
    return texture;
}

}  // namespace burl
