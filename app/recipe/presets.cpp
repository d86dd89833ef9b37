#include "app/recipe/presets.h"

#include <algorithm>
#include <iterator>
#include <span>

#include <fmt/format.h>

#include "app/base/embedded.h"
#include "app/base/file_bytes.h"
#include "app/base/messages.h"
#include "app/materialx/materialx.h"
#include "atlas/base/error.h"

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
                    ".json or .mtlx file",
                    name, hint));
}

}  // namespace

std::vector<std::string_view> preset_names() {
    return names_of(embedded_recipes());
}

std::vector<std::string_view> material_names() {
    return names_of(embedded_materials());
}

bool names_preset(std::string_view path_or_preset) {
    return path_or_preset.find_first_of("./") == std::string_view::npos;
}

bool names_recipe_file(std::string_view path) {
    return path.ends_with(extension) || names_materialx(path);
}

std::string recipe_file(const std::string& path) {
    return materialx_path(path).file;
}

RecipeText recipe_text(const std::string& path_or_preset) {
    if (!names_preset(path_or_preset)) {
        const std::string file = recipe_file(path_or_preset);
        const std::vector<std::uint8_t> bytes = read_file_bytes(file);
        const std::string text(bytes.begin(), bytes.end());
        if (!names_materialx(path_or_preset)) return {text, {}, file};
        MaterialXRecipe recipe = recipe_of_materialx(text, path_or_preset);
        return {std::move(recipe.json), std::move(recipe.losses), file};
    }
    for (const auto& files : {embedded_recipes(), embedded_materials()}) {
        const auto found = std::ranges::find(files, path_or_preset, preset_name);
        if (found != files.end()) return {std::string(found->content), {}, path_or_preset};
    }
    throw unknown_preset(path_or_preset);
}

}  // namespace burl
