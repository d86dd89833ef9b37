#pragma once
// The suite `burl bench synthesis`: baking whole textures by every way there is, against the
// definition in float64.
#include <vector>

#include "app/bench_result.h"

namespace burl {

/// Textures of `side`^2 texels of a torus, `repeats` paired rounds; errors are of colours in linear
/// light, over the texels that show it.
std::vector<BenchResult> bench_synthesis(int repeats, std::size_t side = 1024);

}  // namespace burl
