#pragma once
// The errors of filtered colours against the definition of the closed forms
// (docs/reference/filtering.md): the map's mean over the box or trapezoid given by f and its
// slopes, computed in long double.
#include "procedural/batch/filter.h"
#include "procedural/batch/precision.h"
#include "tests/stability/stability.h"

namespace burl {

/// Returns the mean of the map in linear light over f + u U + v V, with U and V uniform in [-1/2,
/// 1/2]. The time is proportional to |u| + |v|.
Vec3d long_mean(const ColorMap& map, long double f, long double u, long double v);

/// Returns the errors of a case's texels under the filter `none`, `exact`, `trapezoid` or
/// `trapezoid2`. The map must be continuous.
StabilityRow filter_errors(const StabilityCase& one, FilterKind kind, PrecisionKind precision);

/// Returns the errors of filter_group() under all four filters and of the quadrics' unfiltered
/// colours, in float32 and float64.
std::vector<StabilityRow> check_filter_errors(const std::vector<StabilityGroup>& groups,
                                              StabilityChoice choice);

}  // namespace burl
