#pragma once
// Text files compiled into the program (shaders, recipes, materials, sample
// meshes, the viewer of web pages), so that a copied binary needs nothing beside it.
#include <span>
#include <string_view>

namespace burl {

struct EmbeddedFile {
    std::string_view name;  ///< the path below the file's folder: "noise/value.glsl"
    std::string_view content;
};

std::span<const EmbeddedFile> embedded_recipes();    ///< the presets, assets/recipes/papers/*.json
std::span<const EmbeddedFile> embedded_materials();  ///< assets/materials/*.json
std::span<const EmbeddedFile> embedded_meshes();     ///< the sample meshes, *.obj
std::span<const EmbeddedFile> embedded_viewer();     ///< viewer.js of web pages, empty if not built
std::span<const EmbeddedFile> embedded_shaders();    ///< all files of shaders/

}  // namespace burl
