#pragma once
// Synthesis of a texture by forward differences along the scan lines of an atlas's spans, as
// "Bresenham Noise" (Kameya & Hart) fills polygons: the kernel `forward`.
#include "atlas/base/image.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/economy.h"
#include "procedural/batch/row_window.h"
#include "procedural/bresenham/noise.h"
#include "procedural/model/texture.h"

namespace burl {

/// The rows `rows` of a texture without a filter, as Rgb8, Rgb16 or RgbF. f errs as
/// bresenham/field.h says of the precision; no_forward_form of the texture's octaves must be empty.
/// The bytes do not depend on the thread count. `threads` 0 means all. `economy` counts the work.
/// Texels outside every span get the colour of field 0.
template <class Pixel>
Image<Pixel> synthesize_forward(const SolidAtlas& solid, const Texture& texture,
                                const Affine3& texture_from_atlas, ForwardPrecision precision,
                                int threads, const Economy& economy = {},
                                const RowWindow& rows = {});

/// The field in float64; 0 outside every span.
Image<double> forward_field_of_atlas(const SolidAtlas& solid, const Texture& texture,
                                     const Affine3& texture_from_atlas, ForwardPrecision precision,
                                     int threads);

}  // namespace burl
