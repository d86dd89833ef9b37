#pragma once
// The average over a texel's footprint (Hart et al. 1999, section 3; docs/reference/filtering.md):
// a plain comparable value, part of the recipe.
#include "atlas/base/enum_names.h"

namespace burl {

enum class FilterKind {
    none,         ///< no filter: the colour at the texel's centre
    table_mip,    ///< the paper's MIP map of the colour table
    table_sat,    ///< the paper's summed-area table of the colour map
    table_sat3,   ///< the paper's summed-area table, three times as long
    exact,        ///< the colour map's integral over a box as wide as the footprint
    trapezoid,    ///< the colour map's integral over both axes of the footprint
    trapezoid2,   ///< `trapezoid`, with f's mean and slopes from the texel's corners
    supersample,  ///< stratified samples with Gaussian weights
};
template <>
inline constexpr auto enum_names<FilterKind> = enum_words("none", "table-mip", "table-sat",
                                                          "table-sat3", "exact", "trapezoid",
                                                          "trapezoid2", "supersample");

struct Filter {
    FilterKind kind = FilterKind::none;
    /// Samples per texel of `supersample`, 1 to 1024; square numbers are stratified best.
    int samples = 16;
    bool band_limit = false;  ///< fades out octaves that are finer than a texel
    bool operator==(const Filter&) const = default;
};

}  // namespace burl
