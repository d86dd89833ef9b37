// The weights are separable: columns of three texels are added up first, then rows of three
// columns.
#include "atlas/base/sharp_level.h"

#include <algorithm>
#include <span>
#include <vector>

#include <tbb/parallel_for.h>

namespace burl {

namespace {

constexpr std::size_t band_rows = 64;

Vec4d sums_of(float value) {
    return {double(value), 0.0, 0.0, 0.0};
}
Vec4d sums_of(const Vec3f& value) {
    return {Vec3d(value), 0.0};
}
Vec4d sums_of(const RgbF& value) {
    return {double(value.r), double(value.g), double(value.b), 0.0};
}
Vec4d sums_of(const RgbaF& value) {
    return {double(value.r), double(value.g), double(value.b), double(value.a)};
}

float limited(double sum, float mean) {
    return float(std::clamp(sum, 0.0, std::max(1.0, double(mean))));
}
void set(const Vec4d& sum, float& value) {
    value = limited(sum.x, value);
}
void set(const Vec4d& sum, Vec3f& value) {
    value = {limited(sum.x, value.x), limited(sum.y, value.y), limited(sum.z, value.z)};
}
void set(const Vec4d& sum, RgbF& value) {
    value = {limited(sum.x, value.r), limited(sum.y, value.g), limited(sum.z, value.b)};
}
void set(const Vec4d& sum, RgbaF& value) {
    const float alpha = limited(sum.w, value.a);
    const auto below_alpha = [&](double color, float mean) {
        return std::min(limited(color, mean), std::max(alpha, mean > value.a ? mean : 0.0f));
    };
    value = {below_alpha(sum.x, value.r), below_alpha(sum.y, value.g), below_alpha(sum.z, value.b),
             alpha};
}

Vec4d weighted(const Vec4d& before, const Vec4d& at, const Vec4d& after) {
    return (1.0 + 2.0 * sharpness) * at - sharpness * (before + after);
}

/// Sharpens a row in place, which has not changed yet; `above` and `below` are the means beside it.
template <class T>
void sharpen_row(std::span<const T> above, std::span<T> row, std::span<const T> below,
                 std::vector<Vec4d>& columns) {
    const std::size_t width = row.size();
    for (std::size_t x = 0; x < width; ++x)
        columns[x] = weighted(sums_of(above[x]), sums_of(row[x]), sums_of(below[x]));
    for (std::size_t x = 0; x < width; ++x)
        set(weighted(columns[std::max<std::size_t>(x, 1) - 1], columns[x],
                     columns[std::min(x + 1, width - 1)]),
            row[x]);
}

/// A band of rows, and the means of the rows above and below it.
template <class T>
struct Band {
    std::size_t begin, end;
    std::vector<T> above, below;
};

template <class T>
void sharpen_band(Image<T>& level, Band<T>& band) {
    std::vector<T> last = std::move(band.above), means(level.width());
    std::vector<Vec4d> columns(level.width());
    for (std::size_t y = band.begin; y < band.end; ++y) {
        std::ranges::copy(level.row(y), means.begin());
        const std::span<const T> below =
            y + 1 < band.end ? level.row(y + 1) : std::span<const T>(band.below);
        sharpen_row<T>(last, level.row(y), below, columns);
        std::swap(last, means);
    }
}

template <class T>
void sharpen_in_bands(Image<T>& level) {
    const auto means_of = [&](std::size_t y) {
        return std::vector<T>(level.row(y).begin(), level.row(y).end());
    };
    std::vector<Band<T>> bands;
    for (std::size_t begin = 0; begin < level.height(); begin += band_rows) {
        const std::size_t end = std::min(begin + band_rows, level.height());
        bands.push_back({begin, end, means_of(std::max<std::size_t>(begin, 1) - 1),
                         means_of(std::min(end, level.height() - 1))});
    }
    tbb::parallel_for(std::size_t{0}, bands.size(),
                      [&](std::size_t i) { sharpen_band(level, bands[i]); });
}

}  // namespace

template <class T>
void sharpen(Image<T>& level) {
    sharpen_in_bands(level);
}

template void sharpen(Image<float>&);
template void sharpen(Image<Vec3f>&);
template void sharpen(Image<RgbF>&);
template void sharpen(Image<RgbaF>&);

}  // namespace burl
