#pragma once
// The part of an emitted shader (emit.h) that gives a whole material: every channel of the recipe,
// whether it varies or not, the surface's height and the bumped normal.
#include <string>

#include "app/recipe/recipe.h"

namespace burl {

/// The definitions of `struct TextureMaterial`, `texture_material`, `texture_height` and
/// `texture_normal`, in GLSL 3.30. They follow those of glsl_material() in float32 and of the
/// matrix `solid_from_object`, whose map is `texture_from_mesh`.
std::string emitted_material(const Recipe& recipe, const Affine3& texture_from_mesh);

}  // namespace burl
