#pragma once
// Noises of other libraries for comparison: libnoise, stb_perlin and FastNoise2, each only where
// the build found it (Debian: libnoise-dev, libstb-dev).
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "atlas/base/vec.h"

namespace burl {

using BenchPoints = std::shared_ptr<const std::vector<Vec3d>>;

/// A noise of another library.
struct BenchBaseline {
    std::string group;  ///< "value", "gradient" or "four octaves"
    std::string name;
    std::function<void()> run;  ///< evaluates the noise at all points
};

/// The noises of all libraries that the build found.
std::vector<BenchBaseline> bench_baselines(const BenchPoints& points);

/// FastNoise2's generators, which take single-precision arrays; empty where the build did not find
/// the library. They use AVX2 or SSE 4.1 where our kernels are limited to that.
std::vector<BenchBaseline> fastnoise_baselines(const BenchPoints& points);

}  // namespace burl
