// Factors are those of glTF 2.0 and the ratified KHR_materials_... extensions; what has its default
// is left out.
#include "app/export/gltf_material.h"

#include <algorithm>

#include "atlas/base/json.h"
#include "procedural/color/srgb.h"

namespace burl {
namespace {

using Json = nlohmann::ordered_json;

Json light(const Rgb8& color) {
    const Vec3d linear = linear_light(color);
    return {linear.x, linear.y, linear.z};
}

/// The extensions of channels that are not in the core of glTF.
Json extensions(const Material& m) {
    Json json = Json::object();
    const auto extension = [&](const char* name) -> Json& {
        return json[std::string("KHR_materials_") + name];
    };
    if (m.emissive_strength != 1.0)
        extension("emissive_strength") = {{"emissiveStrength", m.emissive_strength}};
    if (m.ior != 1.5) extension("ior") = {{"ior", m.ior}};
    if (m.specular != 1.0) extension("specular") = {{"specularFactor", m.specular}};
    if (m.clearcoat != 0.0)
        extension("clearcoat") = {{"clearcoatFactor", m.clearcoat},
                                  {"clearcoatRoughnessFactor", m.clearcoat_roughness}};
    if (m.sheen != Rgb8{})
        extension("sheen") = {{"sheenColorFactor", light(m.sheen)},
                              {"sheenRoughnessFactor", m.sheen_roughness}};
    if (m.transmission != 0.0) extension("transmission") = {{"transmissionFactor", m.transmission}};
    return json;
}

bool are_opaque(const std::vector<Vec4f>& colors) {
    return std::ranges::all_of(colors, [](const Vec4f& color) { return color.a >= 1.0f; });
}

}  // namespace

Json gltf_material(const SceneContent& content, const ExportShare& share,
                   const GltfPlaces& places) {
    const Material& m = share.material;
    const auto texture_info = [&](std::size_t number) {
        Json info{{"index", places.textures + number}};
        if (places.uv_set > 0) info["texCoord"] = places.uv_set;
        return info;
    };
    Json json{{"name", material_name(content, share.recipe_name)},
              {"pbrMetallicRoughness",
               {{"baseColorTexture", texture_info(0)},
                {"metallicFactor", m.metallic},
                {"roughnessFactor", m.roughness}}},
              {"doubleSided", true}};
    if (!content.options.vertex_colors.empty())
        json["pbrMetallicRoughness"].erase("baseColorTexture");
    if (share.normals) json["normalTexture"] = texture_info(1);
    if (m.emissive != Rgb8{}) json["emissiveFactor"] = light(m.emissive);
    if (share.transparent) {
        const bool mask = m.alpha == AlphaMode::mask;
        json["alphaMode"] = mask ? "MASK" : "BLEND";
        if (mask) json["alphaCutoff"] = m.alpha_cutoff;
    }
    if (Json used = extensions(m); !used.empty()) json["extensions"] = std::move(used);
    std::size_t texture = content.options.normals ? 2 : 1;
    for (const std::vector<std::string>& slots : share.slots) {
        for (const std::string& slot : slots)
            json[Json::json_pointer(slot)] = texture_info(texture);
        ++texture;
    }
    return json;
}

Json gltf_material(const SceneContent& content, const GltfPlaces& places) {
    const ExportOptions& options = content.options;
    ExportShare whole{options.recipe_name, options.recipe_json, options.material,
                      has_alpha(content.image) || !are_opaque(options.vertex_colors),
                      options.normals.has_value()};
    for (const ExportPicture& picture : options.pictures) whole.slots.push_back(picture.slots);
    return gltf_material(content, whole, places);
}

Json gltf_textures(const SceneContent& content, const GltfPlaces& places) {
    const bool webp = content.options.coding.format == TextureFormat::webp;
    Json result = Json::array();
    std::size_t image = places.images;
    for (const std::vector<SceneImage>& texture : scene_textures(content, "")) {
        Json json{{"sampler", places.sampler}};
        (webp ? json["extensions"][webp_extension] : json)["source"] = image;
        for (std::size_t l = 1; l < texture.size(); ++l)
            json["extras"]["burl_levels"].push_back(image + l);
        image += texture.size();
        result.push_back(std::move(json));
    }
    return result;
}

void add_material(Json& document, const SceneContent& content) {
    Json one = gltf_material(content, {});
    if (one.contains("extensions"))
        for (const auto& item : one["extensions"].items())
            document["extensionsUsed"].push_back(item.key());
    if (content.options.coding.format == TextureFormat::webp) {
        document["extensionsUsed"].push_back(webp_extension);
        document["extensionsRequired"].push_back(webp_extension);
    }
    document["materials"] = Json::array({std::move(one)});
    if (content.options.vertex_colors.empty()) document["textures"] = gltf_textures(content, {});
}

}  // namespace burl
