#pragma once
// A recipe's texture for another program: as a stand-alone shader, and the solid map of a baked
// mesh's atlas, which the shader fills the atlas from.
#include <string>
#include <vector>

#include "app/base/atomic_file.h"
#include "app/recipe/recipe.h"

namespace burl {

class Pipeline;

/// A shader, and sentences on what of the recipe's controls it could not keep.
struct EmittedShader {
    std::string text{};
    std::vector<std::string> notes{};
};

/// A shader in readable GLSL 3.30 and float32, made without OpenGL. It defines `vec3
/// texture_color(vec3 solid)` in linear light; the matrix `solid_from_object`, which maps the
/// mesh's own coordinates to texture coordinates; the whole material (emit_material.h); a uniform
/// for each control of the recipe (emit_knobs.h); and a main function that fills an atlas with the
/// colour from its solid map. `solid_from_mesh` is the mesh's map to the recipe's solid space.
/// Throws Error(unsupported) for textures and bumps that shaders cannot evaluate
/// (procedural/glsl/graph.h).
EmittedShader emit_glsl(const Recipe& recipe, const Affine3& solid_from_mesh);

/// A solid map's base, and its file.
struct WrittenSolidMap {
    Vec3d base{0.0};
    AtomicFile file;  ///< a file yet to be committed
};
/// Writes the solid map (procedural/batch/point_map.h) of the pipeline's atlas, in its recipe's
/// texture coordinates (after solid.scale), as an EXR file: channels X, Y and Z (32-bit floats, the
/// offset from the base), A (1 in spans, 0 elsewhere) and owner (32-bit, Span::map or no_owner);
/// the header's "base" is the base in float64. Row 0 on top. 0 threads means all. Throws Error(io),
/// and Error(runtime) where OpenEXR cannot encode it.
WrittenSolidMap write_solid_map(const std::string& path, Pipeline& pipeline, int threads);

}  // namespace burl
