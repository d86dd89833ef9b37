#pragma once
// The lines of solid points that a row's spans show, stored as one array per coordinate: all that
// octaves need to know of spans, in a form that is cheap to keep and to read again.
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "procedural/batch/texel_batch.h"

namespace burl {

/// `texels` texels of consecutive spans, beginning with texel `first` of span 0. Span i has
/// counts[i] texels on a line that begins at `start` and goes on by `step` per texel. The choice of
/// kernel depends on the whole span even where the batch has but a part of it. Kernels read (and do
/// not use) span_padding elements beyond the last span.
struct SpanLines {
    const double* start[3] = {};
    const double* step[3] = {};
    const std::uint32_t* counts = nullptr;
    std::size_t spans = 0, first = 0, texels = 0;
    const double* needed = nullptr;  ///< numbers of the texels to be prefetched, or null

    /// The line of the part of span i that the batch has; `at` is the batch's number of the part's
    /// first texel.
    LatticeLine line(std::size_t i, std::size_t at) const {
        const std::size_t before = i == 0 ? first : 0;
        const Vec3d from(start[0][i], start[1][i], start[2][i]);
        const Vec3d by(step[0][i], step[1][i], step[2][i]);
        return {from, by, double(before), std::min(counts[i] - before, texels - at)};
    }
};

/// The number of elements beyond the last span that kernels read.
inline constexpr std::size_t span_padding = 8;

}  // namespace burl
