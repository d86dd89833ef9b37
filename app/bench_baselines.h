#pragma once
// Noises of other libraries, to be timed beside ours: libnoise and stb_perlin, each only where the
// build found it (Debian: libnoise-dev, libstb-dev).
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "atlas/vec.h"

namespace burl {

struct BenchBaseline {
    std::string group;  ///< "value" or "gradient"
    std::string name;
    std::function<void(std::span<const Vec3d> points, double* values)> run;
};

std::vector<BenchBaseline> bench_baselines();

}  // namespace burl
