#pragma once
// In which order people meet a recipe's parameters: what changes the texture most comes first, what
// few people need is folded away, and everything has a name in words. No user interface is known
// here.
#include <string>
#include <string_view>
#include <vector>

#include "app/recipe/leaves.h"

namespace burl {

/// A heading and what stands under it.
struct ParameterGroup {
    std::string name;                     ///< RecipeLeaf::group
    std::string title;                    ///< for people
    bool open = true;                     ///< to begin with
    std::vector<RecipeLeaf> first, more;  ///< `more`: few people need them
};

/// Every leaf once; leaves of the same node or section must stand together. Those of a kind of
/// noise that the group has not are among `more`.
std::vector<ParameterGroup> parameter_groups(const std::vector<RecipeLeaf>& leaves);

/// What people call the node at this path; of a map of colours without sliders, after its place.
std::string group_title(const std::vector<ParameterGroup>& groups, const std::string& path);

/// What people call a number of it, such as "Noise 1: frequency y" or "Colours: stop 2, place"; of
/// one that has no slider, the path.
std::string number_label(const std::vector<ParameterGroup>& groups, const std::string& path);

/// What people call a parameter with this key; of keys nobody thought of, the key in words.
std::string parameter_label(std::string_view key);

}  // namespace burl
