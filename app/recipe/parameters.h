#pragma once
// The one table of a recipe's parameters. It says which keys the JSON knows, what values they take,
// what they mean and which members of the Recipe they are; reading and writing JSON, --set, range
// checks, `burl list parameters`, the command line's options, the editor's sliders and
// docs/reference/recipes.md follow it.
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <typeinfo>
#include <vector>

#include "app/base/json_text.h"
#include "procedural/batch/parameter.h"

namespace burl {

struct Recipe;

/// How people meet a parameter outside the JSON.
struct ParameterUse {
    /// The parameter's own option on the command line, as "-s,--size"; empty: --set alone.
    std::string_view option{};
    /// The option's line in --help, where "{}" stands for the choices.
    std::string_view help{};
    /// The name of the editor's slider; empty: the key in words.
    std::string_view label{};
    /// Whether few people need the parameter, so that editors fold it away.
    bool rare = false;
    /// Whether the parameter has no default.
    bool required = false;
    /// Returns why the parameter has no effect on the recipe's textures, and what to do about it;
    /// empty where it has an effect. Null: the parameter always has one.
    std::string (*idle)(const Recipe& recipe) = nullptr;
};

/// A row of the table. `owner` is the struct whose member the parameter is, null for a parameter
/// that is none; read() and write() take a pointer to such a struct.
struct RecipeParameter : Parameter {
    ParameterUse use{};
    const std::type_info* owner = nullptr;
    /// Sets the member from JSON that has been checked.
    std::function<void(const Json& json, void* owner)> read{};
    /// Returns the member as JSON; null for a key that is left out.
    std::function<Json(const void* owner)> write{};
};

/// The table, in the order of the JSON.
std::span<const RecipeParameter> parameters();

/// The parameter at a path with indices in place of "*"; null where there is none.
const RecipeParameter* find_parameter(std::string_view path);

/// "number", "integer", ... as the documentation calls it.
std::string_view to_string(ParameterType type);

/// Words of a list separated by "|".
std::vector<std::string_view> split_choices(std::string_view choices);

}  // namespace burl
