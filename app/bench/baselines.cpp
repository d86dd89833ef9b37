#include "app/bench/baselines.h"

#ifdef BURL_HAVE_STB_PERLIN
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_PERLIN_IMPLEMENTATION
#define STBPERLIN_STATIC
#include <stb_perlin.h>
#pragma GCC diagnostic pop
#endif
#ifdef BURL_HAVE_LIBNOISE
#include <noisegen.h>
#endif

namespace burl {

namespace {

template <class Noise>
BenchBaseline baseline(const char* group, const char* name, const BenchPoints& points,
                       Noise noise) {
    const auto values = std::make_shared<std::vector<double>>(points->size());
    return {group, name, [noise, points, values] {
                double* value = values->data();
                for (const Vec3d& p : *points) *value++ = noise(p);
            }};
}

}  // namespace

std::vector<BenchBaseline> bench_baselines(const BenchPoints& points) {
    std::vector<BenchBaseline> all = fastnoise_baselines(points);
#ifdef BURL_HAVE_LIBNOISE
    using namespace noise;
    all.push_back(baseline("value", "libnoise value, linear", points, [](const Vec3d& p) {
        return ValueCoherentNoise3D(p.x, p.y, p.z, 0, QUALITY_FAST);
    }));
    all.push_back(baseline("value", "libnoise value, cubic", points, [](const Vec3d& p) {
        return ValueCoherentNoise3D(p.x, p.y, p.z, 0, QUALITY_STD);
    }));
    all.push_back(baseline("gradient", "libnoise gradient, quintic", points, [](const Vec3d& p) {
        return GradientCoherentNoise3D(p.x, p.y, p.z, 0, QUALITY_BEST);
    }));
#endif
#ifdef BURL_HAVE_STB_PERLIN
    all.push_back(baseline("gradient", "stb_perlin", points, [](const Vec3d& p) {
        return double(stb_perlin_noise3_seed(float(p.x), float(p.y), float(p.z), 0, 0, 0, 0));
    }));
#endif
    return all;
}

}  // namespace burl
