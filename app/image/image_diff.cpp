#include "app/image/image_diff.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "atlas/base/error.h"

namespace burl {

namespace {

constexpr Rgb8 ignored_color{64, 64, 64};

std::array<int, 3> channel_differences(const Rgb8& a, const Rgb8& b) {
    return {std::abs(int(a.r) - int(b.r)), std::abs(int(a.g) - int(b.g)),
            std::abs(int(a.b) - int(b.b))};
}

std::uint8_t mix(std::uint8_t a, std::uint8_t b, double t) {
    return std::uint8_t(std::lround(double(a) + (double(b) - double(a)) * t));
}

}  // namespace

Rgb8 false_color(double position) {
    static constexpr std::array<Rgb8, 5> stops{
        {{0, 0, 0}, {32, 40, 200}, {205, 50, 160}, {255, 165, 40}, {255, 255, 255}}};
    const double scaled = std::clamp(position, 0.0, 1.0) * double(stops.size() - 1);
    const std::size_t stop = std::min(std::size_t(scaled), stops.size() - 2);
    const double t = scaled - double(stop);
    const Rgb8 &low = stops[stop], &high = stops[stop + 1];
    return {mix(low.r, high.r, t), mix(low.g, high.g, t), mix(low.b, high.b, t)};
}

ImageDiff diff_images(const Image<Rgb8>& a, const Image<Rgb8>& b, const DiffOptions& options) {
    if (a.width() != b.width() || a.height() != b.height()) {
        throw Error(ExitCode::invalid_file,
                    fmt::format("the pictures cannot be compared: one is {}x{} pixels, the other "
                                "{}x{}; render both at one --size",
                                a.width(), a.height(), b.width(), b.height()));
    }
    ImageDiff diff;
    diff.false_color = Image<Rgb8>(a.width(), a.height(), ignored_color);
    std::uint64_t square_sum = 0;  // sum over differences of 8-bit codes, which is exact
    int maximum = 0;
    for (std::size_t y = 0; y < a.height(); ++y) {
        for (std::size_t x = 0; x < a.width(); ++x) {
            if (options.ignore && (a(x, y) == *options.ignore || b(x, y) == *options.ignore)) {
                ++diff.ignored;
                continue;
            }
            const auto d = channel_differences(a(x, y), b(x, y));
            const int largest = std::max({d[0], d[1], d[2]});
            for (const int value : d) square_sum += std::uint64_t(value * value);
            maximum = std::max(maximum, largest);
            ++diff.pixels;
            diff.above_tolerance += double(largest) / 255.0 > options.tolerance;
            diff.false_color(x, y) = false_color(double(largest) / 255.0 / options.scale);
        }
    }
    diff.maximum = double(maximum) / 255.0;
    const double channels = 3.0 * double(std::max<std::uint64_t>(diff.pixels, 1));
    const double mean_square = double(square_sum) / (255.0 * 255.0) / channels;
    diff.rmse = std::sqrt(mean_square);
    diff.psnr_db =
        square_sum == 0 ? std::numeric_limits<double>::infinity() : -10.0 * std::log10(mean_square);
    return diff;
}

}  // namespace burl
