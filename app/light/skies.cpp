#include "app/light/skies.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/light/formulas.h"
#include "procedural/noise/noise.h"

namespace burl {

namespace {

/// A sum of five octaves of gradient noise, about -1 to 1.
double clouds(Vec3d p) {
    const NoiseSpec noise{NoiseKind::perlin};
    double sum = 0.0;
    for (double share = 1.0; share > 0.05; share *= 0.5, p *= 2.03)
        sum += share * evaluate_noise(noise, p);
    return sum;
}

/// The point of a flat layer of clouds that a direction above the horizon meets.
Vec3d cloud_point(const Vec3d& direction, double scale, double shift) {
    const double height = std::max(direction.y, 0.0) + 0.12;
    return {scale * direction.x / height + shift, shift, scale * direction.z / height};
}

/// The share of a direction that lies above a hazy horizon.
double above(double height) {
    return smooth_step(-0.02, 0.02, height);
}

constexpr double sun_radius = 1.2 * std::numbers::pi / 180.0;

}  // namespace

Vec3d overcast_light(const Vec3d& direction) {
    const double up = std::max(direction.y, 0.0);
    const double veil =
        1.0 + 0.42 * smooth_step(0.0, 0.3, up) * clouds(cloud_point(direction, 1.1, 3.7));
    const Vec3d sky = Vec3d(0.94, 0.98, 1.06) * ((1.0 + 2.0 * up) / 3.0 * veil);
    const Vec3d ground =
        Vec3d(0.17, 0.16, 0.14) * (1.0 - 0.25 * smooth_step(0.0, -1.0, direction.y));
    return mixed(ground, sky, above(direction.y));
}

Vec3d sun_light(const Vec3d& direction) {
    static const Vec3d sun = towards(-48.0, 34.0);
    const double up = std::max(direction.y, 0.0), cosine = glm::dot(direction, sun);
    const Vec3d blue = mixed(Vec3d(0.62, 0.78, 1.0), Vec3d(0.13, 0.27, 0.62), std::pow(up, 0.45));
    const Vec3d glow = Vec3d(1.0, 0.93, 0.80) * (0.9 * std::exp(22.0 * (cosine - 1.0)) +
                                                 0.25 * std::exp(3.0 * (cosine - 1.0)));
    const double wisp = smooth_step(0.18, 0.75, clouds(cloud_point(direction, 0.9, 8.2)));
    const Vec3d sky =
        mixed(blue + glow, Vec3d(1.5, 1.5, 1.52), 0.55 * wisp * smooth_step(0.02, 0.25, up));
    const Vec3d ground = Vec3d(0.42, 0.37, 0.29) * (0.85 + 0.15 * direction.y);
    const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
    const double disc = 1.0 - smooth_step(0.8 * sun_radius, 1.2 * sun_radius, angle);
    return mixed(ground, sky, above(direction.y)) + disc * Vec3d(4400.0, 3950.0, 3250.0);
}

Vec3d dusk_light(const Vec3d& direction) {
    static const Vec3d west = towards(-70.0, -3.0);
    const double up = std::max(direction.y, 0.0), cosine = glm::dot(direction, west);
    const double near = 0.5 + 0.5 * cosine;
    const Vec3d high = mixed(Vec3d(0.055, 0.085, 0.155), Vec3d(0.12, 0.16, 0.245), near);
    const Vec3d low = mixed(Vec3d(0.15, 0.145, 0.19), Vec3d(1.5, 0.78, 0.38), std::pow(near, 4.0));
    Vec3d sky = mixed(low, high, std::pow(smooth_step(0.0, 0.42, up), 0.6));
    sky += Vec3d(15.0, 7.2, 2.6) * std::exp(40.0 * (cosine - 1.0)) * std::exp(-5.0 * up);
    const double wisp = smooth_step(0.05, 0.7, clouds(cloud_point(direction, 0.7, 1.3)));
    const Vec3d lit = mixed(Vec3d(0.14, 0.12, 0.15), Vec3d(2.2, 1.1, 0.68), std::pow(near, 5.0));
    sky = mixed(sky, lit, 0.55 * wisp * smooth_step(0.01, 0.12, up) * (1.0 - 0.5 * up));
    const Vec3d ground = mixed(Vec3d(0.03, 0.03, 0.032), Vec3d(0.085, 0.07, 0.06), near);
    return mixed(ground, sky, above(direction.y));
}

}  // namespace burl
