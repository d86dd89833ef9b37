#pragma once
// Sub-graphs as JSON text, for the clipboard.
#include <string>
#include <vector>

#include "app/edit/graph_edit.h"

namespace burl {

/// The nodes at places, with all that they are made of, as JSON text: {"burl_nodes": 1, "define":
/// {...}, "nodes": [...]}; `define` has the names that they use. Nodes that others of the set are
/// made of are not listed again. Throws Error(usage) where a place has no node.
std::string copy_nodes(const Recipe& recipe, const std::vector<std::string>& places);

/// Whether a text is such JSON, or a single node.
bool holds_nodes(const std::string& text);

/// Pastes nodes: the first one at `place`, where a node that stood there is kept under a name, the
/// others, or all where the place is empty, under names that nothing uses. Names that the recipe
/// has for other nodes are changed. Throws Error(usage) for a text that has no valid nodes.
GraphEdit paste_nodes(const Recipe& recipe, const std::string& place, const std::string& text,
                      const std::string& origin = {});

}  // namespace burl
