#pragma once
// A texture of linear colours filled through a SolidAtlas in float64, for measuring. What the
// texels that belong to no triangle show is up to the baker: black, a copy of the nearest one that
// does, or the surface continued.
#include <limits>

#include "atlas/base/image.h"
#include "atlas/measure/surface_mean.h"
#include "atlas/solid/solid_atlas.h"

namespace burl {

inline constexpr std::uint32_t no_triangle = std::numeric_limits<std::uint32_t>::max();

struct TextureValues {
    Image<Vec3f> values;         ///< f at every texel's point, rounded to float
    Image<std::uint32_t> owner;  ///< triangle whose texel it is, or no_triangle
    Image<std::uint32_t> shown;  ///< triangle whose value it holds; no_triangle if there is none
};

/// What a texel without owner shows. The nearest owned texel is the one with the nearest centre,
/// whatever the distance; of equally near ones the nearer row, then the left one.
enum class GapFill {
    black,       ///< 0
    nearest,     ///< the value of the nearest owned texel: dilation
    extrapolate  ///< that texel's map continued by at most two texels in x and in y towards it
};

/// `solid` in the space f wants. Without any owned texel all values are 0.
TextureValues fill_texture(const SolidAtlas& solid, const SolidColor& f,
                           GapFill fill = GapFill::extrapolate);

}  // namespace burl
