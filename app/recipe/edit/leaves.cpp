#include "app/recipe/edit/leaves.h"

#include <fmt/format.h>

#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/schema_check.h"
#include "atlas/base/json.h"
#include "procedural/graph/json.h"
#include "procedural/graph/table.h"

namespace burl {

namespace {

class LeafWalk {
  public:
    /// Visits the table's objects and arrays; arrays have the recipe's lengths.
    void walk_schema(const SchemaNode& node, const Json& value, const std::string& path,
                     const std::string& group) {
        for (const auto& [key, child] : node.children) {
            if (key == "stops" || child->elsewhere) continue;
            const std::string below = join(path, key);
            if (child->parameter)
                add(*child->parameter, value.is_object() ? value : empty_, key, below, group);
            else if (child->is_array())
                walk_items(*child->child("*"), at(value, key), below, key);
            else
                walk_schema(*child, at(value, key), below, std::string(key));
        }
    }

    /// Visits a node of a graph and all nodes below it.
    void walk_node(const Json& node, const std::string& path, const std::string& group) {
        if (node.is_array()) {
            for (std::size_t i = 0; i < node.size(); ++i)
                walk_node(node[i], fmt::format("{}.{}", path, i),
                          fmt::format("{} {}", group, i + 1));
            return;
        }
        if (!node.is_object() || !node.contains("node")) return;
        const std::string name = node["node"].get<std::string>();
        const NodeType* type = find_node(name);
        if (!type) return;
        const std::string title = group.empty() ? name : fmt::format("{} > {}", group, name);
        for (const Parameter& parameter : type->parameters())
            add(parameter, node, parameter.path, join(path, parameter.path), title);
        for (const NodeInput& input : type->inputs()) add_constant(input, node, path, title);
        for (const auto& [key, value] : node.items())
            if (key != "stops") walk_node(value, join(path, key), title);
        if (name == "field") walk_field(node, path, title);
    }

    std::vector<RecipeLeaf> leaves;

  private:
    static std::string join(const std::string& path, std::string_view key) {
        return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
    }
    const Json& at(const Json& value, std::string_view key) const {
        const std::string name(key);
        return value.is_object() && value.contains(name) ? value[name] : empty_;
    }

    /// Whether a node or a name stands in the place of a material's number or colour.
    static bool is_node_of(const Parameter& parameter, const Json& value) {
        const bool fixed =
            parameter.type == ParameterType::color || parameter.type == ParameterType::number;
        return fixed && is_graph_channel(value);
    }

    void add(const Parameter& parameter, const Json& owner, std::string_view key,
             const std::string& path, const std::string& group) {
        const std::string name(key);
        if (name == "node" || path == "burl") return;
        if (owner.contains(name) && is_node_of(parameter, owner[name])) return;
        // Tables are static, so the pointer owns nothing.
        RecipeLeaf leaf{path, group, name, {std::shared_ptr<void>(), &parameter}, {}};
        if (owner.contains(name))
            leaf.value = owner[name];
        else if (!parameter.default_value.empty())
            leaf.value = Json::parse(parameter.default_value);
        if (!leaf.value.is_null()) leaves.push_back(std::move(leaf));
    }

    /// Adds an input that is a constant number or colour, or left out with a constant as default.
    void add_constant(const NodeInput& input, const Json& node, const std::string& path,
                      const std::string& group) {
        const std::string name(input.key);
        Json value = node.contains(name)      ? node[name]
                     : input.fallback.empty() ? Json()
                                              : Json::parse(input.fallback);
        const bool color = value.is_string() && !is_graph_name(value);
        if (!value.is_number() && !color) return;
        const ParameterType type = color ? ParameterType::color : ParameterType::number;
        Parameter parameter{input.key, type, -1e6, 1e6, 0.05, 1, "", input.fallback, "", input.tip};
        parameter.alpha = color;
        leaves.push_back({join(path, name), group, name,
                          std::make_shared<const Parameter>(parameter), std::move(value)});
    }

    void walk_items(const SchemaNode& item, const Json& array, const std::string& path,
                    std::string_view name) {
        if (!array.is_array()) return;
        for (std::size_t i = 0; i < array.size(); ++i)
            walk_schema(item, array[i], fmt::format("{}.{}", path, i),
                        fmt::format("{} {}", name, i + 1));
    }

    /// Visits a graph's node `field`, which has the keys of the 1999 model's field.
    void walk_field(const Json& node, const std::string& path, const std::string& group) {
        const SchemaNode* field = recipe_schema().child("texture")->child("input");
        for (const char* key : {"quadric", "noise"}) {
            const SchemaNode* child = field->child(key);
            const std::string below = join(path, key), title = fmt::format("{} > {}", group, key);
            if (child->is_array())
                walk_items(*child->child("*"), at(node, key), below, title);
            else
                walk_schema(*child, at(node, key), below, title);
        }
    }

    Json empty_ = Json::object();
};

void find_maps(const Json& node, const std::string& path, std::vector<std::string>& paths) {
    if (node.is_object() && node.contains("stops")) paths.push_back(path);
    if (!node.is_structured()) return;
    for (const auto& [key, value] : node.items())
        find_maps(value, path.empty() ? key : fmt::format("{}.{}", path, key), paths);
}

}  // namespace

Json slider_json(const Recipe& recipe) {
    Recipe bare = recipe;
    bare.paint.clear();
    bare.animation = {};
    return Json::parse(to_json(bare));
}

std::vector<RecipeLeaf> recipe_leaves(const Json& recipe) {
    const bool graph = recipe.contains("texture") && is_graph(recipe["texture"]);
    LeafWalk walk;
    SchemaNode schema = build_schema();
    std::erase_if(schema.children, [&](const auto& child) {
        return (graph && child.first == "texture") || child.first == "paint" ||
               child.first == "animation" || child.first == "controls" ||
               (child.first == "bump" && !recipe.contains("bump"));
    });
    walk.walk_schema(schema, recipe, "", "recipe");
    if (graph) walk.walk_node(recipe["texture"], "texture", "");
    for (const char* part : {"define", "material"})
        if (recipe.contains(part))
            for (const auto& [key, value] : recipe[part].items())
                if (value.is_object()) walk.walk_node(value, fmt::format("{}.{}", part, key), key);
    if (recipe.contains("bump") && recipe["bump"].contains("input"))
        walk.walk_node(recipe["bump"]["input"], "bump.input", "bump");
    return std::move(walk.leaves);
}

std::vector<std::string> color_map_paths(const Json& recipe) {
    std::vector<std::string> paths;
    find_maps(recipe, "", paths);
    return paths;
}

}  // namespace burl
