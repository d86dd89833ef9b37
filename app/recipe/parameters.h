#pragma once
// The one table of a recipe's parameters, those of its texture (procedural/model/texture_json.h)
// among them. It says which keys the JSON knows, what values they take, what they mean and which
// members of a recipe's structs they are; reading and writing JSON, --set, range checks, `burl list
// parameters`, the command line's options, the editor's sliders and docs/reference/recipes.md
// follow it. Graphs that are no plain ones follow the table of nodes (procedural/graph/table.h).
#include <span>
#include <string>
#include <string_view>

#include "procedural/batch/parameter.h"

namespace burl {

struct Recipe;

/// The parameter's own option on the command line.
struct ParameterUse {
    std::string_view option{};  ///< its name, as "-s,--size"; empty: --set alone
    std::string_view help{};    ///< its line in --help, where "{}" stands for the choices
    /// Returns why the parameter has no effect on the recipe's textures, and what to do about it;
    /// empty where it has an effect. Null: the parameter always has one.
    std::string (*idle)(const Recipe& recipe) = nullptr;
};

/// A row of the table.
struct RecipeParameter : MemberParameter {
    ParameterUse use{};
};

/// The table, in the order of the JSON.
std::span<const RecipeParameter> parameters();

/// The parameter at a path with indices in place of "*"; null where there is none.
const RecipeParameter* find_parameter(std::string_view path);

}  // namespace burl
