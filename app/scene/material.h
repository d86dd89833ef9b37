#pragma once
// The material of a surface, as glTF 2.0 defines metallic-roughness materials, their alpha and
// their ratified extensions.
#include <array>
#include <cstddef>
#include <string_view>

#include "atlas/base/vec.h"

namespace burl {

/// The use that a material makes of alpha, as glTF defines it.
enum class SceneAlpha {
    opaque,  ///< none
    mask,    ///< what is below the cutoff is not there
    blend    ///< the share of the colour over what lies behind
};

/// The pictures of a material besides its base colour and normals, which multiply its numbers.
enum class MaterialMap : std::size_t {
    metallic_roughness,  ///< roughness in green, metallic in blue
    occlusion,           ///< in red
    emissive,
    specular,  ///< in alpha
    specular_color,
    clearcoat,            ///< in red
    clearcoat_roughness,  ///< in green
    sheen,
    sheen_roughness,  ///< in alpha
    transmission      ///< in red
};

/// A picture's place in a glTF material, as a JSON pointer.
struct MaterialSlot {
    MaterialMap map;
    std::string_view pointer;
    bool is_color;  ///< codes are sRGB; otherwise linear
};

/// The places of all pictures, in the enumerators' order.
inline constexpr std::array<MaterialSlot, 10> material_slots{
    {{MaterialMap::metallic_roughness, "/pbrMetallicRoughness/metallicRoughnessTexture", false},
     {MaterialMap::occlusion, "/occlusionTexture", false},
     {MaterialMap::emissive, "/emissiveTexture", true},
     {MaterialMap::specular, "/extensions/KHR_materials_specular/specularTexture", false},
     {MaterialMap::specular_color, "/extensions/KHR_materials_specular/specularColorTexture", true},
     {MaterialMap::clearcoat, "/extensions/KHR_materials_clearcoat/clearcoatTexture", false},
     {MaterialMap::clearcoat_roughness,
      "/extensions/KHR_materials_clearcoat/clearcoatRoughnessTexture", false},
     {MaterialMap::sheen, "/extensions/KHR_materials_sheen/sheenColorTexture", true},
     {MaterialMap::sheen_roughness, "/extensions/KHR_materials_sheen/sheenRoughnessTexture", false},
     {MaterialMap::transmission, "/extensions/KHR_materials_transmission/transmissionTexture",
      false}}};

inline constexpr std::array<int, material_slots.size()> no_material_maps = [] {
    std::array<int, material_slots.size()> none{};
    none.fill(-1);
    return none;
}();

/// A material, two-sided whatever its file says. Textures are indices into Scene::textures, -1
/// being none; colours are linear. The defaults are those of a bake without a material.
struct SceneMaterial {
    Vec4f factor{1.0f};  ///< multiplies the texture's colour and alpha
    int texture = -1;    ///< of the base colour
    int normals = -1;    ///< a tangent-space normal map
    float normal_scale = 1.0f;
    SceneAlpha alpha = SceneAlpha::opaque;
    float alpha_cutoff = 0.5f;
    float metallic = 0.0f, roughness = 0.6f;
    float occlusion_strength = 1.0f;  ///< share of the occlusion map that counts
    Vec3f emissive{0.0f};             ///< its strength included
    float ior = 1.5f, specular = 1.0f;
    Vec3f specular_color{1.0f};
    float clearcoat = 0.0f, clearcoat_roughness = 0.0f;
    Vec3f sheen{0.0f};
    float sheen_roughness = 0.0f;
    float transmission = 0.0f;
    bool unlit = false;  ///< the base colour is shown whatever the light (KHR_materials_unlit)
    std::array<int, material_slots.size()> maps = no_material_maps;

    bool operator==(const SceneMaterial&) const = default;
    int map(MaterialMap which) const { return maps[std::size_t(which)]; }
    /// Whether a picture of the material is this texture.
    bool shows(int number) const {
        if (texture == number || normals == number) return true;
        for (const int one : maps)
            if (one == number) return true;
        return false;
    }
};

}  // namespace burl
