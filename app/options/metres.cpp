#include "app/options/metres.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/base/messages.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/spelling.h"

namespace burl {

namespace {

constexpr std::string_view size_name = "size";

/// The control that says how long the object is in metres or kilometres; null: the recipe has none.
const RecipeControl* size_control(const Recipe& recipe) {
    const auto found = std::ranges::find_if(recipe.controls, [](const RecipeControl& control) {
        return control.name == size_name && control.range && !control.sets.empty() &&
               control.about.find("metres") != std::string::npos;
    });
    return found == recipe.controls.end() ? nullptr : &*found;
}

/// Whether the command sets the control, by its name in any case or by its path.
bool is_set(const RecipeControl& size, const RecipeOptions& options) {
    return std::ranges::any_of(options.edits(), [&](const RecipeEdit& edit) {
        std::string name = edit.path;
        for (char& c : name)
            if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
        return name == size_name || respelled_path(edit.path) == respelled_path(size.sets.front());
    });
}

}  // namespace

void set_metres(std::span<Recipe> recipes, const RecipeOptions& options, const MeshFrame& frame,
                const Mesh& mesh) {
    if (!frame.units || recipes.empty()) return;
    const RecipeControl* size = size_control(recipes.front());
    if (!size || recipes.front().solid.space == SolidSpace::object || is_set(*size, options))
        return;
    const bool kilometres = size->about.find("kilometres") != std::string::npos;
    const double length = bounding_box(mesh).longest_side() / (kilometres ? 1000.0 : 1.0);
    const auto& [low, high] = *size->range;
    const double taken = std::clamp(length, low, high);
    if (taken != length)
        warn(fmt::format(
            "{0}: the mesh is {1:.4g} {6} long, and the size of {2} goes from {3} to "
            "{4} {6}; {5} is taken",
            mesh.name, length, recipes.front().name, low, high, taken, kilometres ? "km" : "m"));
    for (Recipe& recipe : recipes)
        recipe = with_numbers(recipe, {fmt::format("{}={}", size_name, taken)});
}

}  // namespace burl
