#pragma once
// Which texels an early exit leaves, vectorised as in texel_batch.h.
#include <cstddef>
#include <cstdint>
#include <span>

#include "procedural/batch/texel_batch.h"
#include "procedural/color/constant_intervals.h"

namespace burl {

/// Field values this large or larger are not looked at where the map repeats.
inline constexpr double largest_repeated = 1e6;

/// positions[0..result) = the numbers of the f[j] that lie in none of the intervals, in order; with
/// `repeats` f's fraction counts. f is rounded to float32 before it is compared. Reads f up to the
/// end of a vector of floats, and writes up to 2 * batch_padding elements more than `count`.
std::size_t find_undecided(bool repeats, std::span<const IndexInterval> intervals, const double* f,
                           std::size_t count, std::uint32_t* positions);

}  // namespace burl
