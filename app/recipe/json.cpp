#include <algorithm>
#include <array>
#include <bit>
#include <filesystem>
#include <memory>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/base/real_path.h"
#include "app/image/image_io.h"
#include "app/recipe/check.h"
#include "app/recipe/images.h"
#include "app/recipe/key_json.h"
#include "app/recipe/leaves.h"
#include "app/recipe/paint_json.h"
#include "app/recipe/settings.h"
#include "atlas/base/error.h"
#include "procedural/graph/json.h"
#include "procedural/model/texture_json.h"

namespace burl {

namespace {

// In the order of the enumerators.
constexpr std::array atlas_kinds{"uniform", "area", "length", "quad", "patch"};
constexpr std::array atlas_weights{"equal", "area", "length", "error"};
constexpr std::array partitions{"rcb", "graph"};
constexpr std::array diagonals{"shared", "overscan"};
constexpr std::array overscans{"nearest", "bilinear"};
constexpr std::array spaces{"unit", "object"};
constexpr std::array filters{"none",  "table-mip", "table-sat",  "table-sat3",
                             "exact", "trapezoid", "trapezoid2", "supersample"};
constexpr std::array filter_octaves{"keep", "fade"};
constexpr std::array precisions{"float32", "float64", "fixed"};

template <class Enum, class Names>
void read(const Json& json, const char* key, const Names& names, Enum& target) {
    if (!json.contains(key)) return;
    const auto found = std::find(names.begin(), names.end(), json[key].get<std::string>());
    if (found != names.end()) target = Enum(found - names.begin());
}

void read(const Json& json, const char* key, Vec3d& target) {
    if (!json.contains(key)) return;
    for (int axis = 0; axis < 3; ++axis) target[axis] = json[key][std::size_t(axis)].get<double>();
}

Json array_of(const Vec3d& v) {
    return {v.x, v.y, v.z};
}

template <class Enum, class Names>
const char* name_of(const Names& names, Enum value) {
    return names[std::size_t(value)];
}

/// Adds up the sizes that one recipe's images declare, before any is decoded.
class DeclaredImages {
  public:
    /// Throws Error(invalid_file) for what is too large, by itself or with those before it.
    void add(const std::string& path, ImageWrap wrap) {
        if (!seen_.insert({real_path(path), wrap}).second) return;
        const PngSize size = png_size(path);
        if (std::max(size.width, size.height) > largest_image_side)
            throw invalid_file(path, 0,
                               fmt::format("the image has {} x {} pixels; textures take at most {} "
                                           "a side, so scale it down",
                                           size.width, size.height, largest_image_side));
        texels_ += std::uint64_t{std::bit_ceil(size.width)} * std::bit_ceil(size.height);
        if (texels_ > most_image_texels)
            throw invalid_file(path, 0,
                               fmt::format("with this image the recipe's images have {} pixels "
                                           "together, their sides rounded up to powers of two, but "
                                           "{} is the most; scale some of them down",
                                           texels_, most_image_texels));
    }

  private:
    std::set<std::pair<std::string, ImageWrap>> seen_;
    std::uint64_t texels_ = 0;
};

/// In the place of an image that is not looked at.
std::shared_ptr<const MipImage> blank_image(ImageWrap wrap) {
    return std::make_shared<const MipImage>(Image<Rgb8>(1, 1), wrap);
}

Precision precision_from_json(const Json& json) {
    Precision precision;
    if (json.contains("kind")) read(json, "kind", precisions, precision.kind.emplace());
    const auto read_bits = [&](const char* key, unsigned& bits) {
        if (json.contains(key)) bits = unsigned(json[key].get<double>());
    };
    read_bits("integer_bits", precision.format.integer_bits);
    read_bits("fraction_bits", precision.format.fraction_bits);
    return precision;
}

Json precision_to_json(const Precision& precision) {
    Json json = Json::object();
    if (precision.kind) json["kind"] = name_of(precisions, *precision.kind);
    json["integer_bits"] = precision.format.integer_bits;
    json["fraction_bits"] = precision.format.fraction_bits;
    return json;
}

Recipe recipe_from_json(const Json& json, const ImageReader& read_image) {
    Recipe recipe;
    const Json none = Json::object();
    const auto part = [&](const char* key) -> const Json& {
        return json.contains(key) ? json[key] : none;
    };
    if (json.contains("name")) recipe.name = json["name"].get<std::string>();
    const Json& atlas = part("atlas");
    read(atlas, "kind", atlas_kinds, recipe.atlas.kind);
    read(atlas, "overscan", overscans, recipe.atlas.overscan);
    read(atlas, "weight", atlas_weights, recipe.atlas.weight);
    read(atlas, "partition", partitions, recipe.atlas.partition);
    read(atlas, "diagonals", diagonals, recipe.atlas.diagonals);
    if (atlas.contains("gutter"))
        recipe.atlas.gutter = std::uint32_t(atlas["gutter"].get<double>());
    if (atlas.contains("tries")) recipe.atlas.tries = int(atlas["tries"].get<double>());
    if (atlas.contains("size")) recipe.atlas.size = std::uint32_t(atlas["size"].get<double>());
    const Json& solid = part("solid");
    read(solid, "space", spaces, recipe.solid.space);
    if (solid.contains("scale")) recipe.solid.scale = solid["scale"].get<double>();
    read(solid, "rotate", recipe.solid.rotate);
    read(solid, "translate", recipe.solid.translate);
    if (is_graph(part("texture")))
        recipe.graph = graph_from_json(part("texture"), read_image);
    else
        recipe.texture = texture_from_json(part("texture"));
    const Json& bump = part("bump");
    if (bump.contains("input")) recipe.bump.input = graph_from_json(bump["input"], read_image);
    if (bump.contains("height")) recipe.bump.height = bump["height"].get<double>();
    const Json& filter = part("filter");
    read(filter, "kind", filters, recipe.filter.kind);
    if (filter.contains("samples")) recipe.filter.samples = int(filter["samples"].get<double>());
    read(filter, "octaves", filter_octaves, recipe.filter.band_limit);
    recipe.precision = precision_from_json(part("precision"));
    if (json.contains("paint")) recipe.paint = paint_from_json(json["paint"]);
    if (part("pose").contains("weight")) recipe.pose.weight = part("pose")["weight"].get<double>();
    if (json.contains("animation")) recipe.animation = animation_from_json(json["animation"]);
    return recipe;
}

Json tree_of(const Recipe& recipe) {
    Json json{{"burl", 1},
              {"name", recipe.name},
              {"atlas",
               {{"kind", name_of(atlas_kinds, recipe.atlas.kind)},
                {"size", recipe.atlas.size},
                {"overscan", name_of(overscans, recipe.atlas.overscan)},
                {"weight", name_of(atlas_weights, recipe.atlas.weight)},
                {"partition", name_of(partitions, recipe.atlas.partition)},
                {"gutter", recipe.atlas.gutter},
                {"diagonals", name_of(diagonals, recipe.atlas.diagonals)},
                {"tries", recipe.atlas.tries}}},
              {"solid",
               {{"space", name_of(spaces, recipe.solid.space)},
                {"scale", recipe.solid.scale},
                {"rotate", array_of(recipe.solid.rotate)},
                {"translate", array_of(recipe.solid.translate)}}},
              {"texture", recipe.graph.empty() ? texture_to_json(recipe.texture)
                                               : graph_to_json(recipe.graph)},
              {"filter",
               {{"kind", name_of(filters, recipe.filter.kind)},
                {"samples", recipe.filter.samples},
                {"octaves", name_of(filter_octaves, recipe.filter.band_limit)}}},
              {"precision", precision_to_json(recipe.precision)}};
    if (!recipe.bump.empty())
        json["bump"] = {{"height", recipe.bump.height},
                        {"input", graph_to_json(recipe.bump.input)}};
    if (!recipe.paint.empty()) json["paint"] = paint_to_json(recipe.paint);
    if (recipe.pose != PoseOptions{}) json["pose"] = {{"weight", recipe.pose.weight}};
    if (recipe.animation != KeyedAnimation{})
        json["animation"] = animation_to_json(recipe.animation);
    return json;
}

/// `path` lies at, above or below `other`.
bool concerns(const std::string& path, const std::string& other) {
    const std::string& shorter = path.size() < other.size() ? path : other;
    const std::string& longer = path.size() < other.size() ? other : path;
    return longer.starts_with(shorter) &&
           (longer.size() == shorter.size() || longer[shorter.size()] == '.');
}

/// Applies the settings, then checks the result as a whole: single steps may pass through recipes
/// that are not valid (stops out of order).
void apply_settings(Json& json, const std::vector<std::string>& settings) {
    std::vector<std::string> paths;
    for (const std::string& setting : settings) paths.push_back(apply_setting(json, setting));
    const auto problem = find_problem(json);
    if (!problem) return;
    for (std::size_t i = settings.size(); i-- > 0;) {
        if (concerns(problem->path, paths[i]))
            throw Error(ExitCode::usage,
                        fmt::format("--set {}: {}", settings[i], problem->sentence));
    }
    throw Error(ExitCode::usage, "--set: " + problem->sentence);
}

/// Arrays of which single numbers are set must be there, which defaults of a graph's nodes are not.
std::vector<std::string> with_arrays(const Json& tree, const std::vector<std::string>& settings) {
    std::vector<std::string> all;
    for (const RecipeLeaf& leaf : recipe_leaves(tree)) {
        const std::string front = leaf.path + ".";
        const auto inside = [&](const std::string& setting) { return setting.starts_with(front); };
        if (leaf.parameter->type == ParameterType::numbers &&
            std::any_of(settings.begin(), settings.end(), inside))
            all.push_back(fmt::format("{}={}", leaf.path, leaf.value.dump()));
    }
    all.insert(all.end(), settings.begin(), settings.end());
    return all;
}

}  // namespace

Recipe parse_recipe(const std::string& json, const std::string& origin,
                    const std::vector<std::string>& settings, RecipeImages& images) {
    Json tree = parse_json_text(json, origin);
    if (const auto problem = find_problem(tree)) throw invalid_file(origin, 0, problem->sentence);
    if (!settings.empty()) apply_settings(tree, settings);
    const auto path_of = [folder = std::filesystem::path(origin).parent_path()](
                             const std::string& file) { return (folder / file).string(); };
    DeclaredImages declared;
    Recipe recipe = recipe_from_json(tree, [&](const std::string& file, ImageWrap wrap) {
        declared.add(path_of(file), wrap);
        return blank_image(wrap);
    });
    for (TextureGraph* graph : {&recipe.graph, &recipe.bump.input})
        for (GraphImage& image : graph->images)
            image.pixels = images.pyramid(path_of(image.file), image.pixels->wrap());
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
    result.graph.images = recipe.graph.images;
    result.bump.input.images = recipe.bump.input.images;
    result.paint = recipe.paint;
    result.animation = recipe.animation;
    return result;
}

std::string to_json(const Recipe& recipe) {
    return print_json(tree_of(recipe));
}

}  // namespace burl
