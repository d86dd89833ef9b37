#include "app/scene/gltf_material.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace burl {

namespace {

constexpr const char* texture_transform = "KHR_texture_transform";

/// The extensions of which all that they say is drawn, or all but what read_maps() names.
constexpr std::array drawn_extensions{"KHR_materials_emissive_strength",
                                      "KHR_materials_ior",
                                      "KHR_materials_specular",
                                      "KHR_materials_clearcoat",
                                      "KHR_materials_sheen",
                                      "KHR_materials_transmission",
                                      "KHR_materials_unlit"};

/// A number within bounds; what is none is the low one.
float within(double number, double low, double high) {
    return float(number >= low ? std::min(number, high) : low);
}

constexpr double most_light = 1e6;  ///< beyond which a float16 picture could not say more

/// The members of an extension, each with its default where the file leaves it out.
class Extension {
  public:
    Extension(const tinygltf::Material& material, const char* name) {
        const auto found = material.extensions.find(std::string("KHR_materials_") + name);
        if (found != material.extensions.end() && found->second.IsObject()) value_ = &found->second;
    }

    double number(const char* name, double otherwise) const {
        const tinygltf::Value* value = member(name);
        return value && value->IsNumber() ? value->GetNumberAsDouble() : otherwise;
    }
    float share(const char* name, double otherwise) const {
        return within(number(name, otherwise), 0.0, 1.0);
    }
    /// A colour of shares within 0 to `most`.
    Vec3f color(const char* name, double otherwise, double most = 1.0) const {
        const tinygltf::Value* value = member(name);
        Vec3f result{float(otherwise)};
        if (!value || !value->IsArray() || value->ArrayLen() != 3) return result;
        for (int k = 0; k < 3; ++k)
            if (value->Get(k).IsNumber())
                result[k] = within(value->Get(k).GetNumberAsDouble(), 0.0, most);
        return result;
    }

  private:
    const tinygltf::Value* member(const char* name) const {
        return value_ && value_->Has(name) ? &value_->Get(name) : nullptr;
    }

    const tinygltf::Value* value_ = nullptr;
};

/// A reference to a texture.
struct TextureReference {
    int index = -1, uv_set = 0;
    bool is_moved = false;  ///< by KHR_texture_transform
};

TextureReference reference_of(const tinygltf::Value& value) {
    const auto number = [&](const char* name, int otherwise) {
        return value.Has(name) && value.Get(name).IsInt() ? value.Get(name).GetNumberAsInt()
                                                          : otherwise;
    };
    const bool extended = value.Has("extensions") && value.Get("extensions").IsObject();
    return {number("index", -1), number("texCoord", 0),
            extended && value.Get("extensions").Has(texture_transform)};
}

/// The reference of a core texture.
template <class Info>
TextureReference reference_of(const Info& info) {
    return {info.index, info.texCoord, info.extensions.contains(texture_transform)};
}

/// The reference in a place that begins with "/extensions/".
TextureReference extension_reference(const tinygltf::Material& material, std::string_view pointer) {
    pointer.remove_prefix(std::string_view("/extensions/").size());
    const std::size_t slash = pointer.find('/');
    const auto found = material.extensions.find(std::string(pointer.substr(0, slash)));
    const std::string name(pointer.substr(slash + 1));
    if (found == material.extensions.end() || !found->second.IsObject() || !found->second.Has(name))
        return {};
    return reference_of(found->second.Get(name));
}

TextureReference reference_of(const tinygltf::Material& material, const MaterialSlot& slot) {
    if (slot.map == MaterialMap::metallic_roughness)
        return reference_of(material.pbrMetallicRoughness.metallicRoughnessTexture);
    if (slot.map == MaterialMap::occlusion) return reference_of(material.occlusionTexture);
    if (slot.map == MaterialMap::emissive) return reference_of(material.emissiveTexture);
    return extension_reference(material, slot.pointer);
}

/// Notes once, after the material's name, what the picture lacks.
void note(const MaterialReading& reading, std::string_view what) {
    std::string sentence = fmt::format("{}: {}", reading.name, what);
    if (std::ranges::find(reading.notes, sentence) == reading.notes.end())
        reading.notes.push_back(std::move(sentence));
}

/// The reason why a texture cannot be drawn; empty where it can.
std::string_view problem_of(const TextureReference& texture, const MaterialReading& reading) {
    if (texture.is_moved) return "uses KHR_texture_transform";
    if (reading.uv_set < 0) return "lies on a surface without texture coordinates";
    if (texture.uv_set != reading.uv_set) return "has other texture coordinates than the colour";
    return reading.textures.has_picture(texture.index) ? ""
                                                       : "is no PNG, JPEG or WebP that is there";
}

void read_maps(const tinygltf::Material& source, const MaterialReading& reading,
               SceneMaterial& material) {
    for (const MaterialSlot& slot : material_slots) {
        const TextureReference texture = reference_of(source, slot);
        if (texture.index < 0) continue;
        const std::string_view name = slot.pointer.substr(slot.pointer.rfind('/') + 1);
        if (const std::string_view why = problem_of(texture, reading); !why.empty())
            note(reading, fmt::format("{} {}; drawn without", name, why));
        else
            material.maps[std::size_t(slot.map)] =
                reading.textures.load(texture.index, slot.is_color);
    }
}

void read_extensions(const tinygltf::Material& source, SceneMaterial& material) {
    // glTF allows 0 here, for a surface that reflects everything.
    const double ior = Extension(source, "ior").number("ior", 1.5);
    material.ior = ior == 0.0 ? 0.0f : within(ior, 1.0, 100.0);
    const Extension specular(source, "specular");
    material.specular = specular.share("specularFactor", 1.0);
    material.specular_color = specular.color("specularColorFactor", 1.0, 100.0);
    const Extension coat(source, "clearcoat");
    material.clearcoat = coat.share("clearcoatFactor", 0.0);
    material.clearcoat_roughness = coat.share("clearcoatRoughnessFactor", 0.0);
    const Extension sheen(source, "sheen");
    material.sheen = sheen.color("sheenColorFactor", 0.0);
    material.sheen_roughness = sheen.share("sheenRoughnessFactor", 0.0);
    material.transmission = Extension(source, "transmission").share("transmissionFactor", 0.0);
    material.unlit = source.extensions.contains("KHR_materials_unlit");
}

/// Names what a material has besides what is drawn.
void note_others(const tinygltf::Material& source, const MaterialReading& reading) {
    for (const auto& [name, value] : source.extensions)
        if (std::ranges::find(drawn_extensions, name) == drawn_extensions.end())
            note(reading, name + " is not drawn");
    const auto coat = source.extensions.find("KHR_materials_clearcoat");
    if (coat != source.extensions.end() && coat->second.IsObject() &&
        coat->second.Has("clearcoatNormalTexture"))
        note(reading, "clearcoatNormalTexture is not drawn");
}

}  // namespace

void read_gltf_material(const tinygltf::Material& source, const MaterialReading& reading,
                        SceneMaterial& material) {
    const auto& core = source.pbrMetallicRoughness;
    material.metallic = within(core.metallicFactor, 0.0, 1.0);
    material.roughness = within(core.roughnessFactor, 0.0, 1.0);
    material.occlusion_strength = within(source.occlusionTexture.strength, 0.0, 1.0);
    const double strength = Extension(source, "emissive_strength").number("emissiveStrength", 1.0);
    for (std::size_t k = 0; k < 3 && source.emissiveFactor.size() == 3; ++k)
        material.emissive[int(k)] = within(source.emissiveFactor[k] * strength, 0.0, most_light);
    read_extensions(source, material);
    read_maps(source, reading, material);
    note_others(source, reading);
}

}  // namespace burl
