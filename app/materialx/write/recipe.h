#pragma once
// Recipes as documents of MaterialX 1.38: their textures as node graphs.
#include <string>
#include <vector>

#include "app/recipe/recipe.h"

namespace burl::materialx {

/// A document, and sentences on what of the recipe it leaves out.
struct RecipeDocument {
    std::string text;
    std::vector<std::string> notes{};
};

/// The recipe's material as a node graph with a standard_surface over it, point samples all.
/// `solid_from_object` is the map from the object's coordinates to solid space. Throws
/// Error(unsupported) naming every node by its place in the recipe for which MaterialX has no
/// equivalent, such as Burl's own noises.
RecipeDocument recipe_document(const Recipe& recipe, const Affine3& solid_from_object);

}  // namespace burl::materialx
