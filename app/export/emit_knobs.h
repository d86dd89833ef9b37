#pragma once
// The controls of a recipe as uniforms of its emitted shader (emit.h). A shader's numbers are made
// of a recipe's by many functions, so that it is found by turning the controls which of its numbers
// follow them, and by what law; what follows no law, or changes more than numbers, stays constant
// and is named.
#include <functional>
#include <string>
#include <vector>

#include "app/recipe/recipe.h"

namespace burl {

/// A shader whose numbers follow uniforms.
struct KnobbedShader {
    std::string uniforms{};  ///< their definitions, which precede the text
    std::string text{};
    std::vector<std::string> notes{};  ///< a sentence for each control that stays constant
};

/// The shader that `shader_of` makes of the recipe, with a uniform for each control. Where all have
/// their initial values it is the recipe's, and with other values that of the recipe with the
/// controls set, but for rounding of its numbers to float32. Errors of `shader_of` for the recipe
/// itself pass through.
KnobbedShader with_knobs(const Recipe& recipe,
                         const std::function<std::string(const Recipe&)>& shader_of);

}  // namespace burl
