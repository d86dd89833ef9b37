#pragma once
// Sums of octaves whose noise is cached: one pass adds all octaves, since the numbers come from
// main memory.
#include <cstddef>
#include <span>

namespace burl {

/// An octave's cached noise, and its weight in the sum.
struct KeptSummand {
    float weight = 0.0f;
    const float* noise = nullptr;
};

/// values[j] += scale * (0 + weight * noise[j] + ...), the bracket in float32 in the summands'
/// order; the bits are those of add_scaled for every summand and add_sums (stream_kernels.h).
void add_kept_sums(std::span<const KeptSummand> summands, double scale, std::size_t count,
                   double* values);

}  // namespace burl
