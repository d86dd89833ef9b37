#pragma once
// Scan conversion of a triangle or convex polygon in texel coordinates: the extent of its slice
// around a texel row. Edges are cut from the same end whichever triangle asks, so neighbours get
// the same numbers and leave neither gap nor overlap.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "atlas/base/vec.h"

namespace burl {

/// The numbers from `low` to `high`; empty at first.
struct Interval {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    void add(double x) {
        low = std::min(low, x);
        high = std::max(high, x);
    }
    bool empty() const { return low > high; }
};

/// Extent in x of the part of the triangle, or convex polygon, with low <= y <= high (of the cut
/// line where low == high); empty when there is none.
template <std::size_t N>
Interval slice(const std::array<Vec2d, N>& corners, double low, double high) {
    Interval x;
    for (std::size_t k = 0; k < N; ++k) {
        Vec2d a = corners[k], b = corners[(k + 1) % N];
        if (a.y > b.y || (a.y == b.y && a.x > b.x)) std::swap(a, b);
        if (a.y >= low && a.y <= high) x.add(a.x);
        if (b.y >= low && b.y <= high) x.add(b.x);
        for (const double y : {low, high})
            if (a.y < y && y < b.y) x.add(a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)));
    }
    return x;
}

/// Calls visit(row, slice of the triangle, or convex polygon, within `reach` of the row's centre
/// line) for every row of a texture `size` texels high that it comes that near to.
template <std::size_t N, class Visit>
void visit_slices(const std::array<Vec2d, N>& corners, std::uint32_t size, double reach,
                  Visit&& visit) {
    Interval y;
    for (const Vec2d& corner : corners) y.add(corner.y);
    if (!(y.high >= -reach) || !(y.low <= size + reach)) return;
    const double first = std::max(0.0, std::ceil(y.low - reach - 0.5));
    const double last = std::min(size - 1.0, std::floor(y.high + reach - 0.5));
    for (double row = first; row <= last; ++row) {
        const Interval x = slice(corners, row + 0.5 - reach, row + 0.5 + reach);
        if (!x.empty()) visit(std::uint32_t(row), x);
    }
}

/// Texels first to first + count - 1 of a row.
struct TexelRun {
    std::uint32_t first = 0, count = 0;
};

/// The texels of a row of `size` whose centres lie within [low, high].
inline TexelRun centres_within(double low, double high, std::uint32_t size) {
    const double first = std::max(0.0, std::ceil(low - 0.5));
    const double last = std::min(size - 1.0, std::floor(high - 0.5));
    if (!(first <= last)) return {};
    return {std::uint32_t(first), std::uint32_t(last - first) + 1};
}

}  // namespace burl
