#include "app/gl/draw/view_material.h"

#include <algorithm>
#include <optional>

#include "app/export/gltf_scene.h"
#include "procedural/color/srgb.h"

namespace burl {

namespace {

SceneMaterial numbers_of(const Material& m) {
    SceneMaterial numbers;
    numbers.metallic = float(m.metallic);
    numbers.roughness = float(m.roughness);
    numbers.emissive = Vec3f(linear_light(m.emissive) * m.emissive_strength);
    numbers.ior = float(m.ior);
    numbers.specular = float(m.specular);
    numbers.clearcoat = float(m.clearcoat);
    numbers.clearcoat_roughness = float(m.clearcoat_roughness);
    numbers.sheen = Vec3f(linear_light(m.sheen));
    numbers.sheen_roughness = float(m.sheen_roughness);
    numbers.transmission = float(m.transmission);
    numbers.alpha_cutoff = float(m.alpha_cutoff);
    return numbers;
}

SceneTexture texture_of(const AtlasOptions& atlas, bool is_color) {
    SceneTexture texture{Image<Rgb8>(1, 1), baked_filter(atlas)};
    texture.wrap_u = texture.wrap_v = TextureWrap::clamp;
    texture.is_color = is_color;
    return texture;
}

/// The number of the picture that has the slot.
std::optional<std::size_t> picture_in(const std::vector<MaterialPicture>& pictures,
                                      std::string_view slot) {
    for (std::size_t i = 0; i < pictures.size(); ++i)
        if (std::ranges::find(pictures[i].slots, slot) != pictures[i].slots.end()) return i;
    return {};
}

}  // namespace

ViewMaterial view_material(const Recipe& recipe) {
    ViewMaterial material{numbers_of(material_factors(recipe)),
                          material_pictures(recipe, Packing::gltf)};
    if (is_transparent(recipe))
        material.numbers.alpha =
            recipe.material.alpha == AlphaMode::mask ? SceneAlpha::mask : SceneAlpha::blend;
    return material;
}

int texture_number(const SceneMaterial& material, const MaterialPicture& picture) {
    for (const MaterialSlot& slot : material_slots)
        if (std::ranges::find(picture.slots, slot.pointer) != picture.slots.end())
            return material.map(slot.map);
    return -1;
}

SceneMaterial add_textures(Scene& scene, const AtlasOptions& atlas, const ViewMaterial& material,
                           bool bumped) {
    const auto add = [&](bool is_color) {
        scene.textures.push_back(texture_of(atlas, is_color));
        return int(scene.textures.size()) - 1;
    };
    SceneMaterial result = material.numbers;
    if (bumped) result.normals = add(false);
    result.texture = add(true);
    std::vector<int> numbers(material.pictures.size(), -1);
    for (const MaterialSlot& slot : material_slots) {
        const auto picture = picture_in(material.pictures, slot.pointer);
        if (!picture) continue;
        if (numbers[*picture] < 0) numbers[*picture] = add(slot.is_color);
        result.maps[std::size_t(slot.map)] = numbers[*picture];
    }
    return result;
}

}  // namespace burl
