#pragma once
// A node graph of a MaterialX document as it is written: nodes by running numbers, equal nodes
// once.
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "app/materialx/write/xml.h"

namespace burl::materialx {

/// A number in a node graph: a constant, a node of type float, or a component of another node.
struct Operand {
    double constant = 0.0;
    std::string node{};  ///< empty: the constant
    std::string type{};  ///< of the node that it is a component of; empty: the node is a float
    int component = 0;

    bool is_constant() const { return node.empty(); }
};

/// Operands by the names of the inputs that they go to.
using OperandInputs = std::vector<std::pair<std::string, Operand>>;

/// The nodes of one graph, which are added and never changed.
class XmlNodes {
  public:
    /// Sets the comment that the next new node is written behind; once.
    void set_comment(const std::string& comment) { comment_ = comment; }

    /// Adds a node of the category and type with inputs, and returns its name; a node with the same
    /// inputs is not added twice.
    std::string add(const std::string& category, const std::string& type,
                    std::vector<XmlElement> inputs);
    /// Adds a node of type float.
    Operand number(const std::string& category, const OperandInputs& inputs);
    /// Adds a node of two float inputs, in1 and in2; arithmetic of constants, factors of 1 and
    /// terms of 0 need none.
    Operand binary(const std::string& category, const Operand& in1, const Operand& in2);
    Operand unary(const std::string& category, const Operand& in) {
        return number(category, {{"in", in}});
    }
    /// The number a where value1 >= value2 (or, of "ifgreater", >), else b.
    Operand choose(const std::string& category, const Operand& value1, const Operand& value2,
                   const Operand& a, const Operand& b) {
        return number(category, {{"value1", value1}, {"value2", value2}, {"in1", a}, {"in2", b}});
    }

    /// The operands' node of type vector2, vector3, color3: one that they are the components of, or
    /// a new one.
    std::string combined(const std::string& type, const std::vector<Operand>& components);
    /// An input of type float.
    XmlElement input(const std::string& name, const Operand& operand);

    /// The operand times a number, and the sum of operands times factors with a constant, without
    /// factors of 1 and terms of 0.
    Operand times(const Operand& operand, double factor);
    Operand sum(const std::vector<Operand>& operands, const std::vector<double>& factors,
                double constant);

    const std::vector<XmlElement>& nodes() const { return nodes_; }

  private:
    std::string extracted(const Operand& operand);

    std::vector<XmlElement> nodes_;
    std::map<std::string, std::string> names_;  ///< nodes by what they are
    std::map<std::string, int> numbers_;        ///< the last number by category
    std::string comment_;
};

/// The components of a node: operands 0, 1, ...
std::vector<Operand> components_of(const std::string& node, const std::string& type);

}  // namespace burl::materialx
