#pragma once
// Marks in a recipe's JSON while a step of building moves its nodes about: they say what controls
// and keyed numbers point at, so that their paths follow.
#include <map>
#include <string>
#include <vector>

#include "app/base/json_text.h"

namespace burl {

/// A key of a constant node that stands for a bare number or colour of "material".
inline constexpr const char* bare_key = "\x02";

/// The marks of one recipe.
class PlaceMarks {
  public:
    /// Marks the nodes, terms and constants that the recipe's controls and keys point at.
    explicit PlaceMarks(Json& recipe);

    /// Takes all marks out and gives controls and keys the paths at which what they point at stands
    /// now; a copy of it is pointed at, too. What is nowhere any more is left out; returns a
    /// sentence for each.
    std::vector<std::string> settle(Json& recipe) const;

  private:
    std::map<std::string, std::string> before_;  ///< path of each mark
};

/// Takes out the control, its entry, or the keys that have the problem at a path, and adds a
/// sentence; false where the problem lies elsewhere.
bool drop_misfit(Json& recipe, const std::string& path, std::vector<std::string>& lost);

/// Gives a node the marks of the one that it takes the place of.
void take_marks(Json& node, const Json& from);

/// A copy of a node without marks.
Json without_marks(Json node);

}  // namespace burl
