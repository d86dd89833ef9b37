#include "app/gl/draw/scene_programs.h"

#include "app/gl/device/objects.h"
#include "app/scene/shading.h"

namespace burl {

namespace {

const char* word(bool value) {
    return value ? "true" : "false";
}

/// A program of mesh.vert and a fragment shader.
GlProgram scene_program(const GladGLContext& gl, ShaderSource fragment) {
    return {gl, "the scene", ShaderSource().add("draw/mesh.vert"), fragment};
}

}  // namespace

const GlProgram& GlScenePrograms::use(const Look& look) {
    auto found = looks_.find(look);
    if (found == looks_.end()) {
        ShaderSource source;
        source.define("ENCODED", word(look.encoded)).define("LIT", word(look.lit));
        source.define("BUMPED", word(look.bumped)).define("LEVELS", word(look.levels));
        source.define("IN_BLOCKS", word(look.in_blocks)).define("PLACES", word(look.places));
        source.add("maps/footprint.glsl")
            .add("maps/level_size.glsl")
            .add("color/srgb_encode.glsl")
            .add("draw/mesh.frag");
        found = looks_.emplace(look, scene_program(gl_, source)).first;
    }
    const GlProgram& program = found->second;
    program.use();
    program.set("ambient", float(ambient));
    program.set("base_color", 0);
    program.set("normal_map", 1);
    return program;
}

const GlProgram& GlScenePrograms::use_lookups() {
    if (!lookups_)
        lookups_.emplace(scene_program(
            gl_, ShaderSource().add("maps/footprint.glsl").add("draw/mesh_lookups.frag")));
    lookups_->use();
    return *lookups_;
}

}  // namespace burl
