#pragma once
// Values of MaterialX as nodes of a recipe. A number is a number; of vectors and colours the first
// three components are the red, green and blue of one opaque colour, and the fourth is a number
// beside it, since a recipe's colours are multiplied by their alpha.
#include <array>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <vector>

#include "app/materialx/values/builder.h"
#include "app/materialx/values/types.h"

namespace burl::materialx {

/// A value of a type, as a colour node, as one node for every component, or both.
struct Value {
    Type type = Type::number;
    std::optional<NodeRef> packed{};
    std::array<std::optional<NodeRef>, 4> parts{};
};

/// Makes values and computes with them.
class Arithmetic {
  public:
    explicit Arithmetic(NodeBuilder& made_nodes) : nodes(made_nodes) {}

    NodeBuilder& nodes;

    Value constant(Type type, const std::vector<double>& numbers);
    /// The value of which every component is `number`.
    Value filled(Type type, double number);
    Value number(NodeRef ref, Type type = Type::number) const;
    Value of_parts(Type type, const std::vector<NodeRef>& parts) const;
    /// The value whose first components are a colour's channels.
    Value of_color(Type type, NodeRef color, std::optional<NodeRef> fourth = {});

    /// A component, 0 where the value has none; of a number the number itself, whatever the index.
    NodeRef part(const Value& value, std::size_t index);
    std::vector<NodeRef> parts_of(const Value& value);
    /// The first components as a colour, or a number where they are equal. The third of a vector2
    /// is undefined.
    NodeRef packed(const Value& value);
    std::optional<std::vector<double>> constants_of(const Value& value);

    /// One of MaterialX's operations, component by component; numbers count for every component.
    Value apply(std::string_view operation, Type type, const std::vector<Value>& arguments);
    /// The number that an operation of vectors, such as "dotproduct", gives.
    NodeRef number_of(std::string_view operation, const std::vector<Value>& arguments);
    /// The value as a recipe's vector, the third component of a vector2 being 0.
    NodeRef vector(const Value& value);

  private:
    bool can_stay_apart(const std::vector<Value>& arguments);
};

}  // namespace burl::materialx
