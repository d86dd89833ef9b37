#pragma once
// What is no field of texels, for `burl bench stability`: where texels lie, and what must hold bit
// for bit or be refused, whose rows count failures.
#include "app/bench/stability.h"
#include "app/bench/stability_cases.h"

namespace burl {

/// Texels' points inside slivers and small triangles, against the corners' weighted mean: within
/// 1e-14 of the mesh's size.
StabilityRow check_texel_points(StabilityChoice choice);

/// Coordinates 2^32 cells apart have the same bits: cells wrap.
StabilityRow check_wrap(StabilityChoice choice);

/// The same bits on every instruction set, by every kernel, and of all kernels; in filtered
/// colours, too.
StabilityRow check_instruction_sets(const std::vector<StabilityGroup>& groups,
                                    StabilityChoice choice);

/// The same bytes for 1, 2, 3, 7 and all threads, and wherever in a batch a texel falls, by every
/// way.
StabilityRow check_threads(StabilityChoice choice);
StabilityRow check_batches(StabilityChoice choice);

/// Every filter's colours are finite and in [0, 1], whatever the coordinates and steps.
StabilityRow check_filters(const std::vector<StabilityGroup>& groups);

/// Recipes with NaN, infinity or numbers out of range anywhere, and octaves beyond 2^46 cells, are
/// refused in one sentence.
StabilityRow check_refusals();

}  // namespace burl
