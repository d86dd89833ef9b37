#pragma once
// What one key of a recipe may hold: recipes as a whole (app/recipe/parameters.h) and the nodes of
// a texture graph (graph_table.h) are described by tables of it.
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
    double low = 0.0, high = 0.0;  ///< inclusive
    double step = 0.0;             ///< what one notch of a slider moves it by
    std::size_t count = 1;         ///< of `numbers`
    std::string_view unit;
    std::string_view default_value;  ///< as JSON; empty where the key is left out or required
    std::string_view choices;        ///< separated by "|"
    std::string_view tip;
};

}  // namespace burl
