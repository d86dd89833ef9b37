#pragma once
// The columns and families of the table of nodes (table.h), for the files that define them.
#include "procedural/graph/table.h"

namespace burl::nodes {

using Outputs = std::vector<Register>;
using Inputs = std::array<NodeInput, 4>;
using Parameters = std::array<Parameter, 10>;

/// The parameter of a number.
constexpr Parameter real(std::string_view key, double low, double high, std::string_view otherwise,
                         std::string_view tip) {
    return {key, ParameterType::number, low, high, 0.05, 1, "", otherwise, "", tip};
}
/// The parameter of a whole number.
constexpr Parameter whole(std::string_view key, double low, double high, std::string_view otherwise,
                          std::string_view tip) {
    return {key, ParameterType::integer, low, high, 1, 1, "", otherwise, "", tip};
}
/// The parameter of `count` numbers.
constexpr Parameter several(std::string_view key, std::size_t count, std::string_view otherwise,
                            std::string_view tip) {
    return {key, ParameterType::numbers, -1e6, 1e6, 0.1, count, "", otherwise, "", tip};
}
/// The parameter of a choice.
constexpr Parameter one_of(std::string_view key, std::string_view otherwise,
                           std::string_view choices, std::string_view tip) {
    return {key, ParameterType::choice, 0, 0, 0, 1, "", otherwise, choices, tip};
}

/// The input of a number.
constexpr NodeInput a_number(std::string_view key, std::string_view tip,
                             std::string_view otherwise = {}) {
    return {key, Wire::number, false, otherwise, tip};
}
/// The input of a number or colour that sets what the node gives.
constexpr NodeInput any(std::string_view key, std::string_view tip,
                        std::string_view otherwise = {}) {
    return {key, Wire::color, true, otherwise, tip};
}

inline constexpr Inputs one_number{a_number("input", "a number")};
inline constexpr Inputs two_sides{any("a", "where the pattern is 0", "0"),
                                  any("b", "where the pattern is 1", "1")};
inline constexpr Inputs moved_input{any("input", "what is evaluated at the point made here")};

inline constexpr std::string_view slides = "Chuang 2008", pbrt = "pbrt (Chuang 2008)", own = "-";

// The families of nodes in the table's order, each defined in its file nodes_....cpp.
std::span<const NodeType> numbers();
std::span<const NodeType> colors();
std::span<const NodeType> patterns();
std::span<const NodeType> noises();
std::span<const NodeType> points();

}  // namespace burl::nodes
