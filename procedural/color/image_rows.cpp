#include "procedural/color/image_rows.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>

#include "procedural/color/srgb.h"

namespace burl {

namespace {

/// Lanczos's filter of two lobes, x in units of its radius.
double lanczos(double x) {
    const double y = std::numbers::pi * std::abs(x);
    if (y >= std::numbers::pi) return 0.0;
    if (y < 1e-5) return 1.0;
    return std::sin(2.0 * y) / (2.0 * y) * std::sin(y) / y;
}

/// The taps that resample a row of `from` texels to `to` texels; none where these are as many.
std::vector<LanczosTaps> lanczos_taps(std::size_t from, std::size_t to, ImageWrap wrap) {
    if (from == to) return {};
    std::vector<LanczosTaps> all(to);
    for (std::size_t i = 0; i < to; ++i) {
        const double centre = (double(i) + 0.5) * double(from) / double(to);
        const double first = std::floor(centre - 1.5);
        double sum = 0.0;
        for (std::size_t k = 0; k < 4; ++k) {
            const double at = first + double(k);
            all[i].index[k] = wrapped_index(at, from, wrap);
            all[i].weight[k] = lanczos((at + 0.5 - centre) / 2.0);
            sum += all[i].weight[k];
        }
        for (double& weight : all[i].weight) weight /= sum;
    }
    return all;
}

void add(double weight, float texel, double& sum) {
    sum += weight * double(texel);
}
void add(double weight, const RgbF& texel, Rgb<double>& sum) {
    add(weight, texel.r, sum.r);
    add(weight, texel.g, sum.g);
    add(weight, texel.b, sum.b);
}
float not_below_0(double sum) {
    return float(std::max(sum, 0.0));
}
RgbF not_below_0(const Rgb<double>& sum) {
    return {not_below_0(sum.r), not_below_0(sum.g), not_below_0(sum.b)};
}

/// The weighted sum of four texels, which texel_at(index) returns; below 0 it is 0.
template <class TexelAt>
auto mixed(const LanczosTaps& taps, const TexelAt& texel_at) {
    std::conditional_t<std::is_same_v<decltype(texel_at(0)), float>, double, Rgb<double>> sum{};
    for (std::size_t k = 0; k < 4; ++k)
        if (taps.index[k] >= 0) add(taps.weight[k], texel_at(std::size_t(taps.index[k])), sum);
    return not_below_0(sum);
}

/// The numbers of a row of texels, one after the other.
template <class Texels>
auto channels(Texels& row) {
    using Float = std::conditional_t<std::is_const_v<Texels>, const float, float>;
    return reinterpret_cast<Float*>(row.data());
}

/// Mixes `count` numbers of each of four rows, as mixed() does, in loops without a branch.
void mix_rows(const std::array<double, 4>& weight, const std::array<const float*, 4>& rows,
              std::size_t count, float* to) {
    for (std::size_t i = 0; i < count; ++i) {
        double sum = 0.0;
        for (std::size_t k = 0; k < 4; ++k) sum += weight[k] * double(rows[k][i]);
        to[i] = not_below_0(sum);
    }
}

float cut_at(float limit, float texel) {
    return std::min(texel, limit);
}
RgbF cut_at(float limit, const RgbF& texel) {
    return {std::min(texel.r, limit), std::min(texel.g, limit), std::min(texel.b, limit)};
}

bool has_transparent_texel(const Image<Rgba8>& image) {
    return std::ranges::any_of(image.pixels(), [](const Rgba8& texel) { return texel.a < 255; });
}

}  // namespace

std::ptrdiff_t wrapped_index(double x, std::size_t size, ImageWrap wrap) {
    const double n = double(size);
    if (wrap == ImageWrap::clamp) return std::ptrdiff_t(std::clamp(x, 0.0, n - 1.0));
    if (wrap == ImageWrap::repeat) return std::ptrdiff_t(x - n * std::floor(x / n));
    return x >= 0.0 && x < n ? std::ptrdiff_t(x) : -1;
}

ImageCodes::ImageCodes(Image<Rgb8> image, ImageWrap wrap) : opaque_(std::move(image)) {
    set_sides(opaque_.width(), opaque_.height(), wrap);
}

ImageCodes::ImageCodes(Image<Rgba8> image, ImageWrap wrap) {
    if (has_transparent_texel(image))
        transparent_ = std::move(image);
    else
        opaque_ = converted<Rgb8>(image, [](const Rgba8& c) { return Rgb8{c.r, c.g, c.b}; });
    set_sides(std::max(opaque_.width(), transparent_.width()),
              std::max(opaque_.height(), transparent_.height()), wrap);
}

void ImageCodes::set_sides(std::size_t columns, std::size_t rows, ImageWrap wrap) {
    for (std::size_t code = 0; code < 256; ++code)
        linear_[code] = float(srgb_decode(double(code) / 255.0));
    width_ = std::bit_ceil(columns);
    height_ = std::bit_ceil(rows);
    columns_ = lanczos_taps(columns, width_, wrap);
    rows_ = lanczos_taps(rows, height_, wrap);
}

template <class Texel>
Texel ImageCodes::decoded(const Rgb8& c) const {
    if constexpr (std::is_same_v<Texel, float>)
        return 1.0f;
    else
        return {linear_[c.r], linear_[c.g], linear_[c.b]};
}

template <class Texel>
Texel ImageCodes::decoded(const Rgba8& c) const {
    const float alpha = float(c.a) / 255.0f;
    if constexpr (std::is_same_v<Texel, float>)
        return alpha;
    else
        return {alpha * linear_[c.r], alpha * linear_[c.g], alpha * linear_[c.b]};
}

template <class Texel>
Texel ImageCodes::decoded(std::size_t x, std::size_t y) const {
    return is_opaque() ? decoded<Texel>(opaque_(x, y)) : decoded<Texel>(transparent_(x, y));
}

template RgbF ImageCodes::decoded<RgbF>(std::size_t, std::size_t) const;
template float ImageCodes::decoded<float>(std::size_t, std::size_t) const;

template <class Texel>
Texel ImageCodes::resampled(std::size_t x, std::size_t y) const {
    const auto wide = [&](std::size_t row) {
        if (columns_.empty()) return decoded<Texel>(x, row);
        return mixed(columns_[x], [&](std::size_t column) { return decoded<Texel>(column, row); });
    };
    const Texel texel = rows_.empty() ? wide(y) : mixed(rows_[y], wide);
    if (std::is_same_v<Texel, float>) return cut_at(1.0f, texel);
    return is_opaque() ? texel : cut_at(resampled<float>(x, y), texel);
}

template RgbF ImageCodes::resampled<RgbF>(std::size_t, std::size_t) const;
template float ImageCodes::resampled<float>(std::size_t, std::size_t) const;

template <class Texel>
ImageRows<Texel>::ImageRows(const ImageCodes& codes)
    : codes_(codes),
      decoded_(std::max(codes.opaque_.width(), codes.transparent_.width())),
      row_(codes.width()),
      black_(codes.width()) {
    for (Row& row : wide_) row.texels.resize(codes.width());
    if (!std::is_same_v<Texel, float> && codes.is_resampled() && !codes.is_opaque())
        limits_ = std::make_unique<ImageRows<float>>(codes);
}

template <class Texel>
void ImageRows<Texel>::fill(Row& row, std::size_t y) {
    row.y = std::ptrdiff_t(y);
    std::vector<Texel>& decoded = codes_.columns_.empty() ? row.texels : decoded_;
    const auto decode = [&](const auto& code) { return codes_.template decoded<Texel>(code); };
    if (codes_.is_opaque())
        std::ranges::transform(codes_.opaque_.row(y), decoded.begin(), decode);
    else
        std::ranges::transform(codes_.transparent_.row(y), decoded.begin(), decode);
    for (std::size_t x = 0; x < codes_.columns_.size(); ++x)
        row.texels[x] = mixed(codes_.columns_[x], [&](std::size_t k) { return decoded[k]; });
}

template <class Texel>
const std::vector<Texel>& ImageRows<Texel>::wide_row(std::size_t y) {
    const auto known = std::ranges::find(wide_, std::ptrdiff_t(y), &Row::y);
    Row& row = known != wide_.end() ? *known : wide_.front();
    if (known == wide_.end()) fill(row, y);
    std::rotate(wide_.begin(), wide_.begin() + (&row - wide_.data()) + 1, wide_.end());
    return wide_.back().texels;
}

template <class Texel>
const std::vector<Texel>& ImageRows<Texel>::operator()(std::size_t y) {
    if (!codes_.is_resampled()) return wide_row(y);
    if (codes_.rows_.empty()) {
        row_ = wide_row(y);
    } else {
        const LanczosTaps& taps = codes_.rows_[y];
        std::array<const float*, 4> four{};
        for (std::size_t k = 0; k < 4; ++k)
            four[k] = channels(taps.index[k] < 0 ? black_ : wide_row(std::size_t(taps.index[k])));
        mix_rows(taps.weight, four, sizeof(Texel) / sizeof(float) * row_.size(), channels(row_));
    }
    if (std::is_same_v<Texel, float>)
        for (Texel& texel : row_) texel = cut_at(1.0f, texel);
    if (limits_)
        std::ranges::transform(
            (*limits_)(y), row_, row_.begin(),
            [](float limit, const Texel& texel) { return cut_at(limit, texel); });
    return row_;
}

template class ImageRows<RgbF>;
template class ImageRows<float>;

}  // namespace burl
