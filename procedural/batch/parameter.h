#pragma once
// The description of one key of a recipe: its type, range and default. Tables of these describe
// recipes as a whole (app/recipe/parameters.h) and the nodes of a texture graph
// (procedural/graph/table.h).
#include <cstddef>
#include <string_view>

namespace burl {

enum class ParameterType {
    number,   ///< JSON number within [low, high]
    integer,  ///< whole JSON number within [low, high]
    numbers,  ///< array of `count` numbers, each within [low, high]
    text,     ///< any string
    choice,   ///< one of the words in `choices`
    color     ///< "#rrggbb", sRGB
};

struct Parameter {
    /// Dotted path in the JSON; "*" stands for an array's index, as in "texture.stops.*.0".
    std::string_view path;
    ParameterType type = ParameterType::number;
    double low = 0.0, high = 0.0;  ///< inclusive bounds of the numbers
    double step = 0.0;             ///< change of the value per notch of a slider
    std::size_t count = 1;         ///< length of an array of `numbers`
    std::string_view unit;
    std::string_view default_value;  ///< JSON; empty where the key may be absent or is required
    std::string_view choices;        ///< words of a `choice`, separated by "|"
    std::string_view tip;
};

}  // namespace burl
