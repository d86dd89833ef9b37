// Steps that connect, move and disconnect (steps.h).
#include <utility>

#include <fmt/format.h>

#include "app/edit/circle.h"
#include "app/edit/node_words.h"
#include "app/edit/steps.h"
#include "app/edit/tree.h"
#include "app/recipe/schema_check.h"
#include "procedural/graph/json.h"

namespace burl {

namespace {

/// Throws Error(usage) where a place can be connected to nothing.
void refuse_target(const std::string& to) {
    if (!defined_at(to).empty())
        refuse_edit(fmt::format("\"{}\" is a name; connect to an input of a node or to a channel",
                                defined_at(to)));
}

/// The name by which others can use the node at a place, which gets one where it has none.
std::string shared_name(RecipeTree& tree, const std::string& place) {
    if (std::string name = defined_at(place); !name.empty()) return name;
    Json& value = tree.at(place);
    if (is_graph_name(value)) return value.get<std::string>();
    std::string name = tree.free_name(std::string(type_of(value).name));
    Json node = std::exchange(value, name);
    tree.add_name(name, std::move(node));
    return name;
}

/// The words of an input or channel in a sentence: "a of mix", "roughness".
std::string target_words(const RecipeTree& tree, const std::string& to) {
    const std::size_t dot = to.rfind('.');
    const Json* owner = dot == std::string::npos ? nullptr : tree.find(to.substr(0, dot));
    if (!owner || !is_node(*owner)) return part_words(to);
    return fmt::format("{} of {}", to.substr(dot + 1),
                       RecipeTree::called(*owner, to.substr(0, dot)));
}

}  // namespace

GraphEdit connect(const Recipe& recipe, const std::string& from, const std::string& to) {
    RecipeTree tree(recipe);
    refuse_target(to);
    refuse_circle(tree, from, to);
    const std::string words = fmt::format(
        "connect {} to {}", RecipeTree::called(tree.at(from), from), target_words(tree, to));
    if (from == to) refuse_edit("it is connected there already");
    const std::string name = shared_name(tree, from);
    tree.keep_under_name(to);
    tree.put(to, name);
    return tree.finish(words, "define." + name);
}

GraphEdit move_node(const Recipe& recipe, const std::string& from, const std::string& to) {
    if (!defined_at(from).empty()) return connect(recipe, from, to);
    RecipeTree tree(recipe);
    refuse_target(to);
    refuse_circle(tree, from, to);
    if (from == to) refuse_edit("it is connected there already");
    const std::string words = fmt::format("move {} to {}", RecipeTree::called(tree.at(from), from),
                                          target_words(tree, to));
    Json value = tree.take(from);
    tree.keep_under_name(to);
    const std::string path = tree.put(to, std::move(value));
    return tree.finish(words, path);
}

GraphEdit disconnect(const Recipe& recipe, const std::string& place) {
    RecipeTree tree(recipe);
    refuse_target(place);
    const Json& value = tree.at(place);
    if (is_constant(value)) refuse_edit("nothing is connected there");
    const std::string words = fmt::format("disconnect {} from {}", RecipeTree::called(value, place),
                                          target_words(tree, place));
    tree.keep_under_name(place);
    tree.vacate(place);
    return tree.finish(words, "");
}

}  // namespace burl
