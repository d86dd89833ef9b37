#include "procedural/color/mip_image.h"

#include <cmath>
#include <span>
#include <utility>

#include "atlas/base/elementary.h"

namespace burl {

namespace {

/// The size from which a coordinate has no useful fraction of a texel.
constexpr double farthest = 0x1p40;

float mean(float a, float b, float c, float d) {
    return 0.25f * (a + b + c + d);
}
RgbF mean(const RgbF& a, const RgbF& b, const RgbF& c, const RgbF& d) {
    return {mean(a.r, b.r, c.r, d.r), mean(a.g, b.g, c.g, d.g), mean(a.b, b.b, c.b, d.b)};
}

/// The means of 2 x 2 texels of a level whose rows are row(y), or of two where one side is 1
/// already.
template <class Texel, class Row>
Image<Texel> halved(std::size_t width, std::size_t height, const Row& row) {
    const std::size_t dx = width > 1, dy = height > 1;
    auto result = Image<Texel>::unset(width >> dx, height >> dy);
    std::vector<Texel> upper(width);
    for (std::size_t y = 0; y < result.height(); ++y) {
        std::ranges::copy(row(y << dy), upper.begin());
        const std::span<const Texel> lower = row((y << dy) + dy);
        for (std::size_t x = 0; x < result.width(); ++x) {
            const std::size_t i = x << dx;
            result(x, y) = mean(upper[i], upper[i + dx], lower[i], lower[i + dx]);
        }
    }
    return result;
}

/// The levels above `finest`, or above the image's own codes where that is empty; `keep` takes
/// them.
template <class Texel, class Keep>
void make_levels(const ImageCodes& codes, const Image<Texel>& finest, const Keep& keep) {
    ImageRows<Texel> rows(codes);
    const Image<Texel>* last = &finest;
    std::size_t width = codes.width(), height = codes.height();
    while (width > 1 || height > 1) {
        last = &keep(halved<Texel>(width, height, [&](std::size_t y) {
            return last->width() > 0 ? last->row(y) : std::span<const Texel>(rows(y));
        }));
        width = last->width(), height = last->height();
    }
}

template <class Texel>
Image<Texel> all_rows(const ImageCodes& codes) {
    ImageRows<Texel> rows(codes);
    auto image = Image<Texel>::unset(codes.width(), codes.height());
    for (std::size_t y = 0; y < image.height(); ++y)
        std::ranges::copy(rows(y), image.row(y).begin());
    return image;
}

/// The blend (1 - w) a + w b.
ImageSample blend(const ImageSample& a, const ImageSample& b, double w) {
    return {(1.0 - w) * a.color + w * b.color, (1.0 - w) * a.by_s + w * b.by_s,
            (1.0 - w) * a.by_t + w * b.by_t};
}

}  // namespace

MipImage::MipImage(Image<Rgb8> image, ImageWrap wrap, std::size_t most_kept)
    : MipImage(std::make_shared<const ImageCodes>(std::move(image), wrap), wrap, most_kept, false) {
}

MipImage::MipImage(Image<Rgba8> image, ImageWrap wrap, std::size_t most_kept)
    : MipImage(std::make_shared<const ImageCodes>(std::move(image), wrap), wrap, most_kept, false) {
}

MipImage::MipImage(std::shared_ptr<const ImageCodes> codes, ImageWrap wrap, std::size_t most_kept,
                   bool of_alpha)
    : codes_(std::move(codes)), wrap_(wrap), of_alpha_(of_alpha) {
    if (codes_->is_resampled() && codes_->width() * codes_->height() <= most_kept) {
        if (of_alpha_)
            finest_.alphas = all_rows<float>(*codes_);
        else
            finest_.colors = all_rows<RgbF>(*codes_);
    }
    if (!of_alpha_ && !codes_->is_opaque())
        alpha_.reset(new MipImage(codes_, wrap, most_kept, true));
}

void MipImage::make_coarser() const {
    std::vector<Texels> levels;
    levels.reserve(level_count());
    if (of_alpha_)
        make_levels<float>(*codes_, finest_.alphas, [&](Image<float> image) -> Image<float>& {
            return levels.emplace_back(Texels{{}, std::move(image)}).alphas;
        });
    else
        make_levels<RgbF>(*codes_, finest_.colors, [&](Image<RgbF> image) -> Image<RgbF>& {
            return levels.emplace_back(Texels{std::move(image), {}}).colors;
        });
    coarser_->levels = std::move(levels);
}

const MipImage::Texels& MipImage::level_texels(std::size_t level) const {
    if (level == 0) return finest_;
    std::call_once(coarser_->made, [this] { make_coarser(); });
    return coarser_->levels[level - 1];
}

Vec3d MipImage::wrapped_texel(const Level& level, double x, double y) const {
    const std::ptrdiff_t i = wrapped_index(x, level.width, wrap_),
                         j = wrapped_index(y, level.height, wrap_);
    if (i < 0 || j < 0) return Vec3d(0.0);
    const RgbF c = texel_of(level.texels, std::size_t(i), std::size_t(j));
    return {c.r, c.g, c.b};
}

ImageSample MipImage::bilinear(std::size_t number, double s, double t) const {
    const Level level = level_of(number);
    if (!(std::abs(s) < farthest && std::abs(t) < farthest))
        return {wrapped_texel(level, 0, 0), {}, {}};
    const double columns = double(level.width), rows = double(level.height);
    const double x = s * columns - 0.5, y = t * rows - 0.5;
    const double i = std::floor(x), j = std::floor(y), u = x - i, v = y - j;
    const Vec3d a = wrapped_texel(level, i, j), b = wrapped_texel(level, i + 1, j),
                c = wrapped_texel(level, i, j + 1), d = wrapped_texel(level, i + 1, j + 1);
    const Vec3d low = (1.0 - u) * a + u * b, high = (1.0 - u) * c + u * d;
    return {(1.0 - v) * low + v * high, columns * ((1.0 - v) * (b - a) + v * (d - c)),
            rows * (high - low)};
}

ImageSample MipImage::trilinear(double s, double t, double width) const {
    const double last = double(level_count() - 1);
    const double level = width > 0.0 ? last + binary_log(width) : -1.0;
    if (!(level > 0.0)) return bilinear(0, s, t);
    if (level >= last) return {wrapped_texel(level_of(level_count() - 1), 0, 0), {}, {}};
    const double below = std::floor(level);
    return blend(bilinear(std::size_t(below), s, t), bilinear(std::size_t(below) + 1, s, t),
                 level - below);
}

ImageSample MipImage::ewa(double s, double t, Vec2d first, Vec2d second, double anisotropy) const {
    if (glm::dot(first, first) < glm::dot(second, second)) std::swap(first, second);
    const double longer = glm::length(first);
    double shorter = glm::length(second);
    if (!(longer < farthest)) return {wrapped_texel(level_of(level_count() - 1), 0, 0), {}, {}};
    if (shorter * anisotropy < longer && shorter > 0.0) {
        second *= longer / (shorter * anisotropy);
        shorter = longer / anisotropy;
    }
    if (!(shorter > 0.0)) return trilinear(s, t, longer / anisotropy);
    const double last = double(level_count() - 1);
    const double level = std::max(0.0, last + binary_log(shorter));
    if (level >= last) return {wrapped_texel(level_of(level_count() - 1), 0, 0), {}, {}};
    const double below = std::floor(level);
    return blend(ellipse(std::size_t(below), s, t, first, second),
                 ellipse(std::size_t(below) + 1, s, t, first, second), level - below);
}

ImageSample MipImage::ellipse(std::size_t number, double s, double t, const Vec2d& first,
                              const Vec2d& second) const {
    const Level level = level_of(number);
    if (!(std::abs(s) < farthest && std::abs(t) < farthest))
        return {wrapped_texel(level, 0, 0), {}, {}};
    const Vec2d size(double(level.width), double(level.height));
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
