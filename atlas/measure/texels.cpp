#include "atlas/measure/texels.h"

#include <algorithm>

#include "atlas/base/image.h"
#include "atlas/solid/texel_rows.h"

namespace burl {

namespace {

constexpr double inset = 1e-6;  // texels

enum Flag : std::uint8_t { readable = 1, covered = 2, inside = 4, overlapped = 8 };

void mark(Image<std::uint8_t>& flags, std::uint32_t row, double low, double high, Flag flag) {
    const TexelRun run = centres_within(low, high, std::uint32_t(flags.width()));
    for (std::uint8_t& texel : flags.row(row).subspan(run.first, run.count)) {
        if (flag == inside && (texel & inside)) texel |= overlapped;
        texel |= flag;
    }
}

bool leaves(const std::array<Vec2d, 3>& corners, double size) {
    return std::any_of(corners.begin(), corners.end(), [&](const Vec2d& c) {
        return !(std::min(c.x, c.y) >= -inset && std::max(c.x, c.y) <= size + inset);
    });
}

void mark_triangle(const std::array<Vec2d, 3>& corners, double reach, Image<std::uint8_t>& flags) {
    const auto size = std::uint32_t(flags.width());
    Interval y;
    for (const Vec2d& corner : corners) y.add(corner.y);
    visit_slices(corners, size, reach - inset, [&](std::uint32_t row, const Interval& x) {
        mark(flags, row, x.low - reach + inset, x.high + reach - inset, readable);
    });
    visit_slices(corners, size, 0.0, [&](std::uint32_t row, const Interval& x) {
        mark(flags, row, x.low, x.high, covered);
        if (y.low + inset < row + 0.5 && row + 0.5 < y.high - inset)
            mark(flags, row, x.low + inset, x.high - inset, inside);
    });
}

}  // namespace

TexelMetrics measure_texels(const Atlas& atlas) {
    TexelMetrics metrics;
    const std::uint32_t size = atlas.options.size;
    const double reach = atlas.options.overscan == Overscan::bilinear ? 1.0 : 0.5;
    Image<std::uint8_t> flags(size, size);
    for (const auto& corners : atlas.corners) {
        metrics.outside += leaves(corners, size) ? 1 : 0;
        mark_triangle(corners, reach, flags);
    }
    for (const std::uint8_t texel : flags.pixels()) {
        metrics.readable += texel & readable ? 1 : 0;
        metrics.covered += texel & covered ? 1 : 0;
        metrics.overlapped += texel & overlapped ? 1 : 0;
    }
    return metrics;
}

}  // namespace burl
