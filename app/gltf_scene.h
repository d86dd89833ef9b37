#pragma once
// The glTF document of a textured mesh: JSON and one binary buffer, before they become files.
#include <cstdint>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/export_gltf.h"

namespace burl {

struct GltfScene {
    nlohmann::ordered_json json;       ///< all but `buffers` and the image's source
    std::vector<std::uint8_t> binary;  ///< what the bufferViews index; length a multiple of 4
};

/// Meshes (one per part, one primitive each), nodes (one per placement), material, sampler,
/// textures; images are left to the caller: 0 is the texture, l its MIP level l, and the one after
/// these the normal map, if any. The texture's extras.burl_levels lists the levels.
GltfScene build_gltf_scene(const GltfContent& content);

/// Appends bytes at a multiple of 4 and returns the number of the new bufferView.
std::size_t add_buffer_view(GltfScene& scene, std::span<const std::uint8_t> bytes);

}  // namespace burl
