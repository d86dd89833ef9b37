#pragma once
// The result of one node, as a recipe: what a view shows when somebody looks at that node alone.
#include <string>

#include "app/recipe/recipe.h"

namespace burl {

/// A recipe whose base colour is what the node at a place gives, at the points at which it is
/// evaluated; a number is a grey, 0 black and 1 white. Atlas, solid, filter and pose are those of
/// `recipe`; it has no channels, height, paint, controls and keys. Of a node that several use it is
/// the first use. Throws Error(usage) where no node stands there.
Recipe look_at(const Recipe& recipe, const std::string& place);

}  // namespace burl
