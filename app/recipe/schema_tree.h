#pragma once
// The parameter table as a tree that follows the JSON.
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

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

/// The parts of a dotted path: at least one, possibly empty.
std::vector<std::string_view> split_path(std::string_view path);

}  // namespace burl
