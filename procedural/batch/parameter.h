#pragma once
// The description of one key of a recipe: its type, range and default. Tables of these describe
// recipes as a whole (app/recipe/parameters.h), the 1999 texture (procedural/model/texture_json.h)
// and the nodes of a texture graph (procedural/graph/table.h).
#include <cstddef>
#include <functional>
#include <string_view>
#include <typeinfo>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace burl {

enum class ParameterType {
    number,   ///< JSON number within [low, high]
    integer,  ///< whole JSON number within [low, high]
    numbers,  ///< array of `count` numbers, each within [low, high]
    text,     ///< any string
    choice,   ///< one of the words in `choices`
    color     ///< "#rrggbb", sRGB; "#rrggbbaa" as well where it may be transparent
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
    std::string_view label{};  ///< name of the editor's slider; empty: the key in words
    bool rare = false;         ///< whether few people need it, so that editors fold it away
    bool alpha = false;        ///< whether a colour may be transparent
};

/// A parameter that is a member of a struct (procedural/model/members.h).
struct MemberParameter : Parameter {
    const std::type_info* owner = nullptr;  ///< the struct; null for a parameter that is no member
    /// Sets the member of the struct at `owner` from JSON that has been checked.
    std::function<void(const nlohmann::ordered_json& json, void* owner)> read{};
    /// Returns the member of the struct at `owner` as JSON; null for a key that is left out.
    std::function<nlohmann::ordered_json(const void* owner)> write{};
};

/// "number", "integer", ... as the documentation calls it.
std::string_view to_string(ParameterType type);

/// Words of a list separated by "|".
std::vector<std::string_view> split_choices(std::string_view choices);

}  // namespace burl
