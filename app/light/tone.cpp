#include "app/light/tone.h"

#include <algorithm>
#include <cmath>

namespace burl {

namespace {

constexpr double fresnel = 0.04;            ///< what a dielectric reflects of white light
constexpr double shoulder = 0.8 - fresnel;  ///< from which on light is compressed
constexpr double desaturation = 0.15;       ///< how fast bright colours go to white

double least(const Vec3d& v) {
    return std::min({v.x, v.y, v.z});
}

double greatest(const Vec3d& v) {
    return std::max({v.x, v.y, v.z});
}

/// The grey that is taken from light: that of the Fresnel reflection, less where it is dark.
double reflection_of(double darkest) {
    if (darkest >= 2.0 * fresnel) return fresnel;
    return darkest - darkest * darkest / (4.0 * fresnel);
}

}  // namespace

Vec3d tone_mapped(const Vec3d& light) {
    const Vec3d color = light - reflection_of(least(light));
    const double peak = greatest(color);
    if (peak <= shoulder) return color;
    const double room = 1.0 - shoulder;
    const double mapped = 1.0 - room * room / (peak + room - shoulder);
    const double kept = 1.0 / (desaturation * (peak - mapped) + 1.0);
    return kept * (mapped / peak) * color + (1.0 - kept) * Vec3d(mapped);
}

Vec3d developed(const Vec3d& light, const LightOptions& options) {
    const Vec3d exposed = std::exp2(options.exposure) * light;
    return options.is_headlight() || !options.tone_curve ? exposed : tone_mapped(exposed);
}

}  // namespace burl
