#pragma once
// The parameter table as a tree that follows the JSON, and checks of JSON against it; the first
// problem is one sentence that says what is there and what must be there.
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/base/json_text.h"
#include "app/recipe/parameters.h"

namespace burl {

/// A node of the schema: a leaf (one parameter), an array of items of one schema (single child
/// "*"), a tuple (children "0", "1", ...) or an object.
struct SchemaNode {
    const Parameter* parameter = nullptr;
    bool elsewhere = false;  ///< the content is checked by another function
    std::vector<std::pair<std::string_view, std::unique_ptr<SchemaNode>>> children;

    const SchemaNode* child(std::string_view key) const {
        for (const auto& [name, node] : children)
            if (name == key) return node.get();
        return nullptr;
    }
    std::vector<std::string_view> keys() const {
        std::vector<std::string_view> names;
        for (const auto& [name, node] : children) names.push_back(name);
        return names;
    }
    bool is_array() const { return children.size() == 1 && children[0].first == "*"; }
    bool is_tuple() const { return !children.empty() && children[0].first == "0"; }
};

/// The tree of parameters().
SchemaNode build_schema();

/// The tree of parameters(), made once.
const SchemaNode& recipe_schema();

/// The value of a key of the recipe; an empty object where it is left out.
const Json& part_of(const Json& recipe, const char* key);

/// The recipe's "material" without the channels that are nodes.
Json without_channel_nodes(Json material);

/// The parts of a dotted path: at least one, possibly empty.
std::vector<std::string_view> split_path(std::string_view path);

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
