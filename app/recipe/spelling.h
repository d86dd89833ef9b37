#pragma once
// Keys of a recipe that have two spellings: "material.base_color" is "texture", and
// "material.height" is "bump.input". A recipe is read, edited and written in the second.
#include <optional>
#include <string>

#include "app/recipe/schema_check.h"

namespace burl {

/// The recipe in the one spelling. It must have no spelling problem.
Json respelled(Json recipe);

/// The value of "material.base_color" as "texture" takes it: a number or colour becomes a node.
Json as_base_color(Json value);

/// A part of the recipe that is there in both spellings.
std::optional<RecipeProblem> find_spelling_problem(const Json& recipe);

/// The path in the one spelling: "texture.input" for "material.base_color.input".
std::string respelled_path(const std::string& path);

/// The problem of a respelled recipe with the path that its writer used.
RecipeProblem as_written(RecipeProblem problem, const Json& written);

}  // namespace burl
