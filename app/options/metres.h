#pragma once
// Recipes in metres: what --units says of a mesh, for materials that have a `size`.
#include <span>

#include "app/options/command_options.h"

namespace burl {

/// Sets the control `size` of the recipes, frames of one, to the longest side of the mesh where
/// --units told its metres. Recipes stay as they are without --units, without such a control, in
/// space "object", whose coordinates are metres then, and where the command sets the size itself.
/// A size beyond the control's range becomes the nearest within, which is said on stderr.
void set_metres(std::span<Recipe> recipes, const RecipeOptions& options, const MeshFrame& frame,
                const Mesh& mesh);

}  // namespace burl
