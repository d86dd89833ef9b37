#include "procedural/model/metric_marble.h"

#include <cmath>
#include <numbers>

#include "procedural/noise/noise.h"

namespace burl {

double metric_marble(const Vec3d& s) {
    const Vec3d p = s + Vec3d(0.013, 0.027, 0.041);
    double f = 2.0 * p.z, frequency = 2.0, amplitude = 1.0;
    for (int i = 0; i < 4; ++i, frequency *= 2.0, amplitude *= 0.5)
        f += amplitude * published_perlin_noise(frequency * p);
    return 0.5 * (1.0 - std::cos(2.0 * std::numbers::pi * f));
}

}  // namespace burl
