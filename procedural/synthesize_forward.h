#pragma once
// Fills an atlas with the texture by forward differences along the scan lines of its spans, as
// "Bresenham Noise" (Kameya & Hart) fills polygons: the kernel `forward`.
#include "atlas/image.h"
#include "atlas/solid_atlas.h"
#include "procedural/economy.h"
#include "procedural/forward_noise.h"
#include "procedural/row_window.h"
#include "procedural/texture.h"

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
