#include "app/image/palette.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <span>

#include "app/image/image_io.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

struct Color {
    std::array<int, 3> code{};
    std::int64_t pixels = 0;
};

std::vector<Color> histogram(std::span<const Rgb8> pixels) {
    std::map<std::array<int, 3>, std::int64_t> counts;
    for (const Rgb8& p : pixels) ++counts[{p.r, p.g, p.b}];
    std::vector<Color> colors;
    for (const auto& [code, count] : counts) colors.push_back({code, count});
    return colors;
}

std::int64_t pixels_of(std::span<const Color> colors) {
    std::int64_t sum = 0;
    for (const Color& color : colors) sum += color.pixels;
    return sum;
}

/// A box of the colour space with its longest side.
struct Box {
    std::span<Color> colors;
    std::size_t axis = 0;
    int side = 0;
    std::int64_t pixels = 0;

    explicit Box(std::span<Color> inside) : colors(inside), pixels(pixels_of(inside)) {
        for (std::size_t a = 0; a < 3; ++a) {
            const auto [low, high] = std::minmax_element(
                colors.begin(), colors.end(),
                [a](const Color& x, const Color& y) { return x.code[a] < y.code[a]; });
            if (high->code[a] - low->code[a] <= side) continue;
            side = high->code[a] - low->code[a];
            axis = a;
        }
    }
    /// The priority of splitting the box: squared side times pixels.
    double worth() const { return double(side) * double(side) * double(pixels); }
};

/// The index that splits the box's sorted colours into halves of about equal pixel counts, at least
/// one colour in each.
std::size_t median(const Box& box) {
    std::int64_t before = 0;
    for (std::size_t i = 0; i + 1 < box.colors.size(); ++i) {
        before += box.colors[i].pixels;
        if (2 * before >= box.pixels) return i + 1;
    }
    return box.colors.size() - 1;
}

std::vector<Box> median_cut(std::vector<Color>& colors, std::size_t count) {
    std::vector<Box> boxes{Box(colors)};
    while (boxes.size() < count) {
        const auto widest =
            std::max_element(boxes.begin(), boxes.end(),
                             [](const Box& a, const Box& b) { return a.worth() < b.worth(); });
        if (widest->side == 0) break;
        const std::span<Color> all = widest->colors;
        std::sort(all.begin(), all.end(), [axis = widest->axis](const Color& a, const Color& b) {
            return a.code[axis] != b.code[axis] ? a.code[axis] < b.code[axis] : a.code < b.code;
        });
        const std::size_t middle = median(*widest);
        *widest = Box(all.first(middle));
        boxes.emplace_back(all.subspan(middle));
    }
    return boxes;
}

using Mean = std::array<double, 3>;

Mean mean_of(std::span<const Color> colors) {
    Mean mean{};
    for (const Color& color : colors)
        for (std::size_t a = 0; a < 3; ++a) mean[a] += double(color.pixels) * color.code[a];
    const auto pixels = double(pixels_of(colors));
    for (double& x : mean) x /= pixels;
    return mean;
}

double squared_distance(const Mean& mean, const std::array<int, 3>& code) {
    double sum = 0.0;
    for (std::size_t a = 0; a < 3; ++a) sum += (mean[a] - code[a]) * (mean[a] - code[a]);
    return sum;
}

std::size_t nearest(std::span<const Mean> means, const std::array<int, 3>& code) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < means.size(); ++i) {
        const double distance = squared_distance(means[i], code);
        if (distance >= least) continue;
        least = distance;
        best = i;
    }
    return best;
}

/// One step of Lloyd's algorithm: every mean moves to the mean of the colours nearest to it.
void refine(std::vector<Mean>& means, std::span<const Color> colors) {
    std::vector<std::vector<Color>> owned(means.size());
    for (const Color& color : colors) owned[nearest(means, color.code)].push_back(color);
    for (std::size_t i = 0; i < means.size(); ++i)
        if (!owned[i].empty()) means[i] = mean_of(owned[i]);
}

double luminance(const Mean& mean) {
    return 0.2126 * mean[0] + 0.7152 * mean[1] + 0.0722 * mean[2];
}

/// The colours of a palette, before they are rounded, ascending by luminance; reorders `colors`.
std::vector<Mean> palette_means(std::vector<Color>& colors, std::size_t count) {
    std::vector<Mean> means;
    for (const Box& box : median_cut(colors, count)) means.push_back(mean_of(box.colors));
    if (colors.size() > count)
        for (int step = 0; step < 2; ++step) refine(means, colors);
    std::sort(means.begin(), means.end(), [](const Mean& a, const Mean& b) {
        return luminance(a) != luminance(b) ? luminance(a) < luminance(b) : a < b;
    });
    return means;
}

std::vector<Rgb8> rounded_colors(std::span<const Mean> means) {
    std::vector<Rgb8> colors;
    for (const Mean& mean : means) {
        const auto rounded = [&](std::size_t a) { return std::uint8_t(mean[a] + 0.5); };
        colors.push_back({rounded(0), rounded(1), rounded(2)});
    }
    return colors;
}

}  // namespace

std::vector<Rgb8> palette_of(std::span<const Rgb8> pixels, std::size_t count) {
    std::vector<Color> colors = histogram(pixels);
    return rounded_colors(palette_means(colors, count));
}

IndexedImage with_palette(const Image<Rgb8>& image, std::size_t count) {
    std::vector<Color> colors = histogram(image.pixels());
    const std::vector<Mean> means = palette_means(colors, count);
    IndexedImage result{Image<std::uint8_t>(image.width(), image.height()), rounded_colors(means)};
    std::map<std::array<int, 3>, std::uint8_t> index;
    for (const Color& color : colors) index[color.code] = std::uint8_t(nearest(means, color.code));
    for (std::size_t y = 0; y < image.height(); ++y)
        for (std::size_t x = 0; x < image.width(); ++x) {
            const Rgb8& p = image(x, y);
            result.pixels(x, y) = index[{p.r, p.g, p.b}];
        }
    return result;
}

std::vector<std::uint8_t> encode_small_png(const Image<Rgb8>& image, std::size_t limit) {
    if (histogram(image.pixels()).size() > 256) {
        std::vector<std::uint8_t> whole = encode_png(image, 9);
        if (whole.size() <= limit) return whole;
    }
    for (const std::size_t count : {256, 192, 128, 96, 64, 48, 32, 16, 8}) {
        std::vector<std::uint8_t> bytes = encode_png(with_palette(image, count));
        if (bytes.size() <= limit) return bytes;
    }
    throw Error(ExitCode::runtime, fmt::format("a picture of {} x {} does not fit into {} bytes",
                                               image.width(), image.height(), limit));
}

}  // namespace burl
