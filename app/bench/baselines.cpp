// A library's noises are listed only where the build found it.
#include "app/bench/noise.h"

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
#ifdef BURL_HAVE_FASTNOISE2
#include <FastNoise/FastNoise.h>

#include <fmt/format.h>

#include "procedural/batch/texel_batch.h"
#include "procedural/numbers/simd_target.h"
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

#ifdef BURL_HAVE_FASTNOISE2

/// The points as single-precision arrays, and a buffer for a batch of values, which fits into the
/// L1 cache.
struct Arrays {
    std::vector<float> x, y, z, values;

    explicit Arrays(const std::vector<Vec3d>& points) : values(batch_capacity) {
        for (const Vec3d& p : points) {
            x.push_back(float(p.x));
            y.push_back(float(p.y));
            z.push_back(float(p.z));
        }
    }
};

FastSIMD::FeatureSet feature_set() {
    const std::string level = simd_level();
    if (level == "AVX2") return FastSIMD::FeatureSet::AVX2_FMA;
    return level.starts_with("AVX3") ? FastSIMD::FeatureSet::Max : FastSIMD::FeatureSet::SSE41;
}

/// Makes a generator; null where the library lacks so small an instruction set.
template <class Node>
FastNoise::SmartNode<Node> scaled_node() {
    FastNoise::SmartNode<Node> node = FastNoise::New<Node>(feature_set());
    if (node) node->SetScale(1.0f);
    return node;
}

template <class Node>
FastNoise::SmartNode<FastNoise::FractalFBm> four_octaves() {
    const auto source = scaled_node<Node>();
    if (!source) return {};
    const auto sum = FastNoise::New<FastNoise::FractalFBm>(feature_set());
    sum->SetSource(source);
    sum->SetOctaveCount(4);
    return sum;
}

class FastNoiseList {
  public:
    explicit FastNoiseList(const std::vector<Vec3d>& points)
        : arrays_(std::make_shared<Arrays>(points)) {}

    template <class Node>
    void add(const char* group, const char* name, FastNoise::SmartNode<Node> node) {
        if (!node) return;
        const auto run = [node, arrays = arrays_] {
            auto& [x, y, z, values] = *arrays;
            for (std::size_t i = 0; i + batch_capacity <= x.size(); i += batch_capacity)
                node->GenPositionArray3D(values.data(), int(batch_capacity), &x[i], &y[i], &z[i],
                                         0.0f, 0.0f, 0.0f, 1);
        };
        list.push_back({group, fmt::format("FastNoise2 {}", name), run});
    }

    std::vector<BenchBaseline> list;

  private:
    std::shared_ptr<Arrays> arrays_;
};

/// Generators take single-precision arrays, and use AVX2 or SSE 4.1 where our kernels are limited
/// to that.
std::vector<BenchBaseline> fastnoise_baselines(const std::vector<Vec3d>& points) {
    FastNoiseList all(points);
    all.add("value", "value, smooth", scaled_node<FastNoise::Value>());
    all.add("gradient", "perlin", scaled_node<FastNoise::Perlin>());
    all.add("gradient", "simplex", scaled_node<FastNoise::Simplex>());
    all.add("four octaves", "value, smooth", four_octaves<FastNoise::Value>());
    all.add("four octaves", "perlin", four_octaves<FastNoise::Perlin>());
    return all.list;
}

#endif

}  // namespace

std::vector<BenchBaseline> bench_baselines([[maybe_unused]] const BenchPoints& points) {
    std::vector<BenchBaseline> all;
#ifdef BURL_HAVE_FASTNOISE2
    all = fastnoise_baselines(*points);
#endif
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
