#include "app/edit/tree.h"

#include <utility>

#include <fmt/format.h>

#include "app/edit/node_kinds.h"
#include "app/recipe/edit/check.h"
#include "app/recipe/edit/images.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/schema_check.h"
#include "atlas/base/error.h"
#include "procedural/graph/json.h"

namespace burl {

namespace {

constexpr const char* grey = "#808080";

bool is_color_text(const Json& value) {
    return value.is_string() && value.get_ref<const std::string&>().starts_with('#');
}

/// A number or colour as a constant node; so are those in the inputs of a node and below.
Json expanded(Json value) {
    if (value.is_number() || is_color_text(value))
        return {{"node", "constant"}, {"value", std::move(value)}};
    if (!is_node(value)) return value;
    for (const NodeInput& input : type_of(value).inputs()) {
        const std::string key(input.key);
        if (value.contains(key)) value[key] = expanded(std::move(value[key]));
    }
    return value;
}

/// The last part of a path, and what is before it; a path without dots has an empty front.
std::pair<std::string, std::string> front_and_key(const std::string& path) {
    const std::size_t dot = path.rfind('.');
    if (dot == std::string::npos) return {"", path};
    return {path.substr(0, dot), path.substr(dot + 1)};
}

/// The channel of a place "material.CHANNEL"; the number of channels for any other place.
std::size_t channel_of(const std::string& place) {
    const auto [front, key] = front_and_key(place);
    std::size_t i = enum_names<Channel>.size();
    if (front != "material") return i;
    for (i = 0; i < enum_names<Channel>.size(); ++i)
        if (enum_names<Channel>[i] == key) break;
    return i;
}

const Json* look_up(const Json& tree, const std::string& place) {
    const Json* at = &tree;
    for (const std::string_view part : split_path(place)) {
        if (!at->is_object()) return nullptr;
        const auto found = at->find(std::string(part));
        if (found == at->end()) return nullptr;
        at = &*found;
    }
    return at;
}

bool is_root(const std::string& place) {
    return place == "texture" || place == "bump.input" || place.starts_with("define.") ||
           channel_of(place) < enum_names<Channel>.size();
}

/// The parts of a recipe whose values are nodes, with the places of those.
std::vector<std::string> roots_of(const Json& tree) {
    std::vector<std::string> roots{"texture"};
    if (tree.contains("material"))
        for (const auto& item : tree["material"].items())
            if (is_root("material." + item.key())) roots.push_back("material." + item.key());
    if (look_up(tree, "bump.input")) roots.emplace_back("bump.input");
    if (tree.contains("define"))
        for (const auto& item : tree["define"].items()) roots.push_back("define." + item.key());
    return roots;
}

void visit_below(const std::string& place, Json& value, const RecipeTree::Visit& visit) {
    visit(place, value);
    if (!is_node(value)) return;
    for (const NodeInput& input : type_of(value).inputs())
        if (value.contains(input.key))
            visit_below(join_path(place, input.key), value[std::string(input.key)], visit);
}

}  // namespace

bool is_node(const Json& value) {
    return value.is_object() && value.contains("node") && value["node"].is_string() &&
           find_node(value["node"].get_ref<const std::string&>());
}

const NodeType& type_of(const Json& node) {
    return *find_node(node["node"].get_ref<const std::string&>());
}

bool is_constant(const Json& value) {
    return is_node(value) && type_of(value).name == "constant";
}

Json luminance_of(Json color) {
    return {{"node", "split"}, {"channel", "luminance"}, {"input", std::move(color)}};
}

std::string defined_at(const std::string& place) {
    const auto [front, key] = front_and_key(place);
    return front == "define" ? key : "";
}

void refuse_edit(const std::string& sentence) {
    throw Error(ExitCode::usage, sentence);
}

RecipeTree::RecipeTree(const Recipe& recipe) : recipe_(recipe) {
    Recipe bare = recipe;
    bare.paint.clear();
    tree_ = Json::parse(to_json(bare));
    for (const std::string& root : roots_of(tree_)) {
        Json& value = *const_cast<Json*>(look_up(tree_, root));
        const bool is_bare = !is_graph_channel(value) && root.starts_with("material.");
        value = expanded(std::move(value));
        if (is_bare) value[bare_key] = true;
    }
    marks_.emplace(tree_);
}

const Json* RecipeTree::find(const std::string& place) const {
    if (!is_root(place)) {
        const auto [front, key] = front_and_key(place);
        const Json* owner = front.empty() ? nullptr : find(front);
        if (!owner || !is_node(*owner) || !type_of(*owner).input(key)) return nullptr;
    }
    return look_up(tree_, place);
}

Json& RecipeTree::at(const std::string& place) {
    const Json* value = find(place);
    if (!value) refuse_edit(fmt::format("nothing stands at \"{}\"", place));
    return const_cast<Json&>(*value);
}

Json RecipeTree::content(const std::string& place) const {
    if (const Json* value = find(place)) return *value;
    const RecipeParameter* parameter =
        place.starts_with("material.") ? find_parameter(place) : nullptr;
    return parameter ? Json::parse(parameter->default_value) : Json();
}

/// The object that has a place as its key; the channels' and the height's is made where missing.
Json& RecipeTree::owner_of(const std::string& place, std::string& key) {
    const auto [front, last] = front_and_key(place);
    key = last;
    if (place == "texture") return tree_;
    if (channel_of(place) < enum_names<Channel>.size() || place == "bump.input") {
        Json& owner = tree_[front];
        if (!owner.is_object()) owner = Json::object();
        return owner;
    }
    if (front == "define" && names().contains(key)) return tree_["define"];
    const Json* owner = front.empty() ? nullptr : find(front);
    if (!owner || !is_node(*owner) || !type_of(*owner).input(key))
        refuse_edit(fmt::format("\"{}\" is no input of a node", place));
    return const_cast<Json&>(*owner);
}

std::string RecipeTree::put(const std::string& place, Json value) {
    std::string key;
    Json& owner = owner_of(place, key);
    value = expanded(std::move(value));
    const bool fitting = fits(value, place);
    owner[key] = fitting ? std::move(value) : luminance_of(std::move(value));
    return fitting ? place : join_path(place, "input");
}

void RecipeTree::vacate(const std::string& place) {
    std::string key;
    Json& owner = owner_of(place, key);
    if (place == "bump.input")
        tree_.erase("bump");
    else if (is_node(owner))
        owner[key] = expanded(vacant_input(type_of(owner), *type_of(owner).input(key)));
    else if (place == "texture")
        owner[key] = expanded(grey);
    else if (place.starts_with("define."))
        owner[key] = expanded(gives(owner[key]) == Wire::number ? Json(0.0) : Json(grey));
    else
        owner.erase(key);
}

void RecipeTree::keep_under_name(const std::string& place) {
    const Json* old = find(place);
    if (!old || !is_node(*old) || is_constant(*old)) return;
    const Json kept = *old;
    add_name(free_name(std::string(type_of(kept).name)), kept);
}

std::string RecipeTree::called(const Json& value, const std::string& place) {
    if (std::string name = defined_at(place); !name.empty()) return name;
    if (is_graph_name(value)) return value.get<std::string>();
    return is_node(value) ? spoken(type_of(value).name) : "nothing";
}

Json RecipeTree::take(const std::string& place) {
    Json value = at(place);
    vacate(place);
    return value;
}

Wire RecipeTree::wanted(const std::string& place) const {
    if (const std::size_t channel = channel_of(place); channel < enum_names<Channel>.size())
        return is_color(Channel(channel)) ? Wire::color : Wire::number;
    if (place == "bump.input") return Wire::number;
    const auto [front, key] = front_and_key(place);
    if (front == "define") {
        for (const std::string& use : uses(key))
            if (wanted(use) == Wire::number) return Wire::number;
        return Wire::color;
    }
    const Json* owner = front.empty() ? nullptr : find(front);
    const NodeInput* input = owner && is_node(*owner) ? type_of(*owner).input(key) : nullptr;
    if (!input) return Wire::color;
    return input->sets_wire ? wanted(front) : input->wire;
}

Wire RecipeTree::gives(const Json& value) const {
    if (is_graph_name(value)) {
        const auto found = names().find(value.get_ref<const std::string&>());
        return found == names().end() ? Wire::number : gives(*found);
    }
    if (!is_node(value)) return value.is_string() ? Wire::color : Wire::number;
    const NodeType& type = type_of(value);
    if (type.result == NodeResult::number) return Wire::number;
    if (type.result == NodeResult::color) return Wire::color;
    if (type.name == "constant")
        return value.contains("value") && value["value"].is_string() ? Wire::color : Wire::number;
    for (const NodeInput& input : type.inputs())
        if (input.sets_wire && value.contains(input.key) &&
            gives(value[std::string(input.key)]) == Wire::color)
            return Wire::color;
    return Wire::number;
}

bool RecipeTree::fits(const Json& value, const std::string& place) const {
    return gives(value) == Wire::number || wanted(place) == Wire::color;
}

const Json& RecipeTree::names() const {
    return part_of(tree_, "define");
}

std::string RecipeTree::free_name(const std::string& wish) const {
    if (!names().contains(wish)) return wish;
    for (int number = 2;; ++number)
        if (std::string name = fmt::format("{}_{}", wish, number); !names().contains(name))
            return name;
}

void RecipeTree::add_name(const std::string& name, Json node) {
    tree_["define"][name] = expanded(std::move(node));
}

void RecipeTree::remove_name(const std::string& name) {
    tree_["define"].erase(name);
    if (tree_["define"].empty()) tree_.erase("define");
}

void RecipeTree::visit(const Visit& visit) {
    for (const std::string& root : roots_of(tree_))
        visit_below(root, *const_cast<Json*>(look_up(tree_, root)), visit);
}

std::vector<std::string> RecipeTree::uses(const std::string& name) const {
    std::vector<std::string> places;
    const_cast<RecipeTree*>(this)->visit([&](const std::string& place, Json& value) {
        if (value.is_string() && value == name) places.push_back(place);
    });
    return places;
}

/// Checks the tree; controls and keys that no longer fit what the recipe has are taken out.
void RecipeTree::check(std::vector<std::string>& lost) {
    while (const auto problem = find_problem(tree_))
        if (!drop_misfit(tree_, problem->path, lost)) refuse_edit(problem->sentence);
}

GraphEdit RecipeTree::finish(std::string words, std::string path, const std::string& origin) {
    std::vector<std::string> lost = marks_->settle(tree_);
    check(lost);
    GraphEdit edit{recipe_of(tree_, recipe_, origin), std::move(words), std::move(path),
                   std::move(lost)};
    edit.recipe.paint = recipe_.paint;
    return edit;
}

}  // namespace burl
