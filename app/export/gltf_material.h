#pragma once
// The material of a glTF document: numbers, pictures and the extensions that they need.
#include <nlohmann/json_fwd.hpp>

#include "app/export/formats.h"

namespace burl {

/// Adds the material, its textures (scene_textures) and the extensions used to the document. Images
/// are in the textures' order, each followed by its MIP levels.
void add_material(nlohmann::ordered_json& document, const SceneContent& content);

}  // namespace burl
