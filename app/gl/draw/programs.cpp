#include "app/gl/draw/programs.h"

#include <algorithm>
#include <string>

#include "app/gl/draw/layers.h"
#include "app/scene/shading.h"

namespace burl {

namespace {

const char* word(bool value) {
    return value ? "true" : "false";
}

/// The name of a picture in shaders: metallic_roughness.
constexpr std::array<const char*, material_slots.size()> map_names{
    "metallic_roughness", "occlusion",           "emissive", "specular",        "specular_color",
    "clearcoat",          "clearcoat_roughness", "sheen",    "sheen_roughness", "transmission"};

std::string upper(std::string text) {
    std::ranges::transform(text, text.begin(), [](char c) { return c == '_' ? c : char(c - 32); });
    return text;
}

/// A program of mesh.vert and a fragment shader.
GlProgram scene_program(const GladGLContext& gl, ShaderSource fragment) {
    return {gl, "the scene", ShaderSource().add("draw/mesh.vert"), fragment};
}

/// The macros of a look, as draw/mesh.frag and draw/coarse.vert tell.
ShaderSource macros_of(const GlScenePrograms::Look& look) {
    ShaderSource source;
    source.define("ENCODED", word(look.encoded)).define("LIT", word(look.lit));
    source.define("AMBIENT", word(look.ambient)).define("TONE", word(look.tone));
    source.define("BUMPED", word(look.bumped)).define("LEVELS", word(look.levels));
    source.define("IN_BLOCKS", word(look.in_blocks)).define("PLACES", word(look.places));
    source.define("MASKS", word(look.masks)).define("BLENDS", word(look.blends));
    source.define("ANISOTROPIC", word(look.anisotropic));
    source.define("LAYERED", word(look.layered)).define("SUN", word(look.sun));
    source.define("CLEARCOAT", word(look.clearcoat)).define("SHEEN", word(look.sheen));
    source.define("TRANSMITS", word(look.transmits)).define("ONE_ORM", word(look.one_orm));
    for (std::size_t i = 0; i < map_names.size(); ++i)
        source.define("HAS_" + upper(map_names[i]), word((look.maps >> i & 1u) != 0));
    return source;
}

ShaderSource fragment_source(const GlScenePrograms::Look& look) {
    return macros_of(look)
        .add("maps/footprint.glsl")
        .add("maps/level_size.glsl")
        .add("color/srgb_encode.glsl")
        .add("draw/tone.glsl")
        .add("draw/lookup.glsl")
        .add("draw/light.glsl")
        .add("draw/material.glsl")
        .add("draw/mesh.frag");
}

/// A program that shades vertices and not pixels.
GlProgram coarse_program(const GladGLContext& gl, const GlScenePrograms::Look& look) {
    return {gl, "the coarse scene",
            macros_of(look)
                .add("color/srgb_encode.glsl")
                .add("draw/tone.glsl")
                .add("draw/coarse_lookup.glsl")
                .add("draw/light.glsl")
                .add("draw/material.glsl")
                .add("draw/coarse.vert"),
            ShaderSource().add("draw/coarse.frag")};
}

GlProgram program_of(const GladGLContext& gl, const GlScenePrograms::Look& look) {
    return look.coarse ? coarse_program(gl, look) : scene_program(gl, fragment_source(look));
}

}  // namespace

const GlProgram& GlScenePrograms::use(const Look& look) {
    auto found = looks_.find(look);
    if (found == looks_.end()) found = looks_.emplace(look, program_of(gl_, look)).first;
    const GlProgram& program = found->second;
    program.use();
    program.set("ambient", float(ambient));
    program.set("base_color", base_color_unit);
    program.set("normal_map", normal_map_unit);
    program.set("nearer", GlLayerDepths::nearer_unit);
    program.set("farther", GlLayerDepths::farther_unit);
    for (std::size_t i = 0; i < map_names.size(); ++i)
        program.set((std::string("map_") + map_names[i]).c_str(), first_map_unit + int(i));
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
