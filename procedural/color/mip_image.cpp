#include "procedural/color/mip_image.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

#include "atlas/base/elementary.h"
#include "procedural/color/srgb.h"

namespace burl {

namespace {

/// The size from which a coordinate has no useful fraction of a texel.
constexpr double farthest = 0x1p40;

/// The index of texel x within [0, size), or -1 where the wrap gives black.
std::ptrdiff_t wrapped(double x, std::size_t size, ImageWrap wrap) {
    const double n = double(size);
    if (wrap == ImageWrap::clamp) return std::ptrdiff_t(std::clamp(x, 0.0, n - 1.0));
    if (wrap == ImageWrap::repeat) return std::ptrdiff_t(x - n * std::floor(x / n));
    return x >= 0.0 && x < n ? std::ptrdiff_t(x) : -1;
}

/// Lanczos's filter of two lobes, x in units of its radius.
double lanczos(double x) {
    const double y = std::numbers::pi * std::abs(x);
    if (y >= std::numbers::pi) return 0.0;
    if (y < 1e-5) return 1.0;
    return std::sin(2.0 * y) / (2.0 * y) * std::sin(y) / y;
}

/// The four source texels of a target texel, and their weights, which add up to one.
struct Taps {
    std::array<std::ptrdiff_t, 4> index{};
    std::array<double, 4> weight{};
};

/// The taps that resample a row of `from` texels to `to` texels.
std::vector<Taps> lanczos_taps(std::size_t from, std::size_t to, ImageWrap wrap) {
    std::vector<Taps> all(to);
    for (std::size_t i = 0; i < to; ++i) {
        const double centre = (double(i) + 0.5) * double(from) / double(to);
        const double first = std::floor(centre - 1.5);
        double sum = 0.0;
        for (std::size_t k = 0; k < 4; ++k) {
            const double at = first + double(k);
            all[i].index[k] = wrapped(at, from, wrap);
            all[i].weight[k] = lanczos((at + 0.5 - centre) / 2.0);
            sum += all[i].weight[k];
        }
        for (double& weight : all[i].weight) weight /= sum;
    }
    return all;
}

RgbF mixed(const Taps& taps, const auto& texel_at) {
    std::array<double, 3> sum{};
    for (std::size_t k = 0; k < 4; ++k) {
        if (taps.index[k] < 0) continue;
        const RgbF texel = texel_at(std::size_t(taps.index[k]));
        sum[0] += taps.weight[k] * double(texel.r);
        sum[1] += taps.weight[k] * double(texel.g);
        sum[2] += taps.weight[k] * double(texel.b);
    }
    return {float(std::max(sum[0], 0.0)), float(std::max(sum[1], 0.0)),
            float(std::max(sum[2], 0.0))};
}

/// The rows of an image widened to a power of two, each made when it is asked for; the five that
/// were asked for last are kept, one more than a column's taps need.
template <class TexelAt>
class WideRows {
  public:
    WideRows(std::size_t from, std::size_t width, const TexelAt& texel_at, ImageWrap wrap)
        : texel_at_(texel_at) {
        if (from != width) taps_ = lanczos_taps(from, width, wrap);
        for (Row& row : rows_) row.texels.resize(width);
    }
    /// Row y, which stays until four others have been asked for.
    const std::vector<RgbF>& operator()(std::size_t y) {
        const auto known = std::ranges::find(rows_, std::ptrdiff_t(y), &Row::y);
        Row& row = known != rows_.end() ? *known : rows_.front();
        if (known == rows_.end()) fill(row, y);
        std::rotate(rows_.begin(), rows_.begin() + (&row - rows_.data()) + 1, rows_.end());
        return rows_.back().texels;
    }

  private:
    struct Row {
        std::ptrdiff_t y = -1;
        std::vector<RgbF> texels;
    };
    void fill(Row& row, std::size_t y) const {
        row.y = std::ptrdiff_t(y);
        for (std::size_t x = 0; x < row.texels.size(); ++x)
            row.texels[x] = taps_.empty()
                                ? texel_at_(x, y)
                                : mixed(taps_[x], [&](std::size_t k) { return texel_at_(k, y); });
    }

    const TexelAt& texel_at_;
    std::vector<Taps> taps_;   ///< none where rows have a power of two of texels already
    std::array<Row, 5> rows_;  ///< the one asked for last at the end
};

/// The image of texel_at(x, y) resampled along rows, then along columns; a side that is a power of
/// two stays as it is.
template <class TexelAt>
Image<RgbF> with_power_of_two_sides(std::size_t columns, std::size_t rows, ImageWrap wrap,
                                    const TexelAt& texel_at) {
    const std::size_t width = std::bit_ceil(columns), height = std::bit_ceil(rows);
    WideRows wide(columns, width, texel_at, wrap);
    Image<RgbF> result(width, height);
    if (height == rows) {
        for (std::size_t y = 0; y < height; ++y) std::ranges::copy(wide(y), result.row(y).begin());
        return result;
    }
    const std::vector<Taps> taps = lanczos_taps(rows, height, wrap);
    for (std::size_t y = 0; y < height; ++y) {
        std::array<const RgbF*, 4> four{};
        for (std::size_t k = 0; k < 4; ++k)
            if (taps[y].index[k] >= 0) four[k] = wide(std::size_t(taps[y].index[k])).data();
        Taps column = taps[y];  // of the four rows
        for (std::size_t k = 0; k < 4; ++k) column.index[k] = four[k] ? std::ptrdiff_t(k) : -1;
        for (std::size_t x = 0; x < width; ++x)
            result(x, y) = mixed(column, [&](std::size_t k) { return four[k][x]; });
    }
    return result;
}

/// The means of 2 x 2 texels of a level, or of two where one side is 1 already.
Image<RgbF> halved(const MipImage& image, std::size_t level) {
    const std::size_t dx = image.width(level) > 1, dy = image.height(level) > 1;
    Image<RgbF> result(image.width(level) >> dx, image.height(level) >> dy);
    for (std::size_t y = 0; y < result.height(); ++y)
        for (std::size_t x = 0; x < result.width(); ++x) {
            const std::size_t i = x << dx, j = y << dy;
            const RgbF a = image.texel(level, i, j), b = image.texel(level, i + dx, j),
                       c = image.texel(level, i, j + dy), d = image.texel(level, i + dx, j + dy);
            result(x, y) = {0.25f * (a.r + b.r + c.r + d.r), 0.25f * (a.g + b.g + c.g + d.g),
                            0.25f * (a.b + b.b + c.b + d.b)};
        }
    return result;
}

float alpha_of(const Rgb8&) {
    return 1.0f;
}
float alpha_of(const Rgba8& texel) {
    return float(texel.a) / 255.0f;
}

/// Linear light of the 256 codes of sRGB.
std::array<float, 256> decoded_codes() {
    std::array<float, 256> linear{};
    for (std::size_t code = 0; code < 256; ++code)
        linear[code] = float(srgb_decode(double(code) / 255.0));
    return linear;
}

/// The image in linear light, multiplied by its alpha, with sides that are powers of two.
template <class Pixel>
Image<RgbF> resampled(const Image<Pixel>& image, ImageWrap wrap) {
    const std::array<float, 256> linear = decoded_codes();
    return with_power_of_two_sides(
        image.width(), image.height(), wrap, [&](std::size_t x, std::size_t y) {
            const Pixel c = image(x, y);
            const float alpha = alpha_of(c);
            return RgbF{alpha * linear[c.r], alpha * linear[c.g], alpha * linear[c.b]};
        });
}

/// The alpha of an image as greys, with sides that are powers of two.
Image<RgbF> resampled_alpha(const Image<Rgba8>& image, ImageWrap wrap) {
    return with_power_of_two_sides(image.width(), image.height(), wrap,
                                   [&](std::size_t x, std::size_t y) {
                                       const float alpha = alpha_of(image(x, y));
                                       return RgbF{alpha, alpha, alpha};
                                   });
}

bool has_power_of_two_sides(const auto& image) {
    return std::has_single_bit(image.width()) && std::has_single_bit(image.height());
}

bool has_transparent_texel(const Image<Rgba8>& image) {
    return std::ranges::any_of(image.pixels(), [](const Rgba8& texel) { return texel.a < 255; });
}

/// Takes the image by value, so that its memory ends with it.
Image<Rgb8> without_alpha(Image<Rgba8> image) {
    return converted<Rgb8>(image, [](const Rgba8& c) { return Rgb8{c.r, c.g, c.b}; });
}

/// Cuts the channels at those of `limits`.
void cut_at(const Image<RgbF>& limits, Image<RgbF>& image) {
    for (std::size_t y = 0; y < image.height(); ++y)
        for (std::size_t x = 0; x < image.width(); ++x) {
            RgbF& c = image(x, y);
            const RgbF& m = limits(x, y);
            c = {std::min(c.r, m.r), std::min(c.g, m.g), std::min(c.b, m.b)};
        }
}

/// The blend (1 - w) a + w b.
ImageSample blend(const ImageSample& a, const ImageSample& b, double w) {
    return {(1.0 - w) * a.color + w * b.color, (1.0 - w) * a.by_s + w * b.by_s,
            (1.0 - w) * a.by_t + w * b.by_t};
}

}  // namespace

MipImage::MipImage(Image<Rgb8> image, ImageWrap wrap) : wrap_(wrap) {
    if (has_power_of_two_sides(image)) {
        keep_codes(std::move(image));
    } else {
        levels_.push_back(resampled(image, wrap));
        image = {};
    }
    add_levels();
}

MipImage::MipImage(Image<Rgba8> image, ImageWrap wrap) : wrap_(wrap) {
    if (!has_transparent_texel(image)) {
        *this = MipImage(without_alpha(std::move(image)), wrap);
    } else if (has_power_of_two_sides(image)) {
        alpha_.push_back(
            MipImage(converted<std::uint8_t>(image, [](const Rgba8& c) { return c.a; }), wrap));
        keep_codes(without_alpha(std::move(image)));
        add_levels();
    } else {
        Image<RgbF> alpha = resampled_alpha(image, wrap);
        cut_at(Image<RgbF>(alpha.width(), alpha.height(), {1.0f, 1.0f, 1.0f}), alpha);
        Image<RgbF> colors = resampled(image, wrap);
        image = {};
        cut_at(alpha, colors);
        *this = MipImage(std::move(colors), wrap);
        alpha_.push_back(MipImage(std::move(alpha), wrap));
    }
}

MipImage::MipImage(Image<std::uint8_t> alphas, ImageWrap wrap)
    : wrap_(wrap), alphas_(std::move(alphas)) {
    for (std::size_t code = 0; code < 256; ++code) decoded_[code] = float(code) / 255.0f;
    levels_.emplace_back();
    add_levels();
}

void MipImage::keep_codes(Image<Rgb8> image) {
    codes_ = std::move(image);
    decoded_ = decoded_codes();
    levels_.emplace_back();
}

MipImage::MipImage(Image<RgbF> finest, ImageWrap wrap) : wrap_(wrap) {
    levels_.push_back(std::move(finest));
    add_levels();
}

void MipImage::add_levels() {
    while (width(level_count() - 1) > 1 || height(level_count() - 1) > 1)
        levels_.push_back(halved(*this, level_count() - 1));
}

Vec3d MipImage::wrapped_texel(std::size_t level, double x, double y) const {
    const std::ptrdiff_t i = wrapped(x, width(level), wrap_), j = wrapped(y, height(level), wrap_);
    if (i < 0 || j < 0) return Vec3d(0.0);
    const RgbF c = texel(level, std::size_t(i), std::size_t(j));
    return {c.r, c.g, c.b};
}

ImageSample MipImage::bilinear(std::size_t level, double s, double t) const {
    if (!(std::abs(s) < farthest && std::abs(t) < farthest))
        return {wrapped_texel(level, 0, 0), {}, {}};
    const double columns = double(width(level)), rows = double(height(level));
    const double x = s * columns - 0.5, y = t * rows - 0.5;
    const double i = std::floor(x), j = std::floor(y), u = x - i, v = y - j;
    const Vec3d a = wrapped_texel(level, i, j), b = wrapped_texel(level, i + 1, j),
                c = wrapped_texel(level, i, j + 1), d = wrapped_texel(level, i + 1, j + 1);
    const Vec3d low = (1.0 - u) * a + u * b, high = (1.0 - u) * c + u * d;
    return {(1.0 - v) * low + v * high, columns * ((1.0 - v) * (b - a) + v * (d - c)),
            rows * (high - low)};
}

ImageSample MipImage::trilinear(double s, double t, double width) const {
    const double last = double(levels_.size() - 1);
    const double level = width > 0.0 ? last + binary_log(width) : -1.0;
    if (!(level > 0.0)) return bilinear(0, s, t);
    if (level >= last) return {wrapped_texel(levels_.size() - 1, 0, 0), {}, {}};
    const double below = std::floor(level);
    return blend(bilinear(std::size_t(below), s, t), bilinear(std::size_t(below) + 1, s, t),
                 level - below);
}

ImageSample MipImage::ewa(double s, double t, Vec2d first, Vec2d second, double anisotropy) const {
    if (glm::dot(first, first) < glm::dot(second, second)) std::swap(first, second);
    const double longer = glm::length(first);
    double shorter = glm::length(second);
    if (!(longer < farthest)) return {wrapped_texel(levels_.size() - 1, 0, 0), {}, {}};
    if (shorter * anisotropy < longer && shorter > 0.0) {
        second *= longer / (shorter * anisotropy);
        shorter = longer / anisotropy;
    }
    if (!(shorter > 0.0)) return trilinear(s, t, longer / anisotropy);
    const double last = double(levels_.size() - 1);
    const double level = std::max(0.0, last + binary_log(shorter));
    if (level >= last) return {wrapped_texel(levels_.size() - 1, 0, 0), {}, {}};
    const double below = std::floor(level);
    return blend(ellipse(std::size_t(below), s, t, first, second),
                 ellipse(std::size_t(below) + 1, s, t, first, second), level - below);
}

ImageSample MipImage::ellipse(std::size_t level, double s, double t, const Vec2d& first,
                              const Vec2d& second) const {
    if (!(std::abs(s) < farthest && std::abs(t) < farthest))
        return {wrapped_texel(level, 0, 0), {}, {}};
    const Vec2d size(double(width(level)), double(height(level)));
    const double x = s * size.x - 0.5, y = t * size.y - 0.5;
    const Vec2d p = first * size, q = second * size;
    // r^2 = a dx^2 + b dx dy + c dy^2, which is 1 on the ellipse of the two steps, one texel wider.
    double a = p.y * p.y + q.y * q.y + 1.0, b = -2.0 * (p.x * p.y + q.x * q.y),
           c = p.x * p.x + q.x * q.x + 1.0;
    const double scale = 1.0 / (a * c - 0.25 * b * b);
    a *= scale, b *= scale, c *= scale;
    const double determinant = 4.0 * a * c - b * b;
    const double reach_x = 2.0 * std::sqrt(c / determinant),
                 reach_y = 2.0 * std::sqrt(a / determinant);
    ImageSample sum;
    double weights = 0.0, weights_by_x = 0.0, weights_by_y = 0.0;
    constexpr double falloff = -2.8853900817779268;  // -2 / ln 2
    const double end = binary_power(falloff);
    for (double j = std::ceil(y - reach_y); j <= y + reach_y; ++j)
        for (double i = std::ceil(x - reach_x); i <= x + reach_x; ++i) {
            const double dx = i - x, dy = j - y;
            const double r2 = a * dx * dx + b * dx * dy + c * dy * dy;
            if (r2 >= 1.0) continue;
            const double gauss = binary_power(falloff * r2), weight = gauss - end;
            const double by_x = 2.0 * gauss * (2.0 * a * dx + b * dy),
                         by_y = 2.0 * gauss * (b * dx + 2.0 * c * dy);
            const Vec3d color = wrapped_texel(level, i, j);
            sum.color += weight * color;
            sum.by_s += by_x * color;
            sum.by_t += by_y * color;
            weights += weight;
            weights_by_x += by_x;
            weights_by_y += by_y;
        }
    const Vec3d mean = sum.color / weights;
    return {mean, size.x * (sum.by_s - weights_by_x * mean) / weights,
            size.y * (sum.by_t - weights_by_y * mean) / weights};
}

}  // namespace burl
