#pragma once
// What the nodes of MaterialX are made of in a recipe, by their category.
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/materialx/reader.h"

namespace burl::materialx {

/// A node to be made, with its inputs at hand.
struct NodeCall {
    Reader& reader;
    const Element& node;
    const Scope& scope;
    const std::string& output;  ///< the output asked for; empty: the only one
    Type type;  ///< the type of the result; a number where there are several outputs

    Arithmetic& values() const { return reader.values; }
    NodeBuilder& nodes() const { return reader.nodes; }

    /// The value of an input; `otherwise`, in every component, where it is left out.
    Value in(std::string_view name, double otherwise) const;
    Value in(std::string_view name, Type type_left_out, double otherwise) const;
    Value in(std::string_view name, const Value& otherwise) const;
    /// The value of an input of whichever type; the number 0 where it is left out.
    Value any(std::string_view name) const;
    /// The node of an input that is a number.
    NodeRef number(std::string_view name, double otherwise) const;
    /// The numbers of an input; none where they vary.
    std::optional<std::vector<double>> constants(std::string_view name,
                                                 const std::vector<double>& otherwise) const;
    std::optional<double> constant(std::string_view name, double otherwise) const;
    /// The text of an input, such as "periodic"; empty where it is left out.
    std::string text(std::string_view name) const;
    /// A geometric property of the point, as the input's default.
    Value geometry(std::string_view name, const char* property) const;

    /// The value 0, and a note that the node is not read.
    Value refused(const std::string& reason) const;
    /// Refuses the node as refused() does, because of an input that must be constant.
    Value varies(std::string_view name) const;
    /// The value of a node that makes a number; refused where its type has more components.
    Value made(NodeRef ref) const;
};

/// A vector2 turned clockwise by an angle in radians.
Value turned(Arithmetic& values, const Value& value, NodeRef angle);

/// A function that makes a node.
using NodeFunction = Value (*)(const NodeCall& call);

/// The function of a category; null for those that are not read.
NodeFunction function_of(std::string_view category);

/// A row of a family's table.
struct NodeRow {
    std::string_view category;
    NodeFunction function;
};

// The families, each a file of its own.
std::span<const NodeRow> math_rows();
std::span<const NodeRow> vector_rows();
std::span<const NodeRow> channel_rows();
std::span<const NodeRow> color_rows();
std::span<const NodeRow> blend_rows();
std::span<const NodeRow> noise_rows();
std::span<const NodeRow> unified_rows();
std::span<const NodeRow> choice_rows();
std::span<const NodeRow> ramp_rows();
std::span<const NodeRow> place_rows();
std::span<const NodeRow> image_rows();

}  // namespace burl::materialx
