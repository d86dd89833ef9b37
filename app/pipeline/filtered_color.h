#pragma once
// The recipe's texture over what a picture sample covers: the filters of a bake
// (docs/reference/filtering.md) with the footprint of a sample in place of a texel's.
#include <functional>

#include "app/recipe/recipe.h"
#include "procedural/batch/texel_place.h"

namespace burl {

/// At texture coordinates s, which move by the footprint from one sample to the next: linear light
/// multiplied by alpha, and alpha. May be called from several threads at once.
using FilteredColor = std::function<Vec4d(const Vec3d& s, const Footprint& footprint)>;

/// `kind`: any filter that needs no further samples; with `none` footprints do not count, and the
/// precision is the recipe's, else float64. Throws Error(usage) for filters in fixed point.
FilteredColor filtered_color(const Recipe& recipe, FilterKind kind);

/// The width of the filter in place of the colour, as a grey whose sRGB code is w - 1: black for
/// one entry of a colour table of 256 or less, white for all of it or more (Hart et al. 1999,
/// figure 9c). Throws Error(usage) for a recipe whose texture is a graph, which has no single map.
FilteredColor filter_width_grey(const Recipe& recipe);

}  // namespace burl
