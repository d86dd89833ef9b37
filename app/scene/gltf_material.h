#pragma once
// Materials of a glTF file as those of a scene, but for base colour and normals.
#include <string>
#include <vector>

#include "app/scene/gltf_textures.h"
#include "app/scene/material.h"

namespace tinygltf {
struct Material;
}  // namespace tinygltf

namespace burl {

/// The surroundings that reading a material needs.
struct MaterialReading {
    GltfTextures& textures;
    int uv_set = 0;      ///< the texture coordinates that the surface has; -1: none
    std::string name{};  ///< of the material, in notes
    std::vector<std::string>& notes;
};

/// Sets the numbers of `material` and its pictures besides base colour and normals. What cannot be
/// drawn is left out with a note.
void read_gltf_material(const tinygltf::Material& source, const MaterialReading& reading,
                        SceneMaterial& material);

}  // namespace burl
