#pragma once
// Recipes read from JSON and written as JSON (docs/reference/recipes.md).
#include <string>
#include <vector>

#include "app/recipe/recipe.h"

namespace burl {

/// Parses recipe JSON; `origin` names it in messages. `settings` are "path=value" edits applied to
/// the JSON first, such as "texture.input.noise.0.amplitude=0.7", or set a control by its name,
/// such as "ring spacing=0.01" (app/recipe/edit/controls.h). Unknown keys, wrong types and values
/// out of range throw Error(invalid_file), or Error(usage) for `settings`, naming the key and the
/// nearest known one. Paths of a texture's images are relative to origin's folder.
Recipe parse_recipe(const std::string& json, const std::string& origin,
                    const std::vector<std::string>& settings = {});

/// The recipe in a file, or the preset or material of that name ("marble"; see names_preset). A
/// recipe without a name gets its file's, without folder and extension. Throws Error as
/// parse_recipe does, io where the file cannot be read, and usage for an unknown preset.
Recipe load_recipe(const std::string& path_or_preset,
                   const std::vector<std::string>& settings = {});

/// The recipe with "path=value" settings of numbers applied; its images, paint and keys stay.
/// Throws Error(usage).
Recipe with_numbers(const Recipe& recipe, const std::vector<std::string>& settings);

/// The recipe as JSON that parse_recipe reads back to an equal Recipe.
std::string to_json(const Recipe& recipe);

}  // namespace burl
