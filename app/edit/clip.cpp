#include "app/edit/clip.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "app/edit/node_kinds.h"
#include "app/edit/tree.h"
#include "app/recipe/edit/check.h"
#include "app/recipe/schema_check.h"
#include "procedural/graph/json.h"

namespace burl {

namespace {

constexpr const char* version_key = "burl_nodes";

using Names = std::map<std::string, std::string>;

/// Calls visit(name) for every name in a node and below it, which it may change.
template <class Visit>
void for_each_name(Json& value, const Visit& visit) {
    if (is_graph_name(value)) visit(value);
    if (!is_node(value)) return;
    for (const NodeInput& input : type_of(value).inputs())
        if (value.contains(input.key)) for_each_name(value[std::string(input.key)], visit);
}

/// Adds the nodes of the names that a node uses, and of those that they use.
void add_names(const RecipeTree& tree, Json node, Json& define) {
    for_each_name(node, [&](const Json& name) {
        const std::string key = name.get<std::string>();
        if (define.contains(key)) return;
        define[key] = without_marks(tree.names()[key]);
        add_names(tree, define[key], define);
    });
}

/// Whether a place lies below another one of a set.
bool lies_below(const std::string& place, const std::set<std::string>& set) {
    return std::ranges::any_of(
        set, [&](const std::string& other) { return place.starts_with(other + "."); });
}

/// The JSON of copied nodes; a single node is a list of one.
Json clip_of(const std::string& text) {
    const Json json = parse_json_value(text);
    if (is_node(json)) return {{version_key, 1}, {"nodes", Json::array({json})}};
    const bool fits = json.is_object() && json.contains(version_key) && json.contains("nodes") &&
                      json["nodes"].is_array() && !json["nodes"].empty();
    return fits ? json : Json();
}

/// Throws Error(usage) unless the nodes, with their names, make a valid recipe.
void check_clip(const Json& clip) {
    for (const Json& node : clip["nodes"]) {
        if (!is_node(node)) refuse_edit("the clipboard has something that is no node");
        Json recipe{{"burl", 1}, {"texture", node}};
        if (clip.contains("define")) recipe["define"] = clip["define"];
        if (const auto problem = find_problem(recipe))
            refuse_edit("the clipboard: " + problem->sentence);
    }
}

/// The names of pasted nodes in a recipe: a name is used again where it means the same there.
Names names_in(const RecipeTree& tree, const Json& define) {
    Names names;
    for (const auto& item : define.items()) {
        const bool same = tree.names().contains(item.key()) &&
                          without_marks(tree.names()[item.key()]) == item.value();
        names[item.key()] = same ? item.key() : tree.free_name(item.key());
    }
    return names;
}

Json renamed(Json node, const Names& names) {
    for_each_name(node, [&](Json& name) {
        if (const auto found = names.find(name.get<std::string>()); found != names.end())
            name = found->second;
    });
    return node;
}

}  // namespace

std::string copy_nodes(const Recipe& recipe, const std::vector<std::string>& places) {
    const RecipeTree tree(recipe);
    if (places.empty()) refuse_edit("no node is chosen; choose one to copy");
    const std::set<std::string> set(places.begin(), places.end());
    Json define = Json::object(), nodes = Json::array();
    for (const std::string& place : set) {
        const Json* value = tree.find(place);
        if (!value) refuse_edit(fmt::format("nothing stands at \"{}\"", place));
        if (lies_below(place, set)) continue;
        const Json& node = is_graph_name(*value) ? tree.names()[value->get<std::string>()] : *value;
        nodes.push_back(is_constant(node) ? node : without_marks(node));
        add_names(tree, nodes.back(), define);
    }
    for (const std::string& place : set)
        if (const std::string name = defined_at(place); define.contains(name))
            std::erase(nodes.get_ref<Json::array_t&>(), define[name]);
    Json clip{{version_key, 1}};
    if (!define.empty()) clip["define"] = std::move(define);
    clip["nodes"] = std::move(nodes);
    return print_json(clip);
}

bool holds_nodes(const std::string& text) {
    return !clip_of(text).is_null();
}

GraphEdit paste_nodes(const Recipe& recipe, const std::string& place, const std::string& text,
                      const std::string& origin) {
    const Json clip = clip_of(text);
    if (clip.is_null()) refuse_edit("the clipboard has no nodes; copy some first");
    check_clip(clip);
    RecipeTree tree(recipe);
    const Json& define = part_of(clip, "define");
    const Names names = names_in(tree, define);
    for (const auto& [old, name] : names)
        if (!tree.names().contains(name)) tree.add_name(name, renamed(define[old], names));
    std::string path;
    for (const Json& node : clip["nodes"]) {
        Json value = renamed(node, names);
        if (path.empty() && !place.empty()) {
            tree.keep_under_name(place);
            path = tree.put(place, std::move(value));
            continue;
        }
        const std::string name = tree.free_name(std::string(type_of(value).name));
        tree.add_name(name, std::move(value));
        if (path.empty()) path = "define." + name;
    }
    const std::size_t count = clip["nodes"].size();
    const std::string what =
        count == 1 ? spoken(type_of(clip["nodes"][0]).name) : fmt::format("{} nodes", count);
    return tree.finish("paste " + what, path, origin);
}

}  // namespace burl
