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

/// The JSON of the recipe in a file, or of the preset or material of that name, as it was written.
/// Throws Error(io) where the file cannot be read, and usage for an unknown name.
std::string recipe_text(const std::string& path_or_preset);

}  // namespace burl
