#pragma once
// Text files compiled into the program (shaders, preset recipes, sample meshes), so that a copied
// binary needs nothing beside it.
#include <span>
#include <string_view>

namespace burl {

struct EmbeddedFile {
    std::string_view name;  ///< path below its folder, "noise/value.glsl"
    std::string_view content;
};

std::span<const EmbeddedFile> embedded_recipes();  ///< assets/recipes/*.json
std::span<const EmbeddedFile> embedded_meshes();   ///< the sample meshes, *.obj
std::span<const EmbeddedFile> embedded_shaders();  ///< all of shaders/

}  // namespace burl
