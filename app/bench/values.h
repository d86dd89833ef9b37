#pragma once
// The values that suites compare: colours of the texels that show a mesh, in linear light, as an
// image stores them and as the texture's definition gives them in float64.
#include <cstdint>
#include <vector>

#include "app/recipe/recipe.h"
#include "atlas/base/image.h"
#include "atlas/solid/solid_atlas.h"

namespace burl {

/// Returns the three channels of every texel, row by row and span by span, of every `step`-th row.
std::vector<double> color_values(const SolidAtlas& solid, const Image<Rgb8>& image,
                                 std::uint32_t step = 1);
std::vector<double> color_values(const SolidAtlas& solid, const Image<RgbF>& image,
                                 std::uint32_t step = 1);

/// Returns the colours of the recipe's definition (Hart et al. 1999, eq. 1 and 2, or its graph) in
/// float64, texel by texel and without filter.
std::vector<double> defined_colors(const SolidAtlas& solid, const Recipe& recipe,
                                   std::uint32_t step = 1);

}  // namespace burl
