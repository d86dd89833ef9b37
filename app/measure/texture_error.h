#pragma once
// The error of an 8-bit texture against the same recipe in float64: the reference evaluation,
// filters and paint included, at the same points as the texels, before rounding to codes.
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/recipe/recipe.h"
#include "atlas/base/image.h"

namespace burl {

/// The differences of a texture from its reference.
struct TextureError {
    /// Per texel the largest difference of a channel, in 8-bit sRGB codes; -1 outside all spans.
    /// Rounding alone makes it up to 1/2.
    Image<float> codes;
    double largest = 0.0, rms = 0.0;  ///< errors in codes, over all channels
};

/// The reason, in one sentence, why a recipe whose solid points lie in `box` has no float64
/// reference; empty where it has one.
std::string no_reference(const Recipe& recipe, const Box3& box);

/// The error of `texels`, the recipe's texture of `solid`, which is in the recipe's space. Uses all
/// threads; no value where `stop` was requested.
std::optional<TextureError> texture_error(const SolidAtlas& solid, const Recipe& recipe,
                                          const Image<Rgb8>& texels, const std::stop_token& stop);

/// The error at which the false-colour ramp ends: the least power of two, at least 2, that no error
/// exceeds (at most 256). From 2 on, rounding errors stay in the ramp's dark quarter.
double error_scale(double largest);

/// MIP levels, down to 1 x 1 texel, of the error through the ramp of `burl diff`
/// (app/image/image_diff.h) up to error_scale. A texel of a coarser level shows the largest error
/// it covers.
std::vector<Image<Rgb8>> error_levels(const TextureError& error);

}  // namespace burl
