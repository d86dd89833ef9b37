#pragma once
// A texture of linear colours filled through a SolidAtlas in float64, for measuring. The baker
// chooses what texels that belong to no triangle show: black, a copy of the nearest texel that
// belongs to one, or the surface continued.
#include <limits>

#include "atlas/base/image.h"
#include "atlas/measure/surface_mean.h"
#include "atlas/solid/solid_atlas.h"

namespace burl {

/// Owner of texels that belong to no triangle.
inline constexpr std::uint32_t no_triangle = std::numeric_limits<std::uint32_t>::max();

/// A texture with the origin of every texel's value.
struct TextureValues {
    Image<Vec3f> values;         ///< f at every texel's point, rounded to float
    Image<std::uint32_t> owner;  ///< triangle that the texel belongs to, or no_triangle
    Image<std::uint32_t> shown;  ///< triangle whose value it holds, or no_triangle
};

/// The value of a texel without owner. The nearest owned texel is the one with the nearest centre,
/// whatever the distance; of equally near ones the nearer row, then the left one.
enum class GapFill {
    black,       ///< value 0
    nearest,     ///< the value of the nearest owned texel: dilation
    extrapolate  ///< nearest owned texel's map, continued by at most two texels in x and y
};

/// Fills a texture; `solid` is in the space of f. Without any owned texel all values are 0.
TextureValues fill_texture(const SolidAtlas& solid, const SolidColor& f,
                           GapFill fill = GapFill::extrapolate);

}  // namespace burl
