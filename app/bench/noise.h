#pragma once
// The suite `burl bench noise`: what one value of every kind of noise costs in float32 and float64
// and how far float32 is from the definition, beside other libraries' noises where the build found
// them.
#include <vector>

#include "app/bench/result.h"

namespace burl {

/// About `samples` values a case, `repeats` paired rounds; `samples` is at least 1024.
std::vector<BenchResult> bench_noise(int repeats, std::size_t samples = 65536);

}  // namespace burl
