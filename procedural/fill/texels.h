#pragma once
// Synthesis of a texture texel by texel in another arithmetic than the fast path's: in float64, the
// reference evaluation of the same definition, filters included, or in fixed point. It is slow but
// uses all threads, and the bytes do not depend on their number.
#include "atlas/base/image.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/economy.h"
#include "procedural/batch/filter.h"
#include "procedural/batch/precision.h"
#include "procedural/batch/row_window.h"
#include "procedural/model/texture.h"

namespace burl {

/// The rows `rows` of the texture as Rgb8, Rgb16 or RgbF; the arguments are those of
/// synthesize_model (synthesize.h). precision.kind must be float64 or fixed; fixed requires
/// has_fixed_point(texture) and a filter with all octaves, whose slopes are differences of f
/// (spread_over). All work that may be left out is left out; `economy` counts octaves as if a texel
/// showed all of each.
template <class Pixel>
Image<Pixel> synthesize_texels(const SolidAtlas& solid, const Texture& texture,
                               const Affine3& texture_from_atlas, const Precision& precision,
                               const Filter& filter, int threads, const Economy& economy = {},
                               const RowWindow& rows = {});

/// The field in either of the two precisions; 0 outside every span.
Image<double> field_of_texels(const SolidAtlas& solid, const Texture& texture,
                              const Affine3& texture_from_atlas, const Precision& precision,
                              int threads);

}  // namespace burl
