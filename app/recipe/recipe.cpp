#include "app/recipe/recipe.h"

#include <algorithm>
#include <filesystem>
#include <iterator>

#include <fmt/format.h>

#include "app/base/embedded.h"
#include "app/base/file_bytes.h"
#include "app/base/messages.h"
#include "app/recipe/images.h"
#include "atlas/base/error.h"
#include "procedural/numbers/rotation.h"

namespace burl {

namespace {

constexpr std::string_view extension = ".json";

std::string_view preset_name(const EmbeddedFile& file) {
    return file.name.substr(0, file.name.size() - extension.size());
}

std::vector<std::string_view> names_of(std::span<const EmbeddedFile> files) {
    std::vector<std::string_view> names;
    for (const EmbeddedFile& file : files) names.push_back(preset_name(file));
    return names;
}

Error unknown_preset(const std::string& name) {
    std::vector<std::string_view> names = preset_names();
    std::ranges::copy(material_names(), std::back_inserter(names));
    const std::string_view nearest = nearest_word(name, names);
    const std::string hint = nearest.empty() ? "" : fmt::format("did you mean \"{}\"? ", nearest);
    return Error(
        ExitCode::usage,
        fmt::format("there is no recipe or material \"{}\"; {}`burl list recipes` and `burl "
                    "list materials` name them all; anything else must be the path of a "
                    ".json file",
                    name, hint));
}

}  // namespace

Affine3 texture_from_solid(const Recipe& recipe) {
    const SolidOptions& solid = recipe.solid;
    Affine3 map{solid.scale * Mat3d(1.0), solid.translate};
    if (solid.rotate != Vec3d(0.0)) map.linear = solid.scale * rotation_about_axes(solid.rotate);
    return map;
}

Affine3 texture_from_mesh(const Recipe& recipe, const Mesh& mesh) {
    return texture_from_solid(recipe).after(solid_from_mesh(mesh, recipe.solid.space));
}

PrecisionKind graph_precision(const Recipe& recipe) {
    return recipe.precision.kind == PrecisionKind::float64 ? PrecisionKind::float64
                                                           : PrecisionKind::float32;
}

double solid_units(const Mesh& mesh, SolidSpace space) {
    // The map is a uniform scale without rotation: one diagonal entry is the whole scale.
    return solid_from_mesh(mesh, space).linear[0][0];
}

std::vector<std::string_view> preset_names() {
    return names_of(embedded_recipes());
}

std::vector<std::string_view> material_names() {
    return names_of(embedded_materials());
}

bool names_preset(std::string_view path_or_preset) {
    return path_or_preset.find_first_of("./") == std::string_view::npos;
}

std::string recipe_text(const std::string& path_or_preset) {
    if (!names_preset(path_or_preset)) {
        const std::vector<std::uint8_t> bytes = read_file_bytes(path_or_preset);
        return {bytes.begin(), bytes.end()};
    }
    for (const auto& files : {embedded_recipes(), embedded_materials()}) {
        const auto found = std::ranges::find(files, path_or_preset, preset_name);
        if (found != files.end()) return std::string(found->content);
    }
    throw unknown_preset(path_or_preset);
}

Recipe load_recipe(const std::string& path_or_preset, const std::vector<std::string>& settings,
                   RecipeImages& images) {
    Recipe recipe = parse_recipe(recipe_text(path_or_preset), path_or_preset, settings, images);
    if (recipe.name.empty() && !names_preset(path_or_preset))
        recipe.name = std::filesystem::path(path_or_preset).stem().string();
    return recipe;
}

}  // namespace burl
