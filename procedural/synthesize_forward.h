#pragma once
// Fills an atlas with the texture by forward differences along the scan lines of its spans, as
// "Bresenham Noise" (Kameya & Hart) fills polygons: the kernel `forward`.
#include "atlas/image.h"
#include "atlas/solid_atlas.h"
#include "procedural/texture.h"

namespace burl {

/// As synthesize_rgb8 and its like (synthesize.h) without a filter, for Rgb8, Rgb16 and RgbF; f
/// errs by 4e-12 (1 + |f|) where they err by 1e-6. no_forward_form (forward_field.h) must hold
/// nothing against the texture's octaves. The bytes do not depend on the thread count.
template <class Pixel>
Image<Pixel> synthesize_forward(const SolidAtlas& solid, const Texture& texture,
                                const Affine3& texture_from_atlas, int threads);

/// The field itself; 0 outside every span.
Image<double> forward_field_of_atlas(const SolidAtlas& solid, const Texture& texture,
                                     const Affine3& texture_from_atlas, int threads);

}  // namespace burl
