#pragma once
// Fills an atlas with the texture texel by texel in another arithmetic than the fast path's: in
// float64, the reference evaluation of the same definition, filters included, or in fixed point.
// Slow, but on all threads; the bytes do not depend on their number.
#include "atlas/base/image.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/economy.h"
#include "procedural/batch/filter.h"
#include "procedural/batch/precision.h"
#include "procedural/batch/row_window.h"
#include "procedural/model/texture.h"

namespace burl {

/// As synthesize_rgb8 and its like (synthesize.h), for Rgb8, Rgb16 and RgbF. precision.kind must be
/// float64 or fixed; for the latter has_fixed_point(texture) must hold, and the filter be `none` or
/// `supersample` with all octaves. `economy` counts, as if a texel showed all of every octave; all
/// that may be left out is left out. Gives the `rows` alone.
template <class Pixel>
Image<Pixel> synthesize_texels(const SolidAtlas& solid, const Texture& texture,
                               const Affine3& texture_from_atlas, const Precision& precision,
                               const Filter& filter, int threads, const Economy& economy = {},
                               const RowWindow& rows = {});

/// The field itself, in any of the two precisions; 0 outside every span.
Image<double> field_of_texels(const SolidAtlas& solid, const Texture& texture,
                              const Affine3& texture_from_atlas, const Precision& precision,
                              int threads);

}  // namespace burl
