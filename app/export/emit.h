#pragma once
// A recipe's texture as a stand-alone shader for use in an engine: readable GLSL 3.30 in float32.
// Written without OpenGL.
#include <string>

#include "app/recipe/recipe.h"

namespace burl {

/// The shader text. It defines `vec3 texture_color(vec3 solid)` in linear light; the matrix
/// `solid_from_object`, which maps the mesh's own coordinates to texture coordinates; and a main
/// function that fills an atlas from its solid map. Throws Error(unsupported) for textures that
/// shaders cannot evaluate (procedural/glsl/graph.h).
std::string emit_glsl(const Recipe& recipe, const Affine3& texture_from_mesh);

}  // namespace burl
