#pragma once
// The recipes that the program brings along, papers' presets and materials, by their names.
#include <string>
#include <string_view>
#include <vector>

namespace burl {

/// The names of the presets in assets/recipes/papers, in alphabetical order.
std::vector<std::string_view> preset_names();

/// The names of the materials in assets/materials, in alphabetical order; none is a preset's.
std::vector<std::string_view> material_names();

/// Whether the argument has the form of a preset's or material's name, known or not; anything with
/// a dot or a slash is a file's path.
bool names_preset(std::string_view path_or_preset);

/// Whether the path is that of a recipe: a .json file, or a MaterialX document with or without the
/// material that is chosen of it ("woods.mtlx#oak").
bool names_recipe_file(std::string_view path);

/// The file of a recipe's path, without the material that is chosen of a document.
std::string recipe_file(const std::string& path);

/// A recipe as text.
struct RecipeText {
    std::string json;
    /// Sentences about what the file says and no recipe holds (app/materialx/materialx.h).
    std::vector<std::string> losses{};
    std::string origin;  ///< the file for messages and relative paths, or the name
};

/// The JSON of the recipe in a file, or of the preset or material of that name, as it was written;
/// of a MaterialX document the JSON that is made of it. Throws Error(io) where the file cannot be
/// read, usage for an unknown name, and as recipe_of_materialx does.
RecipeText recipe_text(const std::string& path_or_preset);

}  // namespace burl
