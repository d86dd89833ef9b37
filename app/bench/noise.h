#pragma once
// The suite `burl bench noise`: the time per value of every kind of noise in float32 and float64,
// the error of float32, and the times of other libraries' noises where the build found them.
#include <vector>

#include "app/bench/result.h"

namespace burl {

/// Measures about `samples` values per case, at least 1024, in `repeats` paired rounds.
std::vector<BenchResult> bench_noise(int repeats, std::size_t samples = 65536);

}  // namespace burl
