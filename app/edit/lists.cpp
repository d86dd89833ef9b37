#include "app/edit/lists.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "app/edit/tree.h"
#include "app/recipe/schema_check.h"

namespace burl {

namespace {

/// Moves an item of a list so that it has another index.
void move_item(std::vector<Json>& items, std::size_t from, std::size_t to) {
    Json item = std::move(items[from]);
    items.erase(items.begin() + std::ptrdiff_t(from));
    items.insert(items.begin() + std::ptrdiff_t(to), std::move(item));
}

void check_index(std::size_t index, std::size_t count, const char* what) {
    if (index >= count)
        refuse_edit(fmt::format("there is no {} {}; there are {}", what, index + 1, count));
}

/// The terms of the field at a place. Throws Error(usage) where there is no field.
std::vector<Json>& terms_of(RecipeTree& tree, const std::string& field) {
    Json& node = tree.at(field);
    if (!is_node(node) || type_of(node).name != "field")
        refuse_edit(fmt::format("the node at \"{}\" has no noise terms; only field has", field));
    Json& terms = node["noise"];
    if (!terms.is_array()) terms = Json::array();
    return terms.get_ref<Json::array_t&>();
}

Json next_term(const std::vector<Json>& terms) {
    if (terms.empty()) return {{"kind", "perlin"}, {"amplitude", 1.0}};
    Json term = without_marks(terms.back());
    const auto seed = term.value("seed", std::uint64_t(0));
    // As far from this one's as its octaves do not reach.
    term["seed"] = (seed + 100) % 4294967296U;
    return term;
}

bool is_layer(const Json& value) {
    return is_node(value) &&
           (type_of(value).name == "blend" || type_of(value).name == "layer_over");
}

/// The places of the layers at a place, from the uppermost down.
std::vector<std::string> places_of(const RecipeTree& tree, const std::string& place) {
    std::vector<std::string> places;
    std::string at = place;
    for (const Json* value = tree.find(at); value && is_layer(*value); value = tree.find(at)) {
        places.push_back(at);
        at += ".base";
    }
    return places;
}

/// A stack of layers, from the lowest up, without their bases, over what is no layer.
struct LayerStack {
    std::vector<Json> layers;
    Json base;
};

LayerStack take_stack(RecipeTree& tree, const std::string& place) {
    LayerStack stack;
    const std::vector<std::string> places = places_of(tree, place);
    if (places.empty()) refuse_edit("there are no layers; add one");
    stack.base = tree.at(places.back() + ".base");
    for (const std::string& one : places) {
        Json layer = tree.at(one);
        layer["base"] = 0.0;
        stack.layers.insert(stack.layers.begin(), std::move(layer));
    }
    return stack;
}

void put_stack(RecipeTree& tree, const std::string& place, LayerStack stack) {
    Json below = std::move(stack.base);
    for (Json& layer : stack.layers) {
        layer["base"] = std::move(below);
        below = std::move(layer);
    }
    tree.put(place, std::move(below));
}

/// The content of a new layer: a colour where colours are, or a number.
Json new_content(const RecipeTree& tree, const std::string& place) {
    return tree.wanted(place) == Wire::color ? Json("#808080") : Json(0.5);
}

}  // namespace

GraphEdit add_term(const Recipe& recipe, const std::string& field, std::size_t index) {
    RecipeTree tree(recipe);
    std::vector<Json>& terms = terms_of(tree, field);
    check_index(index, terms.size() + 1, "place for a term");
    terms.insert(terms.begin() + std::ptrdiff_t(index), next_term(terms));
    return tree.finish("add a noise term", field);
}

GraphEdit remove_term(const Recipe& recipe, const std::string& field, std::size_t index) {
    RecipeTree tree(recipe);
    std::vector<Json>& terms = terms_of(tree, field);
    check_index(index, terms.size(), "term");
    terms.erase(terms.begin() + std::ptrdiff_t(index));
    return tree.finish(fmt::format("remove noise term {}", index + 1), field);
}

GraphEdit move_term(const Recipe& recipe, const std::string& field, std::size_t from,
                    std::size_t to) {
    RecipeTree tree(recipe);
    std::vector<Json>& terms = terms_of(tree, field);
    check_index(from, terms.size(), "term");
    check_index(to, terms.size(), "term");
    move_item(terms, from, to);
    return tree.finish(fmt::format("move noise term {} to {}", from + 1, to + 1), field);
}

std::vector<std::string> layers_at(const Recipe& recipe, const std::string& place) {
    std::vector<std::string> places = places_of(RecipeTree(recipe), place);
    std::ranges::reverse(places);
    return places;
}

GraphEdit add_layer(const Recipe& recipe, const std::string& place, std::string_view mode) {
    RecipeTree tree(recipe);
    Json base = tree.content(place);
    if (base.is_null()) refuse_edit(fmt::format("nothing stands at \"{}\"", place));
    Json layer{{"node", "blend"},         {"mode", mode},   {"top", new_content(tree, place)},
               {"base", std::move(base)}, {"opacity", 1.0}, {"mask", 1.0}};
    const std::string path = tree.put(place, std::move(layer));
    return tree.finish(fmt::format("add a layer, {}", mode), path);
}

GraphEdit remove_layer(const Recipe& recipe, const std::string& place, std::size_t index) {
    RecipeTree tree(recipe);
    LayerStack stack = take_stack(tree, place);
    check_index(index, stack.layers.size(), "layer");
    stack.layers.erase(stack.layers.begin() + std::ptrdiff_t(index));
    put_stack(tree, place, std::move(stack));
    return tree.finish(fmt::format("remove layer {}", index + 1), place);
}

GraphEdit move_layer(const Recipe& recipe, const std::string& place, std::size_t from,
                     std::size_t to) {
    RecipeTree tree(recipe);
    LayerStack stack = take_stack(tree, place);
    check_index(from, stack.layers.size(), "layer");
    check_index(to, stack.layers.size(), "layer");
    move_item(stack.layers, from, to);
    put_stack(tree, place, std::move(stack));
    return tree.finish(fmt::format("move layer {} to {}", from + 1, to + 1), place);
}

}  // namespace burl
