#pragma once
// The result of one node, as a recipe: what a view shows when somebody looks at that node alone.
#include <array>
#include <optional>
#include <string>

#include "app/recipe/recipe.h"

namespace burl {

struct NodeLook {
    /// A recipe whose base colour is what the node gives, at the points at which it is evaluated.
    Recipe recipe;
    /// The numbers that are black and white; empty for a colour, and for a number that is its own
    /// grey.
    std::optional<std::array<double, 2>> range{};
};

/// The look at the node at a place. A number that leaves [0, 1], or hardly differs, is stretched
/// from its least value on a ball to its largest. Atlas, solid, filter and pose are those of
/// `recipe`; there are no channels, height, colour paint, controls and
/// keys. Of a node that several use it
/// is the first use. Throws Error(usage) where no node stands there.
NodeLook look_at(const Recipe& recipe, const std::string& place);

/// Whether the recipe's base colour reads masks, which need a mesh.
bool reads_masks(const Recipe& recipe);

}  // namespace burl
