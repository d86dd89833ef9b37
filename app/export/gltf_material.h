#pragma once
// The material of a glTF document: numbers, pictures and the extensions that they need.
#include <nlohmann/json_fwd.hpp>

#include "app/export/formats.h"

namespace burl {

/// Numbers in a document from which on the content's things are.
struct GltfPlaces {
    std::size_t textures = 0, images = 0;  ///< the first texture and image
    std::size_t sampler = 0;
    std::uint32_t uv_set = 0;  ///< the set of texture coordinates
};

/// The material, double-sided: a solid texture is the same on both sides, and open sheets and
/// meshes with inconsistent winding look whole.
nlohmann::ordered_json gltf_material(const SceneContent& content, const GltfPlaces& places);

/// The material of a recipe that shares the content's atlas.
nlohmann::ordered_json gltf_material(const SceneContent& content, const ExportShare& share,
                                     const GltfPlaces& places);

/// The textures, whose images (scene_textures) follow one another, each followed by its MIP levels,
/// which extras.burl_levels lists.
nlohmann::ordered_json gltf_textures(const SceneContent& content, const GltfPlaces& places);

/// Adds the material, its textures (scene_textures) and the extensions used to the document. Images
/// are in the textures' order, each followed by its MIP levels.
void add_material(nlohmann::ordered_json& document, const SceneContent& content);

}  // namespace burl
