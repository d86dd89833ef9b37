#pragma once
// How a texel's footprint is averaged (Hart et al. 1999, section 3; docs/reference/filtering.md). A
// plain comparable value, part of the recipe.
namespace burl {

enum class FilterKind {
    none,         ///< the colour at the texel's centre
    table_mip,    ///< the paper's tables of halved resolution
    table_sat,    ///< the paper's summed-area table
    table_sat3,   ///< the same, three times as long
    exact,        ///< the map's integral over a box as wide as the footprint
    trapezoid,    ///< the map's integral over both axes of the footprint
    trapezoid2,   ///< the same, f's mean and slopes from the texel's corners
    supersample,  ///< stratified samples with Gaussian weights
};

struct Filter {
    FilterKind kind = FilterKind::none;
    int samples = 16;         ///< of supersample: 1 to 1024; squares are stratified best
    bool band_limit = false;  ///< leave out octaves finer than a texel, with a fade
    bool operator==(const Filter&) const = default;
};

}  // namespace burl
