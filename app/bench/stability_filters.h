#pragma once
// Filtered colours against the closed forms' definition (docs/reference/filtering.md): the map's
// mean over the box or trapezoid that value and slopes of f give, everything in long double.
#include "app/bench/stability.h"
#include "procedural/batch/filter.h"
#include "procedural/batch/precision.h"

namespace burl {

/// Mean of the map, linear light, over f + u U + v V, with U and V even in [-1/2, 1/2]. The time
/// grows with |u| + |v|.
Vec3d long_mean(const ColorMap& map, long double f, long double u, long double v);

/// One case's texels through `none`, `exact`, `trapezoid` or `trapezoid2`, against the definition.
/// The map must not jump.
StabilityRow filter_errors(const StabilityCase& one, FilterKind kind, PrecisionKind precision);

/// Rows of filter_group and of the quadrics' colours: the three filters in float32 and float64.
std::vector<StabilityRow> check_filter_errors(const std::vector<StabilityGroup>& groups,
                                              StabilityChoice choice);

}  // namespace burl
