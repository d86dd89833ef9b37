#pragma once
// Checks recipe JSON against the parameter table. What turns JSON into a Recipe afterwards may rely
// on keys, types and ranges.
#include <optional>
#include <string>

#include "app/json_text.h"

namespace burl {

struct RecipeProblem {
    std::string path;      ///< dotted, such as "texture.input.noise.0.gain"; empty for the root
    std::string sentence;  ///< names the path, the value and what is allowed
};

/// The first thing that is wrong with the recipe, if any.
std::optional<RecipeProblem> find_problem(const Json& recipe);

}  // namespace burl
