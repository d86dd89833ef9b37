#include "app/recipe/recipe.h"

#include <algorithm>
#include <filesystem>

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

Error unknown_preset(const std::string& name) {
    const std::vector<std::string_view> names = preset_names();
    const std::string_view nearest = nearest_word(name, names);
    const std::string hint = nearest.empty() ? "" : fmt::format("did you mean \"{}\"? ", nearest);
    return Error(ExitCode::usage,
                 fmt::format("there is no recipe \"{}\"; {}Presets: {}. Anything else must be the "
                             "path of a .json file",
                             name, hint, fmt::join(names, ", ")));
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
    std::vector<std::string_view> names;
    for (const EmbeddedFile& file : embedded_recipes()) names.push_back(preset_name(file));
    return names;
}

bool names_preset(std::string_view path_or_preset) {
    return path_or_preset.find_first_of("./") == std::string_view::npos;
}

Recipe load_recipe(const std::string& path_or_preset, const std::vector<std::string>& settings,
                   RecipeImages& images) {
    if (names_preset(path_or_preset)) {
        const auto presets = embedded_recipes();
        const auto found = std::ranges::find(presets, path_or_preset, preset_name);
        if (found == presets.end()) throw unknown_preset(path_or_preset);
        return parse_recipe(std::string(found->content), path_or_preset, settings, images);
    }
    const std::vector<std::uint8_t> bytes = read_file_bytes(path_or_preset);
    Recipe recipe =
        parse_recipe(std::string(bytes.begin(), bytes.end()), path_or_preset, settings, images);
    if (recipe.name.empty()) recipe.name = std::filesystem::path(path_or_preset).stem().string();
    return recipe;
}

}  // namespace burl
