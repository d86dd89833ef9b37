#pragma once
// A mask at every texel of an atlas.
#include <stop_token>

#include "atlas/base/image.h"
#include "atlas/shape/surface_lattice.h"
#include "atlas/solid/texel_field.h"

namespace burl {

/// A mask, and its gradients where these have a closed form; without one they are differences
/// between points of lattices.
struct ShapeMask {
    PointMask values;
    PointSlopes slopes{};
};

struct TexelMaskOptions {
    /// Distance in texels between the points at which the mask is worked out and between which it
    /// is interpolated; 0 works it out at every texel.
    double spacing = 4.0;
    /// Texels are not interpolated between values that differ by more, in the mask's own units.
    float tolerance = 0.1f;
    bool slopes = false;     ///< whether gradients are wanted
    std::stop_token stop{};  ///< once it is requested, the result must not be used
};

/// The mask's values at the surface points of all texels, 0 for texels that show nothing; the same
/// for every number of threads. `solid` must be of the mesh that `shape` was made of, in the
/// mesh's own space, and `owners` of `solid`. Gutter texels get the value at the nearest side of
/// their triangle, so that lookups at a chart's border mix nothing foreign, and the gradient there.
/// Gradients that are differences are taken over cells of `spacing` texels, at least one.
TexelField texel_mask(const SolidAtlas& solid, const TexelOwners& owners, const ShapeScene& shape,
                      const ShapeMask& mask, const TexelMaskOptions& options = {});

}  // namespace burl
