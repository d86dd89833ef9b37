#pragma once
// The glTF document of a textured mesh: JSON and one binary buffer, before they are written.
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "app/export/formats.h"
#include "app/export/vertices.h"
#include "app/scene/scene.h"
#include "atlas/base/json.h"

namespace burl {

struct GltfScene {
    nlohmann::ordered_json json;  ///< everything but `buffers` and the images' sources
    /// The contents of the bufferViews, in order; each is padded with zeros to a multiple of 4
    /// bytes.
    std::vector<std::span<const std::uint8_t>> binary;
    std::uint64_t binary_size = 0;  ///< the buffer's length in bytes, padding included
    /// The arrays in `binary` that the content does not own: copies in placements, strips, 16-bit
    /// indices, and keys.
    std::deque<PartVertices> placed;
    std::deque<std::vector<std::uint32_t>> strips;
    std::deque<std::vector<std::uint16_t>> narrow_indices;
    std::vector<float> key_times, key_values;  ///< of the pose's weight
};

/// The sampler's filter for a texture baked on such an atlas. Only patch atlases have so few chart
/// borders that viewers may use MIP levels of their own.
TextureFilter baked_filter(const AtlasOptions& atlas);

/// A glTF sampler for it.
nlohmann::ordered_json gltf_sampler(const AtlasOptions& atlas);

/// The value of `asset.extras.burl`: the bake's atlas, and its recipe, or those
/// that share it, where there are any.
nlohmann::ordered_json burl_extras(const SceneContent& content);

/// Builds meshes (one per part, one primitive each), nodes (one per placement), material, sampler
/// and textures. Images are left to the caller: those of scene_textures, one after the other. A
/// texture's extras.burl_levels lists its levels. The scene refers to the vertices, which must
/// outlive it. Throws Error(unsupported) for points beyond the range of 32-bit floats.
GltfScene build_gltf_scene(const SceneContent& content, std::span<const PartVertices> vertices);

/// The indices of a primitive of mode TRIANGLE_STRIP that shows the triangles of a list; they are
/// added to `counts`.
std::vector<std::uint32_t> strip_indices(std::span<const std::uint32_t> list, StripCounts& counts);

/// The zeros that pad so many bytes to a multiple of 4.
std::span<const std::uint8_t> padding_after(std::uint64_t bytes);

}  // namespace burl
