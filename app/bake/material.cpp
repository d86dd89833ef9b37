#include "app/bake/material.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "app/bake/shared_pictures.h"
#include "app/image/exr_layers.h"
#include "app/pipeline/tasks.h"
#include "atlas/base/error.h"
#include "atlas/build/alpha_levels.h"
#include "atlas/build/block_levels.h"
#include "atlas/build/normal_levels.h"

namespace burl {

namespace {

template <class Code>
Image<Rgb<Code>> without_alpha(const Image<Rgba<Code>>& image) {
    return converted<Rgb<Code>>(image, [](const Rgba<Code>& p) {
        return Rgb<Code>{p.r, p.g, p.b};
    });
}

/// The picture with as many components as it has.
template <class Code>
PictureImage packed(Image<Rgba<Code>> image, std::size_t components) {
    if (components == 4) return image;
    if (components == 3) return without_alpha(image);
    return converted<Code>(image, [](const Rgba<Code>& p) { return p.r; });
}

/// The recipes that share the pipeline's atlas: its own where none are given.
std::span<const Recipe> all_of(const Pipeline& pipeline, std::span<const Recipe> recipes) {
    return recipes.empty() ? std::span(&pipeline.recipe(), 1) : recipes;
}

template <class Code>
BakedMaterial bake(Pipeline& pipeline, const MaterialAsked& asked, std::span<const Recipe> recipes,
                   const std::vector<MaterialPicture>& wanted) {
    std::vector<Image<Rgba<Code>>> images =
        shared_pictures<Rgba<Code>>(pipeline, recipes, wanted, asked.packing, asked.rough_levels());
    BakedMaterial material;
    if (any_transparent(recipes))
        material.color = std::move(images[0]);
    else
        material.color = without_alpha(images[0]);
    for (std::size_t i = 0; i < wanted.size(); ++i)
        material.pictures.push_back({wanted[i].name,
                                     packed(std::move(images[i + 1]), wanted[i].components),
                                     {},
                                     wanted[i].plan.is_color,
                                     wanted[i].slots});
    return material;
}

/// A picture in linear floats, with its MIP levels behind it.
using FloatLevels = std::vector<Image<RgbaF>>;

/// The component `c` of a pixel.
template <class Pixel>
auto& component(Pixel& pixel, std::size_t c) {
    return c == 0 ? pixel.r : c == 1 ? pixel.g : c == 2 ? pixel.b : pixel.a;
}

/// Sets the roughness in a picture's levels to that of the normals' levels; `sign` and `offset` say
/// what the picture holds: offset + sign * roughness.
void set_roughness(FloatLevels& levels, const std::vector<NormalLevel>& normals, std::size_t c,
                   float sign, float offset) {
    for (std::size_t l = 1; l < levels.size() && l <= normals.size(); ++l) {
        const Image<float>& roughness = normals[l - 1].roughness;
        for (std::size_t y = 0; y < roughness.height(); ++y)
            for (std::size_t x = 0; x < roughness.width(); ++x)
                component(levels[l](x, y), c) = offset + sign * roughness(x, y);
    }
}

/// The levels of the normal map with the roughness of a picture, which gets theirs.
std::vector<NormalLevel> levels_with_normals(Pipeline& pipeline, const MaterialAsked& asked,
                                             std::span<const Recipe> recipes,
                                             const MaterialPicture& picture, FloatLevels& levels) {
    const std::size_t c = *picture.roughness;
    const float sign = std::signbit(picture.plan.components[c].factor) ? -1.0f : 1.0f;
    const auto offset = float(picture.plan.components[c].offset);
    const auto roughness = converted<float>(
        levels[0], [&](const RgbaF& pixel) { return sign * (component(pixel, c) - offset); });
    const Image<RgbF> map = shared_normals<RgbF>(pipeline, recipes, asked.crease_degrees, true);
    std::vector<NormalLevel> normals =
        normal_levels(pipeline.mesh_atlas(), map, roughness, asked.levels);
    set_roughness(levels, normals, c, sign, offset);
    return normals;
}

/// All pictures, the base colour first, in linear floats with their levels, and those of the
/// normal map.
struct FloatMaterial {
    std::vector<FloatLevels> pictures{};
    std::vector<Image<RgbF>> normals{};
};

FloatMaterial float_material(Pipeline& pipeline, const MaterialAsked& asked,
                             std::span<const Recipe> recipes,
                             const std::vector<MaterialPicture>& wanted) {
    std::vector<Image<RgbaF>> images =
        shared_pictures<RgbaF>(pipeline, recipes, wanted, asked.packing, asked.rough_levels());
    const std::optional<double> cutoff = mask_cutoff(recipes);
    pipeline.context().begin(tasks::levels);
    FloatMaterial material;
    for (std::size_t i = 0; i < images.size(); ++i) {
        FloatLevels means =
            i == 0 && cutoff
                ? masked_levels(pipeline.mesh_atlas(), images[i], float(*cutoff), asked.levels)
                : block_levels(pipeline.mesh_atlas(), images[i], asked.levels);
        FloatLevels& levels = material.pictures.emplace_back();
        levels.push_back(std::move(images[i]));
        std::ranges::move(means, std::back_inserter(levels));
        if (i == 0 || !asked.rough_levels() || !wanted[i - 1].roughness) continue;
        for (NormalLevel& level :
             levels_with_normals(pipeline, asked, recipes, wanted[i - 1], levels))
            material.normals.push_back(std::move(level.normals));
    }
    return material;
}

/// A level of a picture in codes.
template <class Code>
Image<Rgba<Code>> coded(const Image<RgbaF>& level, bool is_color) {
    if constexpr (sizeof(Code) == 1)
        return is_color ? to_rgba8(level, mean_color(level)) : to_linear8(level);
    else
        return is_color ? to_rgba16(level, mean_color(level)) : to_linear16(level);
}

template <class Code>
BakedMaterial bake_levels(Pipeline& pipeline, const MaterialAsked& asked,
                          std::span<const Recipe> recipes,
                          const std::vector<MaterialPicture>& wanted) {
    const bool transparent = any_transparent(recipes);
    FloatMaterial floats = float_material(pipeline, asked, recipes, wanted);
    BakedMaterial material;
    for (const Image<RgbaF>& level : floats.pictures[0]) {
        Image<Rgba<Code>> codes = coded<Code>(level, true);
        BakedImage image =
            transparent ? BakedImage(std::move(codes)) : BakedImage(without_alpha(codes));
        if (&level == floats.pictures[0].data())
            material.color = std::move(image);
        else
            material.color_levels.push_back(std::move(image));
    }
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        ExportPicture picture{wanted[i].name, {}, {}, wanted[i].plan.is_color, wanted[i].slots};
        for (const Image<RgbaF>& level : floats.pictures[i + 1])
            picture.levels.push_back(
                packed(coded<Code>(level, wanted[i].plan.is_color), wanted[i].components));
        picture.image = std::move(picture.levels.front());
        picture.levels.erase(picture.levels.begin());
        material.pictures.push_back(std::move(picture));
    }
    material.normal_levels = std::move(floats.normals);
    return material;
}

}  // namespace

Packing packing_asked(const std::string& text, const std::string& out_path) {
    const bool gltf = is_gltf(out_path);
    if (text.empty()) return gltf ? Packing::gltf : Packing::separate;
    if (is_materialx(out_path))
        throw Error(ExitCode::usage,
                    fmt::format("{}: --pack {}: a MaterialX document names one picture per "
                                "channel; leave --pack out",
                                out_path, text));
    const Packing packing = *enum_named<Packing>(text);
    if (gltf && packing != Packing::gltf)
        throw Error(ExitCode::usage,
                    fmt::format("{}: --pack {}: a glTF has an order of its own; leave --pack out, "
                                "or write .png or .obj",
                                out_path, text));
    return packing;
}

std::vector<std::string> picture_names(std::span<const Recipe> recipes,
                                       const MaterialAsked& asked) {
    std::vector<std::string> names;
    for (const MaterialPicture& one :
         shared_material_pictures(recipes, asked.packing, asked.rough_levels()))
        names.push_back(one.name);
    return names;
}

BakedMaterial bake_material(Pipeline& pipeline, const MaterialAsked& asked,
                            std::span<const Recipe> recipes) {
    const std::span<const Recipe> all = all_of(pipeline, recipes);
    for (const Recipe& recipe : all) check_material(recipe, asked, "");
    const std::vector<MaterialPicture> wanted =
        shared_material_pictures(all, asked.packing, asked.rough_levels());
    if (asked.levels > 0)
        return asked.depth == 16 ? bake_levels<std::uint16_t>(pipeline, asked, all, wanted)
                                 : bake_levels<std::uint8_t>(pipeline, asked, all, wanted);
    return asked.depth == 16 ? bake<std::uint16_t>(pipeline, asked, all, wanted)
                             : bake<std::uint8_t>(pipeline, asked, all, wanted);
}

AtomicFile write_material_exr(Pipeline& pipeline, const std::string& path,
                              const MaterialAsked& asked, ExrDepth depth) {
    const Recipe& recipe = pipeline.recipe();
    check_material(recipe, asked, "");
    MaterialAsked separate = asked;
    separate.packing = Packing::separate;
    const std::vector<MaterialPicture> wanted =
        material_pictures(recipe, separate.packing, separate.rough_levels());
    const FloatMaterial floats = float_material(pipeline, separate, all_of(pipeline, {}), wanted);
    std::deque<Image<RgbF>> colors;
    std::deque<Image<float>> numbers;
    std::vector<ExrLayer> layers(floats.pictures.size());
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const bool alpha = i == 0 && is_transparent(recipe);
        const bool number = i > 0 && wanted[i - 1].components == 1;
        if (i > 0) layers[i].name = wanted[i - 1].name;
        layers[i].channels = alpha ? "RGBA" : number ? "Y" : "RGB";
        for (const Image<RgbaF>& level : floats.pictures[i]) {
            if (alpha)
                layers[i].levels.push_back(&level);
            else if (number)
                layers[i].levels.push_back(&numbers.emplace_back(
                    converted<float>(level, [](const RgbaF& p) { return p.r; })));
            else
                layers[i].levels.push_back(
                    &colors.emplace_back(converted<RgbF>(level, [](const RgbaF& p) {
                        return RgbF{p.r, p.g, p.b};
                    })));
        }
    }
    std::uint64_t texels = 0;
    for (const Image<RgbaF>& level : floats.pictures[0]) texels += level.pixels().size();
    pipeline.context().begin(tasks::write, texels);
    return write_exr_layers(path, layers, depth, pipeline.context().meter);
}

std::string numbers_in_no_picture(const Recipe& recipe, Packing packing) {
    const PlaneLayout planes(recipe.texture);
    const bool packs = packing != Packing::separate;
    std::string all;
    for (std::size_t i = 0; i < enum_names<Channel>.size(); ++i) {
        const auto channel = Channel(i);
        const bool shared = channel == Channel::occlusion || channel == Channel::roughness ||
                            channel == Channel::metallic;
        if (planes.of(channel) || is_color(channel) || channel == Channel::opacity) continue;
        const double number = channel_number(recipe.material, channel);
        if ((packs && shared) || number == channel_number({}, channel)) continue;
        all += fmt::format("{}{} {}", all.empty() ? "" : ", ", to_string(channel), number);
    }
    return all;
}

void check_material(const Recipe& recipe, const MaterialAsked& asked, const std::string& what) {
    if (is_transparent(recipe) && has_color_paint(recipe.paint))
        throw Error(ExitCode::usage,
                    "the recipe paints over a transparent texture, which is not done yet; add "
                    "--set material.alpha=opaque, or take the paint out");
    if (what.empty() || !has_pictures(recipe, asked.packing, asked.rough_levels())) return;
    const std::string channel =
        is_transparent(recipe)
            ? "opacity"
            : material_pictures(recipe, asked.packing, asked.rough_levels()).front().name;
    throw Error(ExitCode::usage,
                fmt::format("{}: the recipe's material varies in more than colour ({}), for which "
                            "this is not done yet; leave it out",
                            what, channel));
}

}  // namespace burl
