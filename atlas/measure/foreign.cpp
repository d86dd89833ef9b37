#include "atlas/measure/foreign.h"

#include <algorithm>
#include <vector>

#include <tbb/parallel_for.h>

#include "atlas/measure/bilinear.h"

namespace burl {

namespace {

Image<std::uint32_t> to_charts(const Image<std::uint32_t>& triangles,
                               std::span<const std::uint32_t> charts) {
    Image<std::uint32_t> result(triangles.width(), triangles.height(), no_triangle);
    for (std::size_t y = 0; y < triangles.height(); ++y)
        for (std::size_t x = 0; x < triangles.width(); ++x)
            if (triangles(x, y) != no_triangle) result(x, y) = charts[triangles(x, y)];
    return result;
}

/// Share of the texels under texel (x, y) of a level `count` texels wide that are not `chart`'s.
double other_share(const Image<std::uint32_t>& owner, std::uint32_t chart, std::size_t x,
                   std::size_t y, std::size_t count) {
    const std::size_t size = owner.width();
    const auto first = [&](std::size_t i) { return i * size / count; };
    const auto end = [&](std::size_t i) { return ((i + 1) * size + count - 1) / count; };
    const std::size_t width = end(x) - first(x), height = end(y) - first(y);
    std::size_t others = width * height;
    for (std::size_t j = first(y); j < end(y); ++j) {
        const auto row = owner.row(j).subspan(first(x), width);
        others -= std::size_t(std::count(row.begin(), row.end(), chart));
    }
    return double(others) / double(width * height);
}

double other_weight(const Image<std::uint32_t>& owner, std::uint32_t chart, const Vec2d& at,
                    std::size_t count) {
    const BilinearTaps t =
        bilinear_taps(at * (double(count) / double(owner.width())), count, count);
    double others = 0.0;
    for (std::size_t j : {0u, 1u})
        for (std::size_t i : {0u, 1u}) {
            const double weight = t.weight_x[i] * t.weight_y[j];
            if (weight > 0.0) others += weight * other_share(owner, chart, t.x[i], t.y[j], count);
        }
    return others;
}

}  // namespace

ForeignShare foreign_share(const Atlas& atlas, const TextureValues& texture,
                           std::span<const std::uint32_t> charts,
                           std::span<const SurfacePoint> points, std::uint32_t level) {
    ForeignShare share;
    if (points.empty()) return share;
    const Image<std::uint32_t> owner = to_charts(texture.owner, charts);
    const Image<std::uint32_t> shown = to_charts(texture.shown, charts);
    const std::size_t count = std::max<std::size_t>(1, owner.width() >> level);
    std::vector<ForeignShare> each(points.size());
    tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
        const Vec2d at = place(atlas, points[i]);
        const std::uint32_t chart = charts[points[i].triangle];
        each[i] = {other_weight(owner, chart, at, count), other_weight(shown, chart, at, count)};
    });
    for (const ForeignShare& one : each) {
        share.foreign += one.foreign / double(points.size());
        share.other_chart += one.other_chart / double(points.size());
    }
    return share;
}

}  // namespace burl
