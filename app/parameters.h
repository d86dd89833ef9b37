#pragma once
// The one table of a recipe's parameters. It says which keys the JSON knows, what values they take
// and what they mean; `burl list parameters`, --set, range checks and docs/recipes.md follow it.
#include <span>
#include <string>
#include <string_view>
#include <vector>

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

/// In the order of the JSON.
std::span<const Parameter> parameters();

/// "number", "integer", ... as the documentation calls it.
std::string_view to_string(ParameterType type);

/// Words of a list separated by "|".
std::vector<std::string_view> split_choices(std::string_view choices);

/// The candidate with the smallest edit distance to `word`; empty when there is none that shares
/// more than it lacks.
std::string_view nearest_word(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace burl
