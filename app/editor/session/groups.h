#pragma once
// The order and the words in which an editor shows a recipe's parameters: those that change the
// texture most come first, rarely needed ones are folded away. Independent of any user interface.
#include <string>
#include <string_view>
#include <vector>

#include "app/edit/node_words.h"
#include "app/recipe/edit/leaves.h"

namespace burl {

/// A group of parameters under one heading.
struct ParameterGroup {
    std::string name;                     ///< RecipeLeaf::group
    std::string title;                    ///< heading, in words
    bool open = true;                     ///< whether it is unfolded at first
    std::vector<RecipeLeaf> first, more;  ///< parameters shown, and rarely needed ones folded away
};

/// Groups all leaves; each occurs once. Leaves of the same node or section must be adjacent.
/// Parameters of another kind of noise than the group's are among `more`. Nodes and noise terms are
/// called by `words`.
std::vector<ParameterGroup> parameter_groups(const std::vector<RecipeLeaf>& leaves,
                                             const NodeWords& words);

/// The heading of the colour map at `path`: "Colours" for the texture itself, otherwise its words.
std::string map_title(const NodeWords& words, const std::string& path);

/// The name of a number of a parameter, such as "Noise 1: frequency y" or "Colours: stop 2, place";
/// the path itself for a number without a slider.
std::string number_label(const std::vector<ParameterGroup>& groups, const NodeWords& words,
                         const std::string& path);

/// The name of a parameter with this key; for keys without a name of their own, the key with spaces
/// for underscores.
std::string parameter_label(std::string_view key);

}  // namespace burl
