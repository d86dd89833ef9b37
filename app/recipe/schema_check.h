#pragma once
// Checks JSON against the parameter table's tree; the first problem is one sentence that says what
// is there and what must be there.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/base/json_text.h"
#include "app/recipe/schema_tree.h"

namespace burl {

struct RecipeProblem {
    std::string path;      ///< dotted, such as "texture.input.noise.0.gain"; empty for the root
    std::string sentence;  ///< the problem, with the path, the value and what is allowed
};

/// The first problem of the value at `path` and all below it, against a node of the schema.
std::optional<RecipeProblem> check_value(const SchemaNode& node, const Json& value,
                                         const std::string& path);

/// The problem of one parameter's value.
std::optional<RecipeProblem> check_leaf(const Parameter& parameter, const Json& value,
                                        const std::string& path);

/// The problem "path is value, must be wanted".
RecipeProblem mismatch(const std::string& path, const Json& value, const std::string& wanted);

/// The problem "unknown key ...", with the nearest known key or a list of all.
RecipeProblem unknown_key(const std::vector<std::string_view>& known, const std::string& key,
                          const std::string& path);

/// The dotted path "path.key", or the key alone where the path is empty.
std::string join_path(const std::string& path, std::string_view key);

/// The value as messages show it, at most 60 characters.
std::string shown(const Json& value);

}  // namespace burl
