#pragma once
// Circles in graphs, which no step may make.
#include <string>

#include "app/edit/tree.h"

namespace burl {

/// Throws Error(usage) that names the nodes of the circle which the node at `from` would make as an
/// input of the node that has the place `to`.
void refuse_circle(const RecipeTree& tree, const std::string& from, const std::string& to);

}  // namespace burl
