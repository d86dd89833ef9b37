#include "app/light/reflectance.h"

#include <algorithm>
#include <cmath>

#include "app/light/microfacets.h"

namespace burl {

namespace {

constexpr std::size_t table_side = 64;
constexpr double last_texel = table_side - 1;
constexpr std::uint32_t table_points = 256;  ///< of the sum over visible microfacets
constexpr int circles = 16, spokes = 12;     ///< of the sum over sheen's directions

/// Scale and bias of F0: the mean over visible microfacets of what later ones let through.
Vec2d glossy_sums(double cosine, double roughness) {
    const double alpha = alpha_of(roughness);
    const Vec3d view(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
    double scale = 0.0, bias = 0.0;
    for (std::uint32_t i = 0; i < table_points; ++i) {
        const Vec3d half = visible_normal(view, alpha, hammersley(i, table_points));
        const double view_half = glm::dot(view, half), down = 2.0 * view_half * half.z - view.z;
        if (down <= 0.0) continue;
        const double passes =
            visibility(down, cosine, alpha) * 4.0 * down * cosine / masking(cosine, alpha);
        const double grazing = schlick(view_half);
        scale += passes * (1.0 - grazing);
        bias += passes * grazing;
    }
    return {scale / table_points, bias / table_points};
}

/// The directional albedo of sheen, by midpoints in azimuth and in the square root of n.l, near 0
/// of which the lobe is narrow.
double sheen_sum(double cosine, double roughness) {
    using std::numbers::pi;
    const double alpha = sheen_alpha(roughness);
    const Vec3d view(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
    double sum = 0.0;
    for (int i = 0; i < circles; ++i) {
        const double t = (i + 0.5) / circles, down = t * t, out = std::sqrt(1.0 - down * down);
        const double passes = charlie_visibility(down, cosine, alpha) * down;
        double circle = 0.0;
        for (int k = 0; k < spokes; ++k) {
            const double turn = pi * (k + 0.5) / spokes;
            const Vec3d light(out * std::cos(turn), out * std::sin(turn), down);
            circle += charlie(glm::normalize(light + view).z, alpha);
        }
        sum += 2.0 * t * passes * circle;
    }
    return std::min(sum * 2.0 * pi / (circles * spokes), 1.0);
}

Image<Vec3f> make_table() {
    Image<Vec3f> table(table_side, table_side);
    for (std::size_t y = 0; y < table_side; ++y)
        for (std::size_t x = 0; x < table_side; ++x) {
            const double cosine = std::max(double(x) / last_texel, 1e-3);
            const double roughness = double(y) / last_texel;
            const Vec2d glossy = glossy_sums(cosine, roughness);
            table(x, y) = Vec3f(Vec3d(glossy, sheen_sum(cosine, roughness)));
        }
    return table;
}

}  // namespace

const Image<Vec3f>& reflectance_table() {
    static const Image<Vec3f> table = make_table();
    return table;
}

Vec3d reflectance(double cosine, double roughness) {
    const Image<Vec3f>& table = reflectance_table();
    const double x = std::clamp(cosine, 0.0, 1.0) * last_texel,
                 y = std::clamp(roughness, 0.0, 1.0) * last_texel;
    const auto column = std::min(std::size_t(x), table_side - 2),
               row = std::min(std::size_t(y), table_side - 2);
    const double fx = x - double(column), fy = y - double(row);
    const auto at = [&](std::size_t right, std::size_t below) {
        return Vec3d(table(column + right, row + below));
    };
    return (1.0 - fy) * ((1.0 - fx) * at(0, 0) + fx * at(1, 0)) +
           fy * ((1.0 - fx) * at(0, 1) + fx * at(1, 1));
}

}  // namespace burl
