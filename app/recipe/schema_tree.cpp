#include "app/recipe/schema_tree.h"

#include <algorithm>

namespace burl {

std::vector<std::string_view> split_path(std::string_view path) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0; begin <= path.size();) {
        const std::size_t end = std::min(path.find('.', begin), path.size());
        parts.push_back(path.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

namespace {

/// The node at a path, created where it is missing.
SchemaNode& place(SchemaNode& root, std::string_view path) {
    SchemaNode* node = &root;
    for (const std::string_view part : split_path(path)) {
        if (!node->child(part)) node->children.emplace_back(part, std::make_unique<SchemaNode>());
        node = const_cast<SchemaNode*>(node->child(part));
    }
    return *node;
}

}  // namespace

SchemaNode build_schema() {
    SchemaNode root;
    for (const Parameter& parameter : parameters())
        place(root, parameter.path).parameter = &parameter;
    place(root, "bump.input").elsewhere = true;  // a graph, which graph_check.h checks
    return root;
}

const SchemaNode& recipe_schema() {
    static const SchemaNode schema = build_schema();
    return schema;
}

}  // namespace burl
