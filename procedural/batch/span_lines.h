#pragma once
// The lines of solid points that a row's spans show, number by number instead of span by span: all
// that octaves need to know of a span, in a form that is cheap to keep and to read again.
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "procedural/batch/texel_batch.h"

namespace burl {

/// Texels of spans that follow one another: `texels` of them, from number `first` of span 0 on.
/// Span i begins at `start` and goes on by `step` for counts[i] texels, all of which decide how it
/// is worked out even where the batch has but a part. Numbers are read (not used) up to
/// span_padding beyond the last span's.
struct SpanLines {
    const double* start[3] = {};
    const double* step[3] = {};
    const std::uint32_t* counts = nullptr;
    std::size_t spans = 0, first = 0, texels = 0;
    const double* needed = nullptr;  ///< of the texels, soon: fetched from memory meanwhile

    /// The part of span i that the batch has, which begins with its texel `at`.
    LatticeLine line(std::size_t i, std::size_t at) const {
        const std::size_t before = i == 0 ? first : 0;
        const Vec3d from(start[0][i], start[1][i], start[2][i]);
        const Vec3d by(step[0][i], step[1][i], step[2][i]);
        return {from, by, double(before), std::min(counts[i] - before, texels - at)};
    }
};

inline constexpr std::size_t span_padding = 8;

}  // namespace burl
