#include "app/kept/carved_material.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "app/export/gltf_file.h"
#include "app/export/gltf_material.h"
#include "app/export/gltf_scene.h"

namespace burl {
namespace {

/// The array of the document, made where it is missing, which ends all references to its others.
Json& array_of(Json& document, const char* name) {
    if (!document.contains(name)) document[name] = Json::array();
    return document[name];
}

}  // namespace

CarvedMaterial::CarvedMaterial(KeptDocument& document, const SceneContent& content,
                               const std::string& pictures)
    : document_(document), content_(content), pictures_(pictures) {
    const std::size_t first_image = array_of(document.json, "images").size();
    SceneContent named{pictures.empty() ? content.path : pictures, content.mesh, content.atlas,
                       content.image, content.options};
    const std::string color =
        pictures.empty() ? "" : path_beside(pictures, extension_of(content.options.coding.format));
    for (const std::vector<SceneImage>& texture : scene_textures(named, color))
        for (const SceneImage& image : texture) add_image(image);
    if (content.options.coding.format == TextureFormat::webp) {
        document.use_extension(webp_extension);
        Json& required = array_of(document.json, "extensionsRequired");
        if (std::ranges::find(required, Json(webp_extension)) == required.end())
            required.push_back(webp_extension);
    }
    const std::size_t sampler = add_sampler();
    Json& textures = array_of(document.json, "textures");
    first_texture_ = textures.size();
    for (Json& texture : gltf_textures(named, {first_texture_, first_image, sampler}))
        textures.push_back(std::move(texture));
}

void CarvedMaterial::add_image(const SceneImage& image) {
    Json json{{"name", image.name}};
    if (pictures_.empty()) {
        std::vector<std::uint8_t> bytes;
        image.encode([&](std::span<const std::uint8_t> some) {
            bytes.insert(bytes.end(), some.begin(), some.end());
        });
        json["bufferView"] = document_.add_view(std::move(bytes));
    } else {
        image.encode(sink_of(files_.emplace_back(image.path)));
        json["uri"] = relative_uri(image.path);
        document_.new_uris.push_back(json["uri"]);
    }
    json["mimeType"] = media_type(content_.options.coding.format);
    document_.json["images"].push_back(std::move(json));
}

/// The number of the sampler for the content's textures, one of the document where it has one.
std::size_t CarvedMaterial::add_sampler() {
    Json& samplers = array_of(document_.json, "samplers");
    Json wanted = gltf_sampler(content_.atlas.options);
    const auto found = std::ranges::find(samplers, wanted);
    const auto number = std::size_t(found - samplers.begin());
    if (found == samplers.end()) samplers.push_back(std::move(wanted));
    return number;
}

void CarvedMaterial::use_at(std::array<std::size_t, 2> primitive, std::uint32_t uv_set,
                            std::uint32_t share) {
    const Json& target = document_.json["meshes"][primitive[0]]["primitives"][primitive[1]];
    users_[{target.value("material", -1), uv_set, share}].push_back(primitive);
}

/// The materials that primitives and variants of them have.
std::set<int> CarvedMaterial::used_materials() const {
    std::set<int> used;
    const auto variants = Json::json_pointer("/extensions/KHR_materials_variants/mappings");
    for (const Json& mesh : document_.json["meshes"])
        for (const Json& primitive : mesh.at("primitives")) {
            used.insert(primitive.value("material", -1));
            if (!primitive.contains(variants)) continue;
            for (const Json& mapping : primitive[variants])
                used.insert(mapping.value("material", -1));
        }
    return used;
}

const std::string& CarvedMaterial::recipe_of(const Key& key) const {
    const std::vector<ExportShare>& shares = content_.options.shares;
    return shares.empty() ? content_.options.recipe_name : shares[key.share].recipe_name;
}

/// The material for the primitives that had another; `in_place` says whether it replaces that.
Json CarvedMaterial::made_for(const Key& key, bool in_place) const {
    const std::vector<ExportShare>& shares = content_.options.shares;
    const GltfPlaces places{first_texture_, 0, 0, key.uv_set};
    Json made = shares.empty() ? gltf_material(content_, places)
                               : gltf_material(content_, shares[key.share], places);
    if (key.material < 0) return made;
    const Json& old = document_.json["materials"][std::size_t(key.material)];
    if (old.contains("name")) {
        const std::string name = old["name"];
        made["name"] = in_place ? name : name + ' ' + recipe_of(key);
    }
    made["doubleSided"] = old.value("doubleSided", false);
    if (old.contains("extras")) made["extras"] = old["extras"];
    return made;
}

void CarvedMaterial::assign() {
    const auto target = [&](const std::array<std::size_t, 2>& id) -> Json& {
        return document_.json["meshes"][id[0]]["primitives"][id[1]];
    };
    for (const auto& [key, primitives] : users_)
        for (const auto& id : primitives) target(id).erase("material");
    std::set<int> used = used_materials();
    for (const auto& [key, primitives] : users_) {
        const bool in_place = key.material >= 0 && used.insert(key.material).second;
        Json made = made_for(key, in_place);
        if (made.contains("extensions"))
            for (const auto& item : made["extensions"].items()) document_.use_extension(item.key());
        Json& materials = array_of(document_.json, "materials");
        const std::size_t number = in_place ? std::size_t(key.material) : materials.size();
        if (in_place)
            materials[number] = std::move(made);
        else
            materials.push_back(std::move(made));
        for (const auto& id : primitives) target(id)["material"] = number;
    }
}

}  // namespace burl
