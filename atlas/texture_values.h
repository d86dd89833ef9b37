#pragma once
// A texture of one linear channel filled through a SolidAtlas in float64, for measuring. Texels
// that belong to no triangle copy the nearest one that does, as bakers dilate.
#include <limits>

#include "atlas/image.h"
#include "atlas/solid_atlas.h"
#include "atlas/surface_mean.h"

namespace burl {

inline constexpr std::uint32_t no_triangle = std::numeric_limits<std::uint32_t>::max();

struct TextureValues {
    Image<float> values;         ///< f at every texel's point, rounded to float
    Image<std::uint32_t> owner;  ///< triangle whose texel it is, or no_triangle
    Image<std::uint32_t> shown;  ///< triangle whose value it holds; no_triangle if there is none
};

/// `solid` in the space f wants. A texel without owner takes the value of the owned texel with the
/// nearest centre, whatever the distance; of equally near ones the nearer row, then the left one.
/// Without any owned texel all values are 0.
TextureValues fill_texture(const SolidAtlas& solid, const SolidFunction& f);

}  // namespace burl
