#pragma once
// Checks JSON against the parameter table's tree, one sentence for the first thing that is wrong:
// what is there, what must be there.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/base/json_text.h"
#include "app/recipe/schema_tree.h"

namespace burl {

struct RecipeProblem {
    std::string path;      ///< dotted, such as "texture.input.noise.0.gain"; empty for the root
    std::string sentence;  ///< names the path, the value and what is allowed
};

/// The value at `path` against a node of the schema and all below it.
std::optional<RecipeProblem> check_value(const SchemaNode& node, const Json& value,
                                         const std::string& path);

/// One parameter's value.
std::optional<RecipeProblem> check_leaf(const Parameter& parameter, const Json& value,
                                        const std::string& path);

/// "path is value, must be wanted".
RecipeProblem mismatch(const std::string& path, const Json& value, const std::string& wanted);

/// "unknown key ...", with the nearest known one or all of them.
RecipeProblem unknown_key(const std::vector<std::string_view>& known, const std::string& key,
                          const std::string& path);

std::string join_path(const std::string& path, std::string_view key);

/// A value as messages show it: not more than a line of it.
std::string shown(const Json& value);

}  // namespace burl
