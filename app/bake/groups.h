#pragma once
// The atlases of one bake of a glTF: --assign and --atlas-per part its primitives, each part is a
// bake of its own into the same document, in which several recipes may share the atlas.
#include <array>
#include <string>
#include <vector>

#include "app/bake/options.h"

namespace burl {

/// Primitives of a glTF that have one recipe.
struct BakeShare {
    RecipeOptions recipe;
    std::vector<std::array<int, 2>> primitives{};  ///< mesh and primitive
};

/// The bake of one atlas.
struct BakeGroup {
    BakeCommand command;              ///< with the first recipe and the primitives of the group
    std::string pictures;             ///< the path after which its pictures are named
    std::vector<BakeShare> shares{};  ///< the recipes that share the atlas; empty: one
};

/// The bakes that the command stands for, in the order of their first primitives; one, the command
/// itself, where nothing parts it. Throws Error: usage where an option needs a glTF that becomes a
/// glTF, or --assign matches no material; and as read_mesh does.
std::vector<BakeGroup> groups_of(const BakeCommand& command);

}  // namespace burl
