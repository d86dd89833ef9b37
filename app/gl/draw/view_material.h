#pragma once
// The material of a view's scene: that which a glTF file of the recipe would have, and its pictures
// at the texels that a view looks up.
#include <vector>

#include "app/pipeline/material.h"
#include "app/recipe/recipe.h"
#include "app/scene/scene.h"

namespace burl {

/// A recipe's material as a scene has it: its numbers, and the pictures besides base colour and
/// normals, of which each is a texture.
struct ViewMaterial {
    SceneMaterial numbers{};  ///< without textures
    std::vector<MaterialPicture> pictures{};
};

/// The material that a plain bake to a .glb writes.
ViewMaterial view_material(const Recipe& recipe);

/// The scene's number of a picture; -1: none.
int texture_number(const SceneMaterial& material, const MaterialPicture& picture);

/// Adds a material's textures, of one texel each, in the order in which a file's reader loads them.
SceneMaterial add_textures(Scene& scene, const AtlasOptions& atlas, const ViewMaterial& material,
                           bool bumped);

}  // namespace burl
