#pragma once
// The suite `burl bench noise`: the time per value of every kind of noise in float32 and float64,
// the error of float32, and the times of other libraries' noises where the build found them.
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/bench/bench.h"
#include "atlas/base/vec.h"
#include "procedural/model/octaves.h"

namespace burl {

/// Returns the octaves of a noise term of that kind and fade, all else by default.
std::vector<Octave> noise_octaves(NoiseKind kind, Fade fade, std::uint32_t octaves);

/// Measures about `samples` values per case, at least 1024, in `repeats` paired rounds.
std::vector<BenchResult> bench_noise(int repeats, std::size_t samples = 65536);

using BenchPoints = std::shared_ptr<const std::vector<Vec3d>>;

/// A noise of another library.
struct BenchBaseline {
    std::string group;  ///< "value", "gradient" or "four octaves"
    std::string name;
    std::function<void()> run;  ///< evaluates the noise at all points
};

/// The noises of libnoise, stb_perlin and FastNoise2, as far as the build found these libraries.
std::vector<BenchBaseline> bench_baselines(const BenchPoints& points);

}  // namespace burl
