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
    /// What went with the nodes that it belonged to, a sentence each: controls, keyed numbers.
    std::vector<std::string> lost{};
};

}  // namespace burl
