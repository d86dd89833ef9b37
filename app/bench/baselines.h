#pragma once
// Noises of other libraries, to be timed beside ours: libnoise, stb_perlin and FastNoise2, each
// only where the build found it (Debian: libnoise-dev, libstb-dev).
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "atlas/base/vec.h"

namespace burl {

using BenchPoints = std::shared_ptr<const std::vector<Vec3d>>;

struct BenchBaseline {
    std::string group;  ///< "value", "gradient" or "four octaves"
    std::string name;
    std::function<void()> run;  ///< the noise at all points
};

std::vector<BenchBaseline> bench_baselines(const BenchPoints& points);

/// FastNoise2's generators, which take single-precision arrays; none where the build has not found
/// it. They are kept to AVX2 or SSE 4.1 where our kernels are.
std::vector<BenchBaseline> fastnoise_baselines(const BenchPoints& points);

}  // namespace burl
