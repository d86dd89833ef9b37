#include "app/bake/material.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "app/bake/material_bands.h"
#include "app/bake/shared_pictures.h"
#include "app/image/exr_layers.h"
#include "app/pipeline/tasks.h"
#include "atlas/base/error.h"
#include "atlas/build/alpha_levels.h"

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

/// The numbers of components of the base colour and of the pictures.
std::vector<std::size_t> components_of(bool transparent,
                                       const std::vector<MaterialPicture>& wanted) {
    std::vector<std::size_t> all{transparent ? std::size_t(4) : std::size_t(3)};
    for (const MaterialPicture& one : wanted) all.push_back(one.components);
    return all;
}

/// The codes of a colour.
BakedImage color_image(PictureImage codes) {
    return std::visit(
        []<class Pixel>(Image<Pixel>& image) -> BakedImage {
            if constexpr (std::is_constructible_v<BakedImage, Image<Pixel>>)
                return std::move(image);
            else
                return {};
        },
        codes);
}

/// A material of these codes, the base colour's first, without levels.
BakedMaterial material_of(std::vector<PictureImage> codes,
                          const std::vector<MaterialPicture>& wanted) {
    BakedMaterial material;
    material.color = color_image(std::move(codes[0]));
    for (std::size_t i = 0; i < wanted.size(); ++i)
        material.pictures.push_back({wanted[i].name,
                                     std::move(codes[i + 1]),
                                     {},
                                     wanted[i].plan.is_color,
                                     wanted[i].slots});
    return material;
}

template <class Code>
BakedMaterial bake(Pipeline& pipeline, const MaterialAsked& asked, std::span<const Recipe> recipes,
                   const std::vector<MaterialPicture>& wanted) {
    const std::size_t size = pipeline.recipe().atlas.size;
    const std::vector<std::size_t> components = components_of(any_transparent(recipes), wanted);
    std::vector<PictureImage> codes(components.size());
    const auto take = [&](std::size_t first, std::vector<Image<Rgba<Code>>> rows) {
        for (std::size_t i = 0; i < rows.size(); ++i)
            put_rows(packed(std::move(rows[i]), components[i]), first, size, codes[i]);
    };
    shared_pictures_in_bands<Rgba<Code>>(pipeline, recipes, wanted, asked.packing,
                                         asked.rough_levels(), rows_of_bands(size, codes.size()),
                                         take);
    return material_of(std::move(codes), wanted);
}

/// Takes the rows, from row `first` on, of all pictures.
using TakeFloats = std::function<void(std::size_t first, const std::vector<FloatPicture>& rows)>;

/// The pictures of a material, the base colour first, in linear floats: level 0 goes by in bands,
/// and what the levels above it are made of is kept.
class FloatMaterial {
  public:
    /// All must outlive the object.
    FloatMaterial(Pipeline& pipeline, const MaterialAsked& asked, std::span<const Recipe> recipes,
                  const std::vector<MaterialPicture>& wanted)
        : pipeline_(pipeline),
          asked_(asked),
          recipes_(recipes),
          wanted_(wanted),
          size_(pipeline.recipe().atlas.size),
          components_(components_of(any_transparent(recipes), wanted)),
          cutoff_(asked.levels > 0 ? mask_cutoff(recipes) : std::nullopt),
          levels_(components_.size(), LevelRows(pipeline.mesh_atlas(), asked.levels)) {
        for (std::size_t i = 0; asked.sharp && i < count(); ++i)
            if (is_color(i)) levels_[i].sharpen();
    }

    std::size_t count() const { return components_.size(); }
    std::size_t components(std::size_t i) const { return components_[i]; }
    bool is_color(std::size_t i) const { return i == 0 || wanted_[i - 1].plan.is_color; }

    /// Gives level 0 to `take`.
    void run(const TakeFloats& take) {
        shared_pictures_in_bands<RgbaF>(pipeline_, recipes_, wanted_, asked_.packing,
                                        asked_.rough_levels(), rows_of_bands(size_, count()),
                                        [&](std::size_t first, std::vector<Image<RgbaF>> rows) {
                                            take(first, kept(first, std::move(rows)));
                                        });
        pipeline_.context().begin(tasks::levels);
    }

    /// The levels of picture i, once; run() comes first.
    std::vector<FloatPicture> levels(std::size_t i) {
        std::vector<FloatPicture> levels = levels_[i].levels();
        if (i == 0 && cutoff_) scale(levels);
        if (i > 0 && is_rough(i)) make_rough(wanted_[i - 1], levels);
        return levels;
    }

    /// The levels of the normal map, once; levels() of all pictures come first.
    std::vector<Image<RgbF>> normals() { return std::move(normals_); }

  private:
    bool is_rough(std::size_t i) const {
        return asked_.rough_levels() && wanted_[i - 1].roughness.has_value();
    }

    /// Keeps of the rows what levels need.
    std::vector<FloatPicture> kept(std::size_t first, std::vector<Image<RgbaF>> rows) {
        std::vector<FloatPicture> all;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const Image<RgbaF> band = std::move(rows[i]);
            if (i == 0 && cutoff_) put_rows(component_of(band, 3), first, size_, opacity_);
            if (i > 0 && is_rough(i))
                put_rows(component_of(band, *wanted_[i - 1].roughness), first, size_, rough_);
            all.push_back(float_picture(band, components_[i]));
            if (asked_.levels > 0) levels_[i].add(first, all.back());
        }
        return all;
    }

    /// Gives the levels of a mask as much as level 0 shows.
    void scale(std::vector<FloatPicture>& levels) {
        std::vector<Image<RgbaF>> masks;
        for (FloatPicture& level : levels)
            masks.push_back(std::get<Image<RgbaF>>(std::move(level)));
        scale_masks(pipeline_.mesh_atlas(), opacity_, float(*cutoff_), masks);
        opacity_ = {};
        std::ranges::move(masks, levels.begin());
    }

    /// Makes the levels of the normal map with the roughness of a picture, which gets theirs.
    void make_rough(const MaterialPicture& picture, std::vector<FloatPicture>& levels) {
        const PictureComponent& plan = picture.plan.components[*picture.roughness];
        const float sign = std::signbit(plan.factor) ? -1.0f : 1.0f;
        const auto offset = float(plan.offset);
        NormalRows rows(pipeline_.mesh_atlas(), asked_.levels);
        const auto take = [&](std::size_t first, const Image<RgbF>& normals) {
            auto roughness = Image<float>::unset(normals.width(), normals.height());
            for (std::size_t y = 0; y < normals.height(); ++y)
                std::ranges::transform(rough_.row(first + y), roughness.row(y).begin(),
                                       [&](float value) { return sign * (value - offset); });
            rows.add(first, normals, roughness);
        };
        shared_normals_in_bands(pipeline_, recipes_, asked_.crease_degrees, true,
                                rows_of_bands(size_, 1), take);
        rough_ = {};
        std::vector<NormalLevel> made = rows.levels();
        set_roughness(levels, made, *picture.roughness, sign, offset);
        for (NormalLevel& level : made) normals_.push_back(std::move(level.normals));
    }

    Pipeline& pipeline_;
    const MaterialAsked& asked_;
    std::span<const Recipe> recipes_;
    const std::vector<MaterialPicture>& wanted_;
    std::size_t size_;
    std::vector<std::size_t> components_;
    std::optional<double> cutoff_;
    std::vector<LevelRows> levels_;
    Image<float> opacity_{},
        rough_{};  ///< level 0 of a mask's opacity, and of what holds the roughness
    std::vector<Image<RgbF>> normals_{};
};

template <class Code>
BakedMaterial bake_levels(Pipeline& pipeline, const MaterialAsked& asked,
                          std::span<const Recipe> recipes,
                          const std::vector<MaterialPicture>& wanted) {
    const bool transparent = any_transparent(recipes);
    const std::size_t size = pipeline.recipe().atlas.size;
    FloatMaterial floats(pipeline, asked, recipes, wanted);
    std::vector<PictureImage> codes(floats.count());
    ClearTexels clear(transparent ? size : 0);
    floats.run([&](std::size_t first, const std::vector<FloatPicture>& rows) {
        for (std::size_t i = 0; i < rows.size(); ++i)
            put_rows(picture_codes<Code>(rows[i], floats.is_color(i)), first, size, codes[i]);
        if (transparent) clear.add(first, std::get<Image<RgbaF>>(rows[0]));
    });
    if (transparent) clear.fill(std::get<Image<Rgba<Code>>>(codes[0]));
    BakedMaterial material = material_of(std::move(codes), wanted);
    for (const FloatPicture& level : floats.levels(0))
        material.color_levels.push_back(color_image(picture_codes<Code>(level, true)));
    for (std::size_t i = 1; i < floats.count(); ++i)
        for (const FloatPicture& level : floats.levels(i))
            material.pictures[i - 1].levels.push_back(
                picture_codes<Code>(level, floats.is_color(i)));
    material.normal_levels = floats.normals();
    return material;
}

/// The layers of the pictures of a material, the base colour's first, without levels.
std::vector<ExrLayer> layers_of(const FloatMaterial& floats,
                                const std::vector<MaterialPicture>& wanted) {
    std::vector<ExrLayer> layers(floats.count());
    for (std::size_t i = 0; i < layers.size(); ++i) {
        if (i > 0) layers[i].name = wanted[i - 1].name;
        layers[i].channels = floats.components(i) == 4   ? "RGBA"
                             : floats.components(i) == 1 ? "Y"
                                                         : "RGB";
    }
    return layers;
}

/// References to images, as a file of layers takes them.
std::vector<FloatImage> float_images(const std::vector<FloatPicture>& pictures) {
    std::vector<FloatImage> images;
    for (const FloatPicture& picture : pictures)
        std::visit([&](const auto& image) { images.emplace_back(&image); }, picture);
    return images;
}

/// The channel's value where it does not vary, in words of recipes.
std::string value_of(const Material& material, Channel channel) {
    const auto text = [](const Rgb8& c) {
        return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b);
    };
    if (channel == Channel::emissive) return text(material.emissive);
    if (channel == Channel::sheen) return text(material.sheen);
    return fmt::format("{}", channel_number(material, channel));
}

/// Whether one of the pictures, whose names these are, holds a channel that does not vary. Alpha
/// of the base colour holds the opacity.
bool is_in_pictures(Channel channel, std::span<const std::string> pictures, Packing packing) {
    const auto has = [&](std::string_view name) {
        return std::ranges::find(pictures, name) != pictures.end();
    };
    if (channel == Channel::opacity || has(to_string(channel))) return true;
    if (channel == Channel::clearcoat_roughness && packing != Packing::separate)
        return has("clearcoat");
    const bool of_surface = channel == Channel::occlusion || channel == Channel::roughness ||
                            channel == Channel::metallic;
    return of_surface && (has("orm") || has("mask"));
}

/// Whether the library of an .obj has a line for the channel where it does not vary.
bool is_in_mtl(Channel channel) {
    using enum Channel;
    return channel == metallic || channel == roughness || channel == emissive ||
           channel == specular || channel == clearcoat || channel == clearcoat_roughness;
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
    FloatMaterial floats(pipeline, separate, all_of(pipeline, {}), wanted);
    const std::size_t size = recipe.atlas.size;
    std::vector<std::vector<FloatPicture>> levels(floats.count());
    const auto source = [&](const LayerRowSink& sink) {
        floats.run(
            [&](std::size_t, const std::vector<FloatPicture>& rows) { sink(float_images(rows)); });
        std::vector<std::vector<FloatImage>> images;
        for (std::size_t i = 0; asked.levels > 0 && i < floats.count(); ++i) {
            levels[i] = floats.levels(i);
            images.push_back(float_images(levels[i]));
        }
        pipeline.context().begin(tasks::write, size * size / 3);
        return images;
    };
    return write_exr_layers(path, size, layers_of(floats, wanted), source, asked.levels > 0, depth,
                            pipeline.context().meter);
}

std::string values_not_held(const Recipe& recipe, std::span<const std::string> pictures,
                            Packing packing, const std::string& out_path) {
    if (is_gltf(out_path) || is_materialx(out_path)) return {};  // hold all
    if (holds_mesh(out_path) && !holds_colors(out_path)) return {};
    const Material& m = recipe.material;
    const PlaneLayout planes(recipe.texture);
    const bool mtl = is_obj(out_path);
    std::vector<std::string> values;
    for (std::size_t i = 0; i < enum_names<Channel>.size(); ++i) {
        const auto channel = Channel(i);
        const bool held = planes.of(channel) || is_in_pictures(channel, pictures, packing) ||
                          (mtl && is_in_mtl(channel));
        if (!held && value_of(m, channel) != value_of({}, channel))
            values.push_back(fmt::format("{} {}", to_string(channel), value_of(m, channel)));
    }
    if (!mtl && m.ior != Material().ior) values.push_back(fmt::format("ior {}", m.ior));
    const bool glows = planes.of(Channel::emissive) || m.emissive != Rgb8{};
    if (!mtl && glows && m.emissive_strength != 1.0)
        values.push_back(fmt::format("emissive_strength {}", m.emissive_strength));
    if (values.empty()) return {};
    return fmt::format("nothing in it or beside it holds what is the same everywhere: {}",
                       fmt::join(values, ", "));
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
