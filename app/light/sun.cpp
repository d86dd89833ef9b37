#include "app/light/sun.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/light/formulas.h"

namespace burl {

namespace {

using std::numbers::pi;

constexpr double outshines = 16.0;  ///< times the mean luminance
constexpr double least_share = 0.05;
constexpr double widest_sun = 3.5 * pi / 180.0, around_sun = 5.0 * pi / 180.0;

/// Calls use(pixel, direction, solid angle) for every pixel of the map.
template <class Map, class Use>
void each_pixel(Map& map, const Use& use) {
    const double width = double(map.width()), height = double(map.height());
    for (std::size_t y = 0; y < map.height(); ++y) {
        const double solid =
            2.0 * pi / width *
            (std::cos(pi * double(y) / height) - std::cos(pi * (double(y) + 1.0) / height));
        for (std::size_t x = 0; x < map.width(); ++x)
            use(map(x, y), direction_at({(double(x) + 0.5) / width, (double(y) + 0.5) / height}),
                solid);
    }
}

/// The sum of a map's pixels.
struct Whole {
    double light = 0.0;  ///< luminance times solid angle
    double brightest = 0.0;
    Vec3d towards{0.0};  ///< the brightest pixel
};

Whole whole_of(const Image<RgbF>& map) {
    Whole whole;
    each_pixel(map, [&](const RgbF& p, const Vec3d& direction, double solid) {
        const double seen = luminance(vec_of(p));
        whole.light += solid * seen;
        if (seen > whole.brightest) whole.brightest = seen, whole.towards = direction;
    });
    return whole;
}

/// Sums over the light that exceeds a limit.
struct Excess {
    Vec3d light{0.0}, towards{0.0};
    double power = 0.0;

    void add(const Vec3d& more, const Vec3d& direction) {
        light += more;
        power += luminance(more);
        towards += luminance(more) * direction;
    }
};

/// The radius of the disc with the mean square width of the light, which is bilinear between
/// pixels `step` radians apart: the directions' mean is the shorter, the wider they are strewn.
double radius_of(const Excess& excess, double step) {
    const double shorter = 1.0 - glm::length(excess.towards) / excess.power;
    return std::sqrt(2.0 * (2.0 * shorter + step * step / 3.0));
}

}  // namespace

SunAndSky without_sun(const Environment& environment) {
    SunAndSky result{{}, environment};
    const Whole whole = whole_of(environment.radiance);
    const double limit = outshines * whole.light / (4.0 * pi);
    if (whole.brightest <= limit) return result;
    const double near = std::cos(around_sun);
    Excess excess;
    each_pixel(result.sky.radiance, [&](RgbF& p, const Vec3d& direction, double solid) {
        const Vec3d color = vec_of(p);
        const double seen = luminance(color);
        if (seen <= limit || glm::dot(direction, whole.towards) < near) return;
        excess.add(solid * (1.0 - limit / seen) * color, direction);
        p = rgb_of(limit / seen * color);
    });
    const double radius = radius_of(excess, pi / double(environment.radiance.height()));
    if (excess.power < least_share * whole.light || radius > widest_sun) return {{}, environment};
    result.sun = {Vec3f(glm::normalize(excess.towards)), Vec3f(excess.light), float(radius)};
    return result;
}

}  // namespace burl
