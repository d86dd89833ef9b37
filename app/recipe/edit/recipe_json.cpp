#include "app/recipe/edit/recipe_json.h"

#include <algorithm>
#include <bit>
#include <filesystem>
#include <memory>
#include <set>
#include <utility>

#include "app/image/picture_read.h"
#include "app/recipe/edit/apply.h"
#include "app/recipe/edit/check.h"
#include "app/recipe/edit/images.h"
#include "app/recipe/presets.h"
#include "app/recipe/spelling.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "atlas/base/real_path.h"
#include "procedural/graph/json.h"
#include "procedural/model/members.h"

namespace burl {

namespace {

/// Adds up the sizes that one recipe's images declare, before any is decoded.
class DeclaredImages {
  public:
    explicit DeclaredImages(const ImageLimits& limits) : limits_(limits) {}
    /// Throws Error(invalid_file) for what is too large, by itself or with those before it.
    void add(const std::string& path, ImageWrap wrap) {
        if (!seen_.insert({real_path(path), wrap}).second) return;
        const PngSize size = picture_size(path);
        if (std::max(size.width, size.height) > limits_.side)
            throw invalid_file(path, 0,
                               fmt::format("the image has {} x {} pixels; textures take at most {} "
                                           "a side, so scale it down or raise --max-image",
                                           size.width, size.height, limits_.side));
        texels_ += std::uint64_t{std::bit_ceil(size.width)} * std::bit_ceil(size.height);
        if (texels_ > limits_.texels())
            throw invalid_file(path, 0,
                               fmt::format("with this image the recipe's images have {} pixels "
                                           "together, their sides rounded up to powers of two, but "
                                           "{} is the most; scale some of them down",
                                           texels_, limits_.texels()));
    }

  private:
    const ImageLimits& limits_;
    std::set<std::pair<std::string, ImageWrap>> seen_;
    std::uint64_t texels_ = 0;
};

/// In the place of an image that is not looked at.
std::shared_ptr<const MipImage> blank_image(ImageWrap wrap) {
    return std::make_shared<const MipImage>(Image<Rgb8>(1, 1), wrap);
}

KeyedAnimation animation_from_json(const Json& json) {
    KeyedAnimation animation;
    read_members(parameters(), json, animation);
    const Json& tracks = part_of(json, "tracks");
    read_list(parameters(), tracks, animation.tracks);
    for (std::size_t i = 0; i < tracks.size(); ++i)
        read_list(parameters(), tracks[i]["keys"], animation.tracks[i].keys);
    return animation;
}

Json animation_to_json(const KeyedAnimation& animation) {
    Json json;
    write_members(parameters(), animation, json);
    Json& tracks = json["tracks"] = list_json(parameters(), animation.tracks);
    for (std::size_t i = 0; i < tracks.size(); ++i)
        tracks[i]["keys"] = list_json(parameters(), animation.tracks[i].keys);
    return json;
}

Recipe recipe_from_json(const Json& json, const ImageReader& read_image) {
    Recipe recipe;
    read_members(parameters(), json, recipe);
    read_list(parameters(), part_of(json, "controls"), recipe.controls);
    read_members(parameters(), part_of(json, "atlas"), recipe.atlas);
    read_members(parameters(), part_of(json, "solid"), recipe.solid);
    const Json &define = part_of(json, "define"), &material = part_of(json, "material");
    recipe.texture = material_from_json(part_of(json, "texture"), material, define, read_image);
    read_members(parameters(), without_channel_nodes(material), recipe.material);
    const Json& bump = part_of(json, "bump");
    read_members(parameters(), bump, recipe.bump);
    if (bump.contains("input"))
        recipe.bump.input = scalar_from_json(bump["input"], define, read_image);
    read_members(parameters(), part_of(json, "filter"), recipe.filter);
    read_members(parameters(), part_of(json, "precision"), recipe.precision);
    read_members(parameters(), part_of(json, "precision"), recipe.precision.format);
    read_list(parameters(), part_of(json, "paint"), recipe.paint);
    read_members(parameters(), part_of(json, "pose"), recipe.pose);
    recipe.animation = animation_from_json(part_of(json, "animation"));
    return recipe;
}

/// The MIP map that a recipe has of an image; null: none.
std::shared_ptr<const MipImage> known_image(const Recipe& known, const std::string& file,
                                            ImageWrap wrap) {
    for (const TextureGraph* graph : {&known.texture, &known.bump.input})
        for (const GraphImage& image : graph->images)
            if (image.file == file && image.pixels->wrap() == wrap) return image.pixels;
    return nullptr;
}

/// Reads a recipe from JSON that has been checked. Images are those of `known` or, where it lacks
/// them, are decoded once all have told their sizes.
Recipe read_recipe(const Json& tree, const std::string& origin, RecipeImages& images,
                   const Recipe& known) {
    const auto path_of = [folder = std::filesystem::path(origin).parent_path()](
                             const std::string& file) { return (folder / file).string(); };
    DeclaredImages declared(images.limits);
    std::set<const MipImage*> blank;
    Recipe recipe = recipe_from_json(tree, [&](const std::string& file, ImageWrap wrap) {
        if (auto pixels = known_image(known, file, wrap)) return pixels;
        if (!may_name(images.limits.named, origin, file))
            throw invalid_file(origin, 0, fmt::format("the image {} {}", file, outside_rule));
        declared.add(path_of(file), wrap);
        auto pixels = blank_image(wrap);
        blank.insert(pixels.get());
        return pixels;
    });
    for (TextureGraph* graph : {&recipe.texture, &recipe.bump.input})
        for (GraphImage& image : graph->images)
            if (blank.contains(image.pixels.get()))
                image.pixels = images.pyramid(path_of(image.file), image.pixels->wrap());
    return recipe;
}

/// The channels that differ from the defaults.
Json material_to_json(const Recipe& recipe) {
    Json json = Json::object();
    write_members(parameters(), recipe.material, json, [](std::string_view) { return false; });
    json.update(channels_to_json(recipe.texture));
    return json;
}

/// The controls, without the keys that say nothing.
Json controls_to_json(const std::vector<RecipeControl>& controls) {
    Json list = Json::array();
    for (const RecipeControl& one : controls)
        write_members(parameters(), one, list.emplace_back(),
                      [](std::string_view key) { return key != "about"; });
    return list;
}

Json tree_of(const Recipe& recipe) {
    Json json{{"burl", 1}};
    write_members(parameters(), recipe, json, [](std::string_view key) { return key == "name"; });
    if (!recipe.controls.empty()) json["controls"] = controls_to_json(recipe.controls);
    write_members(parameters(), recipe.atlas, json["atlas"]);
    write_members(parameters(), recipe.solid, json["solid"]);
    if (!recipe.texture.names.empty()) json["define"] = names_to_json(recipe.texture);
    json["texture"] = graph_to_json(recipe.texture);
    if (Json material = material_to_json(recipe); !material.empty())
        json["material"] = std::move(material);
    write_members(parameters(), recipe.filter, json["filter"]);
    write_members(parameters(), recipe.precision, json["precision"]);
    write_members(parameters(), recipe.precision.format, json["precision"]);
    if (!recipe.bump.empty()) {
        write_members(parameters(), recipe.bump, json["bump"]);
        json["bump"]["input"] = graph_to_json(recipe.bump.input);
    }
    if (!recipe.paint.empty()) json["paint"] = list_json(parameters(), recipe.paint);
    if (recipe.pose != PoseOptions{}) write_members(parameters(), recipe.pose, json["pose"]);
    if (recipe.animation != KeyedAnimation{})
        json["animation"] = animation_to_json(recipe.animation);
    return json;
}

}  // namespace

Recipe parse_recipe(const std::string& json, const std::string& origin,
                    const std::vector<std::string>& settings, RecipeImages& images) {
    Json tree = parse_json_text(json, origin);
    if (const auto problem = find_problem(tree)) throw invalid_file(origin, 0, problem->sentence);
    tree = respelled(std::move(tree));
    if (!settings.empty()) apply_settings(tree, settings);
    return read_recipe(tree, origin, images, {});
}

Recipe recipe_of(const Json& tree, const Recipe& known, const std::string& origin) {
    RecipeImages images;
    return read_recipe(tree, origin, images, known);
}

Recipe load_recipe(const std::string& path_or_preset, const std::vector<std::string>& settings,
                   RecipeImages& images) {
    const RecipeText text = recipe_text(path_or_preset);
    Recipe recipe = parse_recipe(text.json, text.origin, settings, images);
    images.note_losses(path_or_preset, text.losses);
    if (recipe.name.empty() && !names_preset(path_or_preset))
        recipe.name = std::filesystem::path(text.origin).stem().string();
    return recipe;
}

Recipe with_numbers(const Recipe& recipe, const std::vector<std::string>& settings) {
    Recipe bare = recipe;
    bare.paint.clear();
    bare.animation = {};
    Json tree = tree_of(bare);
    apply_settings(tree, with_arrays(tree, settings));
    Recipe result = recipe_from_json(
        tree, [](const std::string&, ImageWrap wrap) { return blank_image(wrap); });
    result.texture.images = recipe.texture.images;
    result.bump.input.images = recipe.bump.input.images;
    result.paint = recipe.paint;
    result.animation = recipe.animation;
    return result;
}

std::string to_json(const Recipe& recipe) {
    return print_json(tree_of(recipe));
}

}  // namespace burl
