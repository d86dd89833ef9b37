#include "app/pipeline/material.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

#include "procedural/fill/tangent_frame.h"

namespace burl {

namespace {

/// The members of the channels that are numbers.
constexpr std::array<std::pair<Channel, double Material::*>, 9> number_members{
    {{Channel::opacity, &Material::opacity},
     {Channel::metallic, &Material::metallic},
     {Channel::roughness, &Material::roughness},
     {Channel::occlusion, &Material::occlusion},
     {Channel::specular, &Material::specular},
     {Channel::clearcoat, &Material::clearcoat},
     {Channel::clearcoat_roughness, &Material::clearcoat_roughness},
     {Channel::sheen_roughness, &Material::sheen_roughness},
     {Channel::transmission, &Material::transmission}}};

/// Makes plans of a recipe's channels.
class Planner {
  public:
    Planner(const Recipe& recipe, bool factors, bool rough_levels)
        : material_(recipe.material),
          planes_(recipe.texture),
          factors_(factors),
          rough_levels_(rough_levels) {}

    bool varies(Channel channel) const {
        if (channel == Channel::roughness && rough_levels_) return true;
        return planes_.of(channel).has_value();
    }
    bool any_varies(std::initializer_list<Channel> channels) const {
        return std::ranges::any_of(channels, [&](Channel c) { return varies(c); });
    }
    /// The component of a number: its plane, or one value, which is 1 where a factor of the
    /// material says it. Occlusion has no factor in glTF.
    PictureComponent number(Channel channel) const {
        if (const auto plane = planes_.of(channel)) return {1.0, plane};
        const bool factor = factors_ && channel != Channel::occlusion && !varies(channel);
        return {factor ? 1.0 : channel_number(material_, channel)};
    }
    bool is_occluded() const { return varies(Channel::occlusion) || material_.occlusion != 1.0; }
    static PictureComponent one() { return {1.0}; }
    static PictureComponent none() { return {0.0}; }

    /// A picture of a colour.
    PicturePlan color(Channel channel) const {
        const std::size_t first = *planes_.of(channel);
        return {{{{1.0, first}, {1.0, first + 1}, {1.0, first + 2}, one()}}, true};
    }
    PicturePlan data(const PictureComponent& r, const PictureComponent& g,
                     const PictureComponent& b, const PictureComponent& a = one()) const {
        return {{r, g, b, a}, false};
    }

  private:
    const Material& material_;
    PlaneLayout planes_;
    bool factors_, rough_levels_;
};

/// glTF's occlusion, roughness and metallic.
MaterialPicture orm(const Planner& plan) {
    MaterialPicture picture{
        "orm", plan.data(plan.number(Channel::occlusion), plan.number(Channel::roughness),
                         plan.number(Channel::metallic))};
    picture.roughness = 1;
    if (plan.any_varies({Channel::roughness, Channel::metallic}))
        picture.slots.emplace_back("/pbrMetallicRoughness/metallicRoughnessTexture");
    if (plan.is_occluded()) picture.slots.emplace_back("/occlusionTexture");
    return picture;
}

/// Unity's mask map: metallic, occlusion, detail, smoothness.
MaterialPicture mask_map(const Planner& plan) {
    PictureComponent smooth = plan.number(Channel::roughness);
    smooth.factor = -smooth.factor;
    smooth.offset = 1.0;
    MaterialPicture picture{"mask",
                            plan.data(plan.number(Channel::metallic),
                                      plan.number(Channel::occlusion), Planner::none(), smooth),
                            4};
    picture.roughness = 3;
    return picture;
}

/// The channels that no packing but glTF's has a place for, in pictures of their own.
void add_extensions(const Planner& plan, std::vector<MaterialPicture>& pictures) {
    const std::string extension = "/extensions/KHR_materials_";
    if (plan.any_varies({Channel::clearcoat, Channel::clearcoat_roughness})) {
        MaterialPicture& coat = pictures.emplace_back(MaterialPicture{
            "clearcoat", plan.data(plan.number(Channel::clearcoat),
                                   plan.number(Channel::clearcoat_roughness), Planner::none())});
        if (plan.varies(Channel::clearcoat))
            coat.slots.push_back(extension + "clearcoat/clearcoatTexture");
        if (plan.varies(Channel::clearcoat_roughness))
            coat.slots.push_back(extension + "clearcoat/clearcoatRoughnessTexture");
    }
    if (plan.varies(Channel::sheen))
        pictures.push_back(
            {"sheen", plan.color(Channel::sheen), 3, {extension + "sheen/sheenColorTexture"}});
    const auto in_alpha = [&](Channel channel, const char* slot) {
        if (!plan.varies(channel)) return;
        pictures.push_back(
            {std::string(to_string(channel)),
             plan.data(Planner::one(), Planner::one(), Planner::one(), plan.number(channel)),
             4,
             {extension + slot}});
    };
    in_alpha(Channel::sheen_roughness, "sheen/sheenRoughnessTexture");
    in_alpha(Channel::specular, "specular/specularTexture");
    if (plan.varies(Channel::transmission)) {
        const PictureComponent through = plan.number(Channel::transmission);
        pictures.push_back({"transmission",
                            plan.data(through, through, through),
                            3,
                            {extension + "transmission/transmissionTexture"}});
    }
}

/// One grey picture per number that varies.
void add_separate(const Planner& plan, std::vector<MaterialPicture>& pictures) {
    for (std::size_t i = 0; i < enum_names<Channel>.size(); ++i) {
        const auto channel = Channel(i);
        if (channel == Channel::opacity || !plan.varies(channel)) continue;
        const std::string name(to_string(channel));
        if (is_color(channel)) {
            pictures.push_back({name, plan.color(channel)});
            continue;
        }
        const PictureComponent number = plan.number(channel);
        pictures.push_back({name, plan.data(number, number, number), 1});
        if (channel == Channel::roughness) pictures.back().roughness = 0;
    }
}

template <class Code>
Image<Rgb<Code>> normal_codes(const Image<RgbF>& normals) {
    return converted<Rgb<Code>>(normals, [](const RgbF& n) {
        return encode_normal<Code>({double(n.r), double(n.g), double(n.b)});
    });
}

}  // namespace

Image<Rgb8> normal_codes8(const Image<RgbF>& normals) {
    return normal_codes<std::uint8_t>(normals);
}

Image<Rgb16> normal_codes16(const Image<RgbF>& normals) {
    return normal_codes<std::uint16_t>(normals);
}

double channel_number(const Material& material, Channel channel) {
    for (const auto& [known, member] : number_members)
        if (known == channel) return material.*member;
    return 1.0;
}

bool is_transparent(const Recipe& recipe) {
    if (recipe.material.alpha == AlphaMode::opaque) return false;
    if (recipe.material.opacity < 1.0) return true;
    const auto is_opacity = [](const GraphChannel& one) { return one.channel == Channel::opacity; };
    return std::ranges::any_of(recipe.texture.channels, is_opacity) ||
           !is_opaque(recipe.texture, recipe.texture.result);
}

bool has_pictures(const Recipe& recipe, Packing packing, bool rough_levels) {
    return is_transparent(recipe) || !material_pictures(recipe, packing, rough_levels).empty();
}

Material material_factors(const Recipe& recipe, bool rough_levels) {
    Material m = recipe.material;
    if (rough_levels) m.roughness = 1.0;
    const PlaneLayout planes(recipe.texture);
    for (const auto& [channel, number] : number_members)
        if (planes.of(channel)) m.*number = 1.0;
    if (planes.of(Channel::emissive)) m.emissive = {255, 255, 255};
    if (planes.of(Channel::sheen)) m.sheen = {255, 255, 255};
    return m;
}

PicturePlan base_color_plan(const Recipe& recipe) {
    const PlaneLayout planes(recipe.texture);
    PicturePlan plan;
    for (std::size_t c = 0; c < 3; ++c) plan.components[c] = {1.0, c};
    if (!is_transparent(recipe)) return plan;
    plan.components[3] = {recipe.material.opacity, planes.alpha(), planes.of(Channel::opacity)};
    plan.alpha = planes.alpha();
    return plan;
}

std::vector<MaterialPicture> material_pictures(const Recipe& recipe, Packing packing,
                                               bool rough_levels) {
    const Planner plan(recipe, packing == Packing::gltf, rough_levels);
    std::vector<MaterialPicture> pictures;
    if (packing == Packing::separate) {
        add_separate(plan, pictures);
        return pictures;
    }
    const bool varies =
        plan.is_occluded() || plan.any_varies({Channel::roughness, Channel::metallic});
    if (packing == Packing::unity)
        pictures.push_back(mask_map(plan));
    else if (varies || packing != Packing::gltf)
        pictures.push_back(orm(plan));
    if (plan.varies(Channel::emissive))
        pictures.push_back({"emissive", plan.color(Channel::emissive), 3, {"/emissiveTexture"}});
    add_extensions(plan, pictures);
    return pictures;
}

}  // namespace burl
