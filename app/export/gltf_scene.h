#pragma once
// The glTF document of a textured mesh: JSON and one binary buffer, before they become files.
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/export/gltf.h"
#include "app/scene/scene.h"

namespace burl {

struct GltfScene {
    nlohmann::ordered_json json;  ///< all but `buffers` and the image's source
    /// What the bufferViews index, in order; each is followed by zeros up to a multiple of 4 bytes.
    std::vector<std::span<const std::uint8_t>> binary;
    std::uint64_t binary_size = 0;  ///< zeros included
    /// What `binary` shows besides the content's own arrays.
    std::deque<PartVertices> placed;
    std::deque<std::vector<std::uint16_t>> narrow_indices;
};

/// How its sampler asks for the texture. Only patches have borders so few that any viewer's own MIP
/// levels may be looked up.
TextureFilter baked_filter(const AtlasOptions& atlas);

/// Meshes (one per part, one primitive each), nodes (one per placement), material, sampler,
/// textures; images are left to the caller: 0 is the texture, l its MIP level l, and the one after
/// these the normal map, if any. The texture's extras.burl_levels lists the levels. The scene shows
/// the content's vertices, which must outlive it.
GltfScene build_gltf_scene(const GltfContent& content);

/// A bufferView over so many bytes after those there are; returns its number.
std::size_t add_buffer_view(GltfScene& scene, std::uint64_t bytes);

/// Zeros that follow so many bytes.
std::span<const std::uint8_t> padding_after(std::uint64_t bytes);

}  // namespace burl
