#pragma once
// The suite `burl bench rivals`: noise that is worked out at every texel, beside the two ways to do
// without that the papers name: a 3-D texture that holds it, looked up trilinearly (Carr & Hart
// 2001, section 5.2), and a sparse grid of values with quadratic interpolation between them
// (Goehring et al., cited there).
#include <vector>

#include "app/bench/bench.h"

namespace burl {

/// Measures smooth value noise over about `side`^2 texels, 512 unless given and at least 32, at
/// three distances between texels, in `repeats` paired rounds. Errors are against the noise in
/// float64.
std::vector<BenchResult> bench_rivals(int repeats, std::size_t side = 512);

}  // namespace burl
