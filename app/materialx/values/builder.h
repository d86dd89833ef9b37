#pragma once
// A recipe's nodes as they are made from a document: equal nodes are one node, arithmetic of
// constants is done at once. What is used several times becomes a name of the recipe's "define".
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/base/json_text.h"
#include "atlas/base/json.h"

namespace burl::materialx {

/// The number of a node of a NodeBuilder.
using NodeRef = std::uint32_t;

/// A node's inputs by the recipe's keys.
using NodeInputs = std::vector<std::pair<std::string, NodeRef>>;

/// A node, or a constant number, whose `node` is empty.
struct BuiltNode {
    std::string node;
    double number = 0.0;
    bool color = false;  ///< whether it gives a colour, rather than a number
    NodeInputs inputs{};
    Json parameters = Json::object();
    std::string label{};  ///< what the document calls it
};

/// The nodes made so far; references stay valid.
class NodeBuilder {
  public:
    /// Sets what the document calls the nodes made from now on; returns what it was before.
    std::string set_label(std::string label) { return std::exchange(label_, std::move(label)); }

    NodeRef number(double value);
    NodeRef node(const std::string& name, bool color, NodeInputs inputs,
                 Json parameters = Json::object());

    /// An operation of MaterialX on numbers, by its name there; constants are computed.
    NodeRef math(std::string_view operation, std::vector<NodeRef> inputs);
    /// An operation of MaterialX on vectors, channel by channel or as a whole.
    NodeRef vector_math(std::string_view operation, std::vector<NodeRef> inputs);

    /// A channel of a colour, 0 to 2; a number itself.
    NodeRef channel(NodeRef from, std::size_t index);
    /// The colour of three channels; a number where all are one.
    NodeRef combined(const std::vector<NodeRef>& channels);

    std::optional<double> constant(NodeRef ref) const;
    bool is_color(NodeRef ref) const { return nodes_[ref].color; }
    const BuiltNode& operator[](NodeRef ref) const { return nodes_[ref]; }

  private:
    NodeRef push(const std::string& key, BuiltNode node);
    /// The result of an operation whose inputs say it without arithmetic at the point.
    std::optional<NodeRef> folded(std::string_view operation, const std::vector<NodeRef>& inputs);
    /// The node of an operation that has one for constants among its inputs.
    std::optional<NodeRef> with_constants(std::string_view operation,
                                          const std::vector<NodeRef>& inputs);

    std::vector<BuiltNode> nodes_;
    std::map<std::string, NodeRef> known_;
    std::string label_;
};

/// Turns nodes into JSON, with names for what is used several times.
class NodeWriter {
  public:
    /// `roots` are all nodes that write() will be asked for.
    NodeWriter(const NodeBuilder& nodes, const std::vector<NodeRef>& roots);

    /// The node as a recipe spells it where an input may stand.
    Json write(NodeRef ref) const;
    /// The recipe's "define".
    Json names() const;

  private:
    void count(NodeRef ref);
    Json written_out(NodeRef ref) const;

    const NodeBuilder& nodes_;
    std::map<NodeRef, std::size_t> uses_;
    std::vector<NodeRef> order_;  ///< nodes after all that they use
    std::map<NodeRef, std::string> names_;
};

}  // namespace burl::materialx
