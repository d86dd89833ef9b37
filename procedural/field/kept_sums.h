#pragma once
// Sums over octaves whose noise is kept: all in one pass, since they come from beyond the caches.
#include <cstddef>
#include <span>

namespace burl {

struct KeptSummand {
    float weight = 0.0f;
    const float* noise = nullptr;
};

/// values[j] += scale * (0 + weight * noise[j] + ...), the bracket in float32 in the summands'
/// order: what add_scaled and add_sums give (stream_kernels.h).
void add_kept_sums(std::span<const KeptSummand> summands, double scale, std::size_t count,
                   double* values);

}  // namespace burl
