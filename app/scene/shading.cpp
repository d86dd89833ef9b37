#include "app/scene/shading.h"

#include <algorithm>
#include <cmath>

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
