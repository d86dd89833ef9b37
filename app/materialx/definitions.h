#pragma once
// Definitions of nodes that a document brings along.
#include "app/materialx/document.h"

namespace burl::materialx {

/// A definition with the graph that implements it; both null where the document has none.
struct OwnDefinition {
    const Element* definition = nullptr;
    const Element* graph = nullptr;
};

/// The document's own definition of a node: the `nodedef` that it names, or one for its category
/// whose types are the node's, if a node graph of the document implements it.
OwnDefinition own_definition(const Document& document, const Element& node);

/// The types that MaterialX's own element may have besides nodes, such as "input" and "nodedef".
bool is_node(const Element& element);

}  // namespace burl::materialx
