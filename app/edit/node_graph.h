#pragma once
// A recipe's nodes and wires as a flat list, for views.
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/base/json_text.h"
#include "app/recipe/recipe.h"
#include "atlas/base/json.h"

namespace burl {

/// An input of a node of the list.
struct GraphInput {
    std::string key;    ///< as in the JSON; of the material "base_color", "height" or a channel
    std::string words;  ///< as people call it
    std::string place;  ///< where a step puts what is connected
    Wire wire = Wire::number;
    std::string tip;
    Json constant{};  ///< the number or colour that stands there; null where a wire ends
    std::optional<std::size_t> from{};  ///< index of the node whose wire ends here
    bool by_name = false;               ///< whether the wire is a name of "define"
};

/// A node of the list.
struct GraphNodeView {
    std::string place;  ///< as steps take it; "material" for what all ends in
    std::string type;   ///< name in the node table; "material"
    std::string name;   ///< of "define"; empty: none
    std::string words;  ///< such as "fbm 2 in rings"
    Wire gives = Wire::number;
    std::vector<GraphInput> inputs{};
    Json json{};            ///< with all that it is made of
    std::size_t terms = 0;  ///< noise terms of a field
};

/// The list: the material first, then each part in the recipe's order, a node before its inputs.
struct NodeGraph {
    std::vector<GraphNodeView> nodes;

    /// The index of the node at a place, or of the one that the name standing there means; none
    /// where there is no node.
    std::optional<std::size_t> find(const std::string& place) const;
};

/// The nodes and wires of a recipe. A number or colour that is an input is no node of its own.
NodeGraph node_graph(const Recipe& recipe);

/// The nodes that a node is used by.
std::vector<std::size_t> users_of(const NodeGraph& graph, std::size_t node);

}  // namespace burl
