#pragma once
// Fills an atlas with the texture by forward differences along the scan lines of its spans, as
// "Bresenham Noise" (Kameya & Hart) fills polygons: the kernel `forward`.
#include "atlas/base/image.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/economy.h"
#include "procedural/batch/row_window.h"
#include "procedural/bresenham/noise.h"
#include "procedural/model/texture.h"

namespace burl {

/// As synthesize_rgb8 and its like (synthesize.h) without a filter, for Rgb8, Rgb16 and RgbF; f
/// errs as forward_field.h says of the precision. no_forward_form (there) must hold nothing against
/// the texture's octaves. The bytes do not depend on the thread count. `economy` counts. Gives the
/// `rows` alone.
template <class Pixel>
Image<Pixel> synthesize_forward(const SolidAtlas& solid, const Texture& texture,
                                const Affine3& texture_from_atlas, ForwardPrecision precision,
                                int threads, const Economy& economy = {},
                                const RowWindow& rows = {});

/// The field itself; 0 outside every span.
Image<double> forward_field_of_atlas(const SolidAtlas& solid, const Texture& texture,
                                     const Affine3& texture_from_atlas, ForwardPrecision precision,
                                     int threads);

}  // namespace burl
