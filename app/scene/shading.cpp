#include "app/scene/shading.h"

#include <algorithm>
#include <cmath>

#include "app/light/tone.h"

namespace burl {

Vec3d background_linear() {
    return linear_light(background_srgb);
}

double headlight(const Vec3d& normal, const Vec3d& to_eye) {
    return headlight(normal, normal, to_eye);
}

double headlight(const Vec3d& normal, const Vec3d& bumped, const Vec3d& to_eye) {
    const double lengths = glm::length(bumped) * glm::length(to_eye);
    const double towards = glm::dot(normal, to_eye) < 0.0 ? -1.0 : 1.0;
    const double cosine = lengths > 0.0 ? towards * glm::dot(bumped, to_eye) / lengths : 1.0;
    return ambient + (1.0 - ambient) * std::clamp(cosine, 0.0, 1.0);
}

namespace {

/// The mean of n x n samples with their corner at (x, y).
Vec4d mean_of(const Image<RgbaF>& samples, std::size_t n, std::size_t x, std::size_t y) {
    Vec4d sum(0.0);
    for (std::size_t j = 0; j < n; ++j)
        for (const RgbaF& c : samples.row(y + j).subspan(x, n))
            sum += Vec4d(double(c.r), double(c.g), double(c.b), double(c.a));
    return sum * (1.0 / double(n * n));
}

/// A pixel's light as a picture shows it.
class Development {
  public:
    Development(const PictureOptions& options, const SrgbEncoder<std::uint8_t>& encode)
        : light_(options.light),
          lit_(options.lit),
          transparent_(options.background.kind == Background::Kind::transparent),
          background_(linear_light(options.background.color)),
          encode_(encode) {}

    /// The codes of linear light premultiplied by alpha.
    Rgba8 operator()(const Vec4d& mean) const {
        const double alpha = mean.w;
        Vec3d color = Vec3d(mean);
        if (lit_ && alpha > 0.0) color = alpha * developed(color / alpha, light_);
        if (!transparent_) return coded(color + (1.0 - alpha) * background_, 1.0);
        return coded(alpha > 0.0 ? color / alpha : color, alpha);
    }

  private:
    Rgba8 coded(const Vec3d& c, double alpha) const {
        return {encode_(c.x), encode_(c.y), encode_(c.z),
                std::uint8_t(std::lround(255.0 * std::clamp(alpha, 0.0, 1.0)))};
    }

    const LightOptions& light_;
    bool lit_, transparent_;
    Vec3d background_;
    const SrgbEncoder<std::uint8_t>& encode_;
};

}  // namespace

void resolve_samples(const Image<RgbaF>& samples, const PictureOptions& options,
                     const SrgbEncoder<std::uint8_t>& encode, Image<Rgba8>& picture, std::size_t x0,
                     std::size_t y0) {
    const auto n = std::size_t(options.supersample);
    const Development develop(options, encode);
    for (std::size_t y = 0; y < samples.height() / n; ++y)
        for (std::size_t x = 0; x < samples.width() / n; ++x)
            picture(x0 + x, y0 + y) = develop(mean_of(samples, n, n * x, n * y));
}

void resolve_samples(const Image<RgbF>& samples, int supersample,
                     const SrgbEncoder<std::uint8_t>& encode, Image<Rgb8>& picture, std::size_t x0,
                     std::size_t y0) {
    const auto n = std::size_t(supersample);
    const double weight = 1.0 / double(n * n);
    for (std::size_t y = 0; y < samples.height() / n; ++y) {
        for (std::size_t x = 0; x < samples.width() / n; ++x) {
            Vec3d mean(0.0);
            for (std::size_t j = 0; j < n; ++j) {
                for (const RgbF& c : samples.row(y * n + j).subspan(x * n, n)) {
                    mean += Vec3d(double(c.r), double(c.g), double(c.b));
                }
            }
            mean *= weight;
            picture(x0 + x, y0 + y) = {encode(mean.x), encode(mean.y), encode(mean.z)};
        }
    }
}

}  // namespace burl
