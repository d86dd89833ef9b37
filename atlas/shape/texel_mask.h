#pragma once
// A mask at every texel of an atlas.
#include "atlas/base/image.h"
#include "atlas/shape/surface_lattice.h"

namespace burl {

struct TexelMaskOptions {
    /// Distance in texels between the points at which the mask is worked out and between which it
    /// is interpolated; 0 works it out at every texel.
    double spacing = 4.0;
    /// Texels are not interpolated between values that differ by more, in the mask's own units.
    float tolerance = 0.1f;
};

/// The mask's values at the surface points of all texels, 0 for texels that show nothing; the same
/// for every number of threads. `solid` must be of the mesh that `shape` was made of, in the
/// mesh's own space. Gutter texels get the value at the nearest side of their triangle, so that
/// lookups at a chart's border mix nothing foreign.
Image<float> texel_mask(const SolidAtlas& solid, const ShapeScene& shape, const PointMask& mask,
                        const TexelMaskOptions& options = {});

}  // namespace burl
