#pragma once
// How far a texture of 8 bits is from the same recipe in float64: the reference evaluation of the
// definition, filters and paint included, at the very points that the texels show, before it is
// rounded to codes.
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/recipe/recipe.h"
#include "atlas/base/image.h"

namespace burl {

struct TextureError {
    /// Per texel the largest difference of a channel, in sRGB codes of 8 bits; -1 where an atlas
    /// shows nothing. Rounding alone takes it to 1/2.
    Image<float> codes;
    double largest = 0.0, rms = 0.0;  ///< of codes; over all channels
};

/// Why there is no float64 reference of a recipe whose solid points lie in `box`, in one sentence;
/// empty: there is one.
std::string no_reference(const Recipe& recipe, const Box3& box);

/// `solid` is in the recipe's space, `texels` the recipe's texture of it. All threads; empty:
/// `stop` came first.
std::optional<TextureError> texture_error(const SolidAtlas& solid, const Recipe& recipe,
                                          const Image<Rgb8>& texels, const std::stop_token& stop);

/// Where the ramp of false colours ends: the least power of two from 2 on that no error exceeds.
/// (From 2 on, so that rounding, which is everywhere, stays in its dark quarter.)
double error_scale(double largest);

/// Through the ramp of `burl diff` (app/image/image_diff.h) up to error_scale, level 0 to the one
/// of 1 x 1 texel; a texel of a coarser level shows the largest error it covers.
std::vector<Image<Rgb8>> error_levels(const TextureError& error);

}  // namespace burl
