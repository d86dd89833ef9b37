#pragma once
// The checks of `burl bench stability` besides field errors: positions of texels, filtered colours,
// and properties that must hold bit for bit or must be refused, whose rows count failures.
#include "tests/stability/cases.h"
#include "tests/stability/stability.h"

namespace burl {

/// Compares the solid points of texels in slivers and small triangles with the barycentric mean of
/// the corners: the bound is 1e-14 of the mesh's size.
StabilityRow check_texel_points(StabilityChoice choice);

/// Checks that coordinates 2^32 cells apart have identical bits, as cells wrap.
StabilityRow check_wrap(StabilityChoice choice);

/// Checks that every instruction set gives identical bits, by every kernel and for filtered
/// colours, and that the kernels that promise it agree.
StabilityRow check_instruction_sets(const std::vector<StabilityGroup>& groups,
                                    StabilityChoice choice);

/// Checks that 1, 2, 3, 7 and all threads give identical bytes, by every way.
StabilityRow check_threads(StabilityChoice choice);
/// Checks that a texel's bytes do not depend on its place in a batch, by every kernel.
StabilityRow check_batches(StabilityChoice choice);

/// Returns the mean of the map in linear light over f + u U + v V, with U and V uniform in [-1/2,
/// 1/2], in long double: the definition of the closed forms (docs/reference/filtering.md). The time
/// is proportional to |u| + |v|.
Vec3d long_mean(const ColorMap& map, long double f, long double u, long double v);

/// Returns the errors of filter_group() against that mean under all four filters, and of the
/// quadrics' unfiltered colours, in float32 and float64.
std::vector<StabilityRow> check_filter_errors(const std::vector<StabilityGroup>& groups,
                                              StabilityChoice choice);

/// Checks that every filter's colours are finite and in [0, 1] for all coordinates and steps.
StabilityRow check_filters(const std::vector<StabilityGroup>& groups);

/// Checks that recipes with NaN, infinity or a number out of range, and octaves beyond 2^46 cells,
/// are refused in one sentence.
StabilityRow check_refusals();

}  // namespace burl
