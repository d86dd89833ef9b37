#pragma once
// The nodes a texture graph can have: names, inputs, parameters with their ranges, meaning and
// source. Parsing, checking, `burl list nodes`, --set and docs/reference/nodes.md follow this one
// table.
#include <array>
#include <span>
#include <string_view>

#include "procedural/batch/parameter.h"
#include "procedural/graph/batch.h"

namespace burl {

struct NodeInput {
    std::string_view key;
    Wire wire = Wire::number;   ///< color: a number counts as an opaque grey
    bool sets_wire = false;     ///< of nodes that give what this input gives: a number or a colour
    std::string_view fallback;  ///< as JSON; empty where the input is required
    std::string_view tip;
};

/// What a node gives: one wire, a colour if any input that sets it is one, or (`inner`) what its
/// input gives, evaluated at the point the node makes.
enum class NodeResult { number, color, inputs, inner };

struct NodeType {
    std::string_view name;
    NodeResult result = NodeResult::number;
    void (*evaluate)(const NodeCall& call) = nullptr;
    std::string_view text, source;
    std::array<NodeInput, 4> input_list{};
    std::array<Parameter, 10> parameter_list{};

    std::span<const NodeInput> inputs() const;
    /// `path` is the key alone. A default of null: left out, stored as infinity.
    std::span<const Parameter> parameters() const;
    const NodeInput* input(std::string_view key) const;
};

std::span<const NodeType> graph_table();

/// The entry of a name; null if there is none.
const NodeType* find_node(std::string_view name);

inline const NodeType& type_of(const GraphNode& node) {
    return graph_table()[node.type];
}

}  // namespace burl
