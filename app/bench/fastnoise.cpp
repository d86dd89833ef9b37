#include "app/bench/baselines.h"

#ifdef BURL_HAVE_FASTNOISE2
#include <FastNoise/FastNoise.h>

#include <fmt/format.h>

#include "procedural/batch/texel_batch.h"
#include "procedural/numbers/simd_target.h"
#endif

namespace burl {

#ifdef BURL_HAVE_FASTNOISE2

namespace {

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

class Baselines {
  public:
    explicit Baselines(const std::vector<Vec3d>& points)
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

}  // namespace

std::vector<BenchBaseline> fastnoise_baselines(const BenchPoints& points) {
    Baselines all(*points);
    all.add("value", "value, smooth", scaled_node<FastNoise::Value>());
    all.add("gradient", "perlin", scaled_node<FastNoise::Perlin>());
    all.add("gradient", "simplex", scaled_node<FastNoise::Simplex>());
    all.add("four octaves", "value, smooth", four_octaves<FastNoise::Value>());
    all.add("four octaves", "perlin", four_octaves<FastNoise::Perlin>());
    return all.list;
}

#else

std::vector<BenchBaseline> fastnoise_baselines(const BenchPoints&) {
    return {};
}

#endif

}  // namespace burl
