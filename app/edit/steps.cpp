// Steps that add, replace and delete nodes.
#include "app/edit/steps.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "app/edit/node_kinds.h"
#include "app/edit/tree.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/schema_check.h"
#include "procedural/graph/json.h"

namespace burl {

namespace {

constexpr const char* doomed_key = "\x03";

bool takes(const RecipeTree& tree, const NodeInput& input, const Json& value) {
    return input.wire == Wire::color || tree.gives(value) == Wire::number;
}

/// Whether the value is a node or a name, of which a step loses none.
bool is_wired(const Json& value) {
    return is_graph_name(value) || (is_node(value) && !is_constant(value));
}

/// The input of a new node that goes on with what stood in its place; null: none.
const NodeInput* input_for(const RecipeTree& tree, const NewNode& node, const Json& old) {
    const NodeInput* unfit = nullptr;
    for (const NodeInput* input : leading_inputs(type_of(node.json))) {
        if (std::ranges::count(node.given, input->key) > 0) continue;
        if (takes(tree, *input, old)) return input;
        if (!unfit && is_wired(old)) unfit = input;
    }
    return unfit;
}

/// Puts a value into an input of a node that stands at no place yet.
void set_input(const RecipeTree& tree, Json& node, const NodeInput& input, Json value) {
    const bool fits = takes(tree, input, value);
    node[std::string(input.key)] = fits ? std::move(value) : luminance_of(std::move(value));
}

/// Adds a node that nothing uses, under a name.
std::string add_loose(RecipeTree& tree, Json node) {
    const std::string name = tree.free_name(std::string(type_of(node).name));
    tree.add_name(name, std::move(node));
    return "define." + name;
}

/// Replaces a name by another name or by nothing wherever it stands, and drops it.
void dissolve(RecipeTree& tree, const std::string& name, const Json& by) {
    for (const std::string& use : tree.uses(name)) {
        if (by.is_null())
            tree.vacate(use);
        else
            tree.put(use, by);
    }
    tree.remove_name(name);
}

/// The successor of a node that goes: null where there is none.
Json heir_of(const RecipeTree& tree, const Json& node, const std::string& place) {
    for (const bool wired : {true, false})
        for (const NodeInput* input : leading_inputs(type_of(node))) {
            if (!node.contains(input->key)) continue;
            const Json& value = node[std::string(input->key)];
            if (tree.fits(value, place) && is_wired(value) == wired) return value;
        }
    return {};
}

void delete_node(RecipeTree& tree, const std::string& place) {
    const Json node = tree.at(place);
    const std::string name = defined_at(place);
    Json heir = is_node(node) ? heir_of(tree, node, place) : Json();
    const bool bare = !heir.is_null() && !is_wired(heir);
    if (!name.empty()) {
        if (bare || heir.is_null() || is_graph_name(heir))
            dissolve(tree, name, bare ? Json() : heir);
        else
            tree.put(place, std::move(heir));
    } else if (heir.is_null() || (bare && place.starts_with("material."))) {
        tree.vacate(place);
    } else {
        tree.put(place, std::move(heir));
    }
}

/// The place of a node that is to be deleted, none of those that it is made of; empty: none is
/// left.
std::string next_doomed(RecipeTree& tree) {
    std::string found;
    tree.visit([&](const std::string& place, Json& value) {
        if (value.is_object() && value.contains(doomed_key)) found = place;
    });
    return found;
}

/// Gives a new node the parameters and inputs of an old one that have the same keys.
void keep_same(const RecipeTree& tree, NewNode& node, Json& old) {
    const NodeType& type = type_of(node.json);
    for (const Parameter& parameter : type.parameters()) {
        const std::string key(parameter.path);
        if (std::ranges::count(node.given, key) == 0 && old.contains(key) &&
            !check_leaf(parameter, old[key], key))
            node.json[key] = old[key];
    }
    for (const NodeInput& input : type.inputs()) {
        const std::string key(input.key);
        if (std::ranges::count(node.given, key) > 0 || !old.contains(key)) continue;
        if (!takes(tree, input, old[key])) continue;
        node.json[key] = std::move(old[key]);
        node.given.push_back(key);
        old.erase(key);
    }
}

/// Puts the nodes that are left of an old node's inputs into inputs of a new one, and keeps those
/// that find none under names.
void keep_others(RecipeTree& tree, NewNode& node, const Json& old) {
    for (const NodeInput* input : leading_inputs(type_of(old))) {
        if (!old.contains(input->key)) continue;
        const Json& value = old[std::string(input->key)];
        if (!is_wired(value)) continue;
        if (const NodeInput* free = input_for(tree, node, value)) {
            set_input(tree, node.json, *free, value);
            node.given.emplace_back(free->key);
        } else if (is_node(value)) {
            add_loose(tree, value);
        }
    }
}

}  // namespace

Recipe new_recipe(const Recipe& like) {
    Recipe recipe = parse_recipe(
        R"({"burl": 1, "name": "new", "texture": {"node": "constant", "value": "#9a948c"}})",
        "new");
    recipe.atlas = like.atlas;
    recipe.filter = like.filter;
    recipe.pose = like.pose;
    return recipe;
}

GraphEdit add_node(const Recipe& recipe, const std::string& place, const std::string& text,
                   const std::string& origin) {
    RecipeTree tree(recipe);
    NewNode node = new_node(text);
    const std::string words = fmt::format("add {}", spoken(type_of(node.json).name));
    if (place.empty()) {
        const std::string path = add_loose(tree, std::move(node.json));
        return tree.finish(words, path, origin);
    }
    const Json old = tree.content(place);
    const NodeInput* input = old.is_null() ? nullptr : input_for(tree, node, old);
    if (input)
        set_input(tree, node.json, *input, old);
    else
        tree.keep_under_name(place);
    const std::string path = tree.put(place, std::move(node.json));
    return tree.finish(words, path, origin);
}

GraphEdit add_node_after(const Recipe& recipe, const std::string& from, const std::string& text,
                         const std::string& origin) {
    const NewNode node = new_node(text);
    const RecipeTree tree(recipe);
    const Json* value = tree.find(from);
    const NodeInput* input = value ? input_for(tree, node, *value) : nullptr;
    if (!input) {
        const std::string name = spoken(type_of(node.json).name);
        refuse_edit(fmt::format("{} has no input that is free; choose another node", name));
    }
    const GraphEdit added = add_node(recipe, "", text, origin);
    GraphEdit edit =
        connect(added.recipe, from, fmt::format("{}.{}", added.path, std::string(input->key)));
    edit.words = fmt::format("{} after {}", added.words, RecipeTree::called(*value, from));
    edit.path = added.path;
    edit.lost.insert(edit.lost.begin(), added.lost.begin(), added.lost.end());
    return edit;
}

GraphEdit delete_nodes(const Recipe& recipe, const std::vector<std::string>& places) {
    RecipeTree tree(recipe);
    if (places.empty()) refuse_edit("no node is chosen; choose one to delete");
    std::vector<std::string> names;
    for (const std::string& place : places) {
        Json& value = tree.at(place);
        names.push_back(RecipeTree::called(value, place));
        if (value.is_object()) value[doomed_key] = true;
    }
    for (const std::string& place : places)
        if (const Json* value = tree.find(place); value && is_graph_name(*value))
            tree.vacate(place);
    for (std::string next = next_doomed(tree); !next.empty(); next = next_doomed(tree))
        delete_node(tree, next);
    const std::string words = names.size() == 1 ? fmt::format("delete {}", names[0])
                                                : fmt::format("delete {} nodes", names.size());
    return tree.finish(words, places.size() == 1 ? places[0] : "");
}

GraphEdit replace_node(const Recipe& recipe, const std::string& place, const std::string& text,
                       const std::string& origin) {
    RecipeTree tree(recipe);
    NewNode node = new_node(text);
    Json old = tree.at(place);
    if (is_graph_name(old))
        return replace_node(recipe, "define." + old.get<std::string>(), text, origin);
    const std::string words = fmt::format("replace {} by {}", RecipeTree::called(old, place),
                                          spoken(type_of(node.json).name));
    take_marks(node.json, old);
    keep_same(tree, node, old);
    keep_others(tree, node, old);
    const std::string path = tree.put(place, std::move(node.json));
    return tree.finish(words, path, origin);
}

GraphEdit add_channel(const Recipe& recipe, const std::string& channel) {
    RecipeTree tree(recipe);
    const std::string place = channel == "height" ? "bump.input" : "material." + channel;
    const Json now = channel == "height" && !tree.find(place) ? Json(0.0) : tree.content(place);
    if (now.is_null()) refuse_edit(fmt::format("a material has no channel \"{}\"", channel));
    if (is_wired(now)) refuse_edit(fmt::format("{} is a node already", spoken(channel)));
    tree.put(place, without_marks(now));
    return tree.finish(fmt::format("add {}", spoken(channel)), place);
}

GraphEdit remove_channel(const Recipe& recipe, const std::string& channel) {
    RecipeTree tree(recipe);
    const std::string place = channel == "height" ? "bump.input" : "material." + channel;
    if (!tree.find(place))
        refuse_edit(fmt::format("the material has no node for {}", spoken(channel)));
    tree.vacate(place);
    return tree.finish(fmt::format("remove {}", spoken(channel)), "");
}

}  // namespace burl
