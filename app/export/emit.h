#pragma once
// A recipe's texture as a shader of its own, for use in an engine: readable GLSL 3.30 in float32
// with nothing around it. Writing it needs no OpenGL.
#include <string>

#include "app/recipe/recipe.h"

namespace burl {

/// Defines `vec3 texture_color(vec3 solid)`, linear light; `solid_from_object`, the matrix that
/// takes the mesh's own coordinates there; and a main function that fills an atlas from its solid
/// map. Throws Error(unsupported) for what shaders cannot do (procedural/glsl/graph.h).
std::string emit_glsl(const Recipe& recipe, const Affine3& texture_from_mesh);

}  // namespace burl
