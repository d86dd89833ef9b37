#include "app/light/light_sampler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "app/light/formulas.h"

namespace burl {

namespace {

using std::numbers::pi;

constexpr std::size_t most_rows = 512;

/// Makes running sums of the values and divides them by the last one; even steps where all are 0.
/// Returns the sum.
double running_sums(std::span<double> values) {
    double sum = 0.0;
    for (double& value : values) value = sum += value;
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = sum > 0.0 ? values[i] / sum : double(i + 1) / double(values.size());
    return sum;
}

/// A step of running sums, chosen by a number in [0,1), and the place within it.
struct Chosen {
    std::size_t index;
    double within;
};

Chosen chosen(std::span<const double> sums, double at) {
    const auto found = std::ranges::upper_bound(sums, at);
    const auto index = std::min(std::size_t(found - sums.begin()), sums.size() - 1);
    const double before = index > 0 ? sums[index - 1] : 0.0, step = sums[index] - before;
    return {index, step > 0.0 ? std::clamp((at - before) / step, 0.0, 1.0) : 0.5};
}

/// The luminance of a pixel's part of the map, which is bilinear between the pixels' centres: a
/// pixel beside a sun is not dark.
double mean_luminance(const Image<RgbF>& map, std::size_t x, std::size_t y) {
    const std::size_t width = map.width();
    const std::array columns{(x + width - 1) % width, x, (x + 1) % width};
    const std::array rows{y - std::min<std::size_t>(y, 1), y, std::min(y + 1, map.height() - 1)};
    constexpr std::array shares{0.125, 0.75, 0.125};
    double sum = 0.0;
    for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t i = 0; i < 3; ++i)
            sum += shares[i] * shares[j] * luminance(vec_of(map(columns[i], rows[j])));
    return sum;
}

double step_at(std::span<const double> sums, std::size_t index) {
    return sums[index] - (index > 0 ? sums[index - 1] : 0.0);
}

}  // namespace

LightSampler::LightSampler(Environment environment)
    : environment_(std::move(environment)),
      columns_(environment_.radiance.width()),
      rows_(environment_.radiance.height()) {
    const Image<RgbF>& map = environment_.radiance;
    std::size_t step = 1;
    while (rows_ / step > most_rows) ++step;
    columns_ = (columns_ + step - 1) / step, rows_ = (rows_ + step - 1) / step;
    sums_.assign(columns_ * rows_, 0.0);
    for (std::size_t y = 0; y < map.height(); ++y) {
        const double sine = std::sin(pi * (double(y) + 0.5) / double(map.height()));
        for (std::size_t x = 0; x < map.width(); ++x)
            sums_[y / step * columns_ + x / step] += sine * mean_luminance(map, x, y);
    }
    row_sums_.resize(rows_);
    for (std::size_t y = 0; y < rows_; ++y)
        row_sums_[y] = running_sums(std::span(sums_).subspan(y * columns_, columns_));
    running_sums(row_sums_);
}

double LightSampler::density_at(const Vec2d& uv) const {
    const auto x = std::min(std::size_t(uv.x * double(columns_)), columns_ - 1),
               y = std::min(std::size_t(uv.y * double(rows_)), rows_ - 1);
    const std::span row = std::span(sums_).subspan(y * columns_, columns_);
    const double per_cell = step_at(row_sums_, y) * step_at(row, x);
    const double sine = std::max(std::sin(pi * uv.y), 1e-9);
    return per_cell * double(columns_) * double(rows_) / (2.0 * pi * pi * sine);
}

LightSampler::Seen LightSampler::operator()(const Vec3d& direction) const {
    const Vec2d uv = equirectangular(direction);
    return {light_at(environment_, uv), density_at(uv)};
}

Vec3d LightSampler::sample(const Vec2d& at) const {
    const Chosen row = chosen(row_sums_, at.y);
    const Chosen column = chosen(std::span(sums_).subspan(row.index * columns_, columns_), at.x);
    return direction_at({(double(column.index) + column.within) / double(columns_),
                         (double(row.index) + row.within) / double(rows_)});
}

}  // namespace burl
