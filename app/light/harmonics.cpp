// Diffuse light as spherical harmonics of degree 0 to 2.
#include "app/light/harmonics.h"

#include <cmath>
#include <numbers>

#include "app/light/formulas.h"
#include "app/light/prefilter.h"

namespace burl {

namespace {

using std::numbers::pi;

/// The functions that coefficients of PrefilteredLight::diffuse multiply.
std::array<double, 9> basis(const Vec3d& n) {
    return {1.0,
            n.y,
            n.z,
            n.x,
            n.x * n.y,
            n.y * n.z,
            3.0 * n.z * n.z - 1.0,
            n.x * n.z,
            n.x * n.x - n.y * n.y};
}

/// For each function the square of its factor in the orthonormal harmonics, times what a cosine
/// lobe keeps of its degree: pi, 2 pi / 3, pi / 4, over pi.
constexpr std::array<double, 9> factors{1.0 / (4.0 * pi),
                                        2.0 / 3.0 * 3.0 / (4.0 * pi),
                                        2.0 / 3.0 * 3.0 / (4.0 * pi),
                                        2.0 / 3.0 * 3.0 / (4.0 * pi),
                                        0.25 * 15.0 / (4.0 * pi),
                                        0.25 * 15.0 / (4.0 * pi),
                                        0.25 * 5.0 / (16.0 * pi),
                                        0.25 * 15.0 / (4.0 * pi),
                                        0.25 * 15.0 / (16.0 * pi)};

}  // namespace

std::array<Vec3f, 9> diffuse_harmonics(const Environment& environment) {
    const Image<RgbF>& map = environment.radiance;
    const double width = double(map.width()), height = double(map.height());
    std::array<Vec3d, 9> sums{};
    for (std::size_t y = 0; y < map.height(); ++y) {
        // The exact solid angle of a pixel of this row.
        const double solid =
            2.0 * pi / width *
            (std::cos(pi * double(y) / height) - std::cos(pi * (double(y) + 1.0) / height));
        for (std::size_t x = 0; x < map.width(); ++x) {
            const Vec3d light = solid * vec_of(map(x, y));
            const auto values =
                basis(direction_at({(double(x) + 0.5) / width, (double(y) + 0.5) / height}));
            for (std::size_t k = 0; k < 9; ++k) sums[k] += values[k] * light;
        }
    }
    std::array<Vec3f, 9> result;
    for (std::size_t k = 0; k < 9; ++k) result[k] = Vec3f(factors[k] * sums[k]);
    return result;
}

Vec3d diffuse_light(const PrefilteredLight& light, const Vec3d& normal) {
    const auto values = basis(normal);
    Vec3d sum(0.0);
    for (std::size_t k = 0; k < 9; ++k) sum += values[k] * Vec3d(light.diffuse[k]);
    return glm::max(sum, Vec3d(0.0));
}

}  // namespace burl
