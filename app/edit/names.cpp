// Steps that name nodes and groups of them (steps.h).
#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "app/edit/steps.h"
#include "app/edit/tree.h"
#include "procedural/graph/json.h"

namespace burl {

namespace {

/// Throws Error(usage) where "define" cannot have a name.
void check_name(const RecipeTree& tree, const std::string& name) {
    if (name.empty() || name[0] == '#' || name.find('.') != std::string::npos)
        refuse_edit(fmt::format(
            "\"{}\" is no name: it must not be empty, begin with # or have a dot", name));
    if (tree.names().contains(name))
        refuse_edit(fmt::format("\"{}\" is the name of another node; take another one", name));
}

GraphEdit rename(const Recipe& recipe, const std::string& name, const std::string& to) {
    RecipeTree tree(recipe);
    if (!tree.names().contains(name)) refuse_edit(fmt::format("nothing is called \"{}\"", name));
    check_name(tree, to);
    Json node = tree.names()[name];
    tree.add_name(to, std::move(node));
    for (const std::string& use : tree.uses(name)) tree.at(use) = to;
    tree.remove_name(name);
    return tree.finish(fmt::format("rename {} to {}", name, to), "define." + to);
}

/// The place of the node that has a place as its input; empty for a part of the recipe.
std::string owner_of(const RecipeTree& tree, const std::string& place) {
    const std::string front = place.substr(0, std::min(place.rfind('.'), place.size()));
    const Json* owner = tree.find(front);
    return front != place && owner && is_node(*owner) ? front : "";
}

/// Whether something outside of a set uses the node at a place, or nothing does.
bool is_result(const RecipeTree& tree, const std::string& place, const std::set<std::string>& set) {
    const std::string name = defined_at(place);
    const auto outside = [&](const std::string& use) { return !set.contains(owner_of(tree, use)); };
    if (name.empty()) return outside(place);
    const std::vector<std::string> uses = tree.uses(name);
    return uses.empty() || std::ranges::any_of(uses, outside);
}

}  // namespace

GraphEdit name_node(const Recipe& recipe, const std::string& place, const std::string& name) {
    if (const std::string old = defined_at(place); !old.empty()) return rename(recipe, old, name);
    RecipeTree tree(recipe);
    Json& value = tree.at(place);
    if (is_graph_name(value)) return rename(recipe, value.get<std::string>(), name);
    check_name(tree, name);
    const std::string words = fmt::format("name {} {}", RecipeTree::called(value, place), name);
    Json node = std::exchange(value, name);
    tree.add_name(name, std::move(node));
    return tree.finish(words, "define." + name);
}

GraphEdit inline_name(const Recipe& recipe, const std::string& name) {
    RecipeTree tree(recipe);
    if (!tree.names().contains(name)) refuse_edit(fmt::format("nothing is called \"{}\"", name));
    const std::vector<std::string> uses = tree.uses(name);
    if (uses.empty()) refuse_edit(fmt::format("nothing uses {}; delete it, or connect it", name));
    const Json node = tree.names()[name];
    for (const std::string& use : uses) tree.put(use, node);
    tree.remove_name(name);
    return tree.finish(fmt::format("write {} out", name), uses.front());
}

GraphEdit group_nodes(const Recipe& recipe, const std::vector<std::string>& places,
                      const std::string& name) {
    RecipeTree tree(recipe);
    std::set<std::string> set;
    for (const std::string& place : places) {
        const Json& value = tree.at(place);
        set.insert(is_graph_name(value) ? "define." + value.get<std::string>() : place);
    }
    std::vector<std::string> results, called;
    for (const std::string& place : set)
        if (is_result(tree, place, set)) {
            results.push_back(place);
            called.push_back(RecipeTree::called(tree.at(place), place));
        }
    if (results.size() != 1)
        refuse_edit(results.empty()
                        ? std::string("no node is chosen; choose those of a group")
                        : fmt::format("these nodes have {} results, {}; a group has one",
                                      results.size(), fmt::join(called, ", ")));
    GraphEdit edit = name_node(recipe, results[0], name);
    edit.words = fmt::format("group {}", name);
    return edit;
}

}  // namespace burl
