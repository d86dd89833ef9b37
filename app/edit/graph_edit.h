#pragma once
// One step of building: the recipe that a function of this room makes of another one.
#include <string>
#include <vector>

#include "app/recipe/recipe.h"

namespace burl {

struct GraphEdit {
    Recipe recipe;
    std::string words;  ///< what was done, for a list of steps
    std::string path;   ///< the place of the node that it was done to; empty: none
    /// Losses of the edit, a sentence each: controls and keyed numbers of nodes that went.
    std::vector<std::string> lost{};
};

}  // namespace burl
