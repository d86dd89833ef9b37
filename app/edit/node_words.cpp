#include "app/edit/node_words.h"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/edit/node_kinds.h"
#include "app/recipe/schema_check.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

/// A node or term of one part of the recipe.
struct Found {
    std::string place, kind;
};

void collect(const Json& value, const std::string& place, std::vector<Found>& found) {
    if (!value.is_object() || !value.contains("node") || !value["node"].is_string()) return;
    const std::string& name = value["node"].get_ref<const std::string&>();
    const NodeType* type = find_node(name);
    if (!type) return;
    found.push_back({place, spoken(name)});
    for (const NodeInput& input : type->inputs())
        if (value.contains(input.key))
            collect(value[std::string(input.key)], join_path(place, input.key), found);
    const std::size_t terms = value.contains("noise") ? value["noise"].size() : 0;
    for (std::size_t i = 0; i < terms; ++i)
        found.push_back({fmt::format("{}.noise.{}", place, i), "noise"});
}

/// Names the nodes of one part; those of a kind that is there more than once get numbers. The node
/// that a name of "define" means is called by it.
void name_part(const Json& value, const std::string& place, NodeWords& words) {
    std::vector<Found> found;
    collect(value, place, found);
    if (place.starts_with("define.") && !found.empty()) {
        words[place] = fmt::format("{} ({})", part_words(place), found.front().kind);
        found.erase(found.begin());
    }
    std::map<std::string, int> all, so_far;
    for (const Found& one : found) ++all[one.kind];
    const std::string part = part_words(place);
    for (const Found& one : found) {
        const int number = ++so_far[one.kind];
        const std::string kind =
            all[one.kind] > 1 ? fmt::format("{} {}", one.kind, number) : one.kind;
        words[one.place] = fmt::format("{} in {}", kind, part);
    }
}

}  // namespace

NodeWords node_words(const Json& recipe) {
    NodeWords words;
    if (recipe.contains("texture")) name_part(recipe["texture"], "texture", words);
    for (const char* part : {"material", "define"})
        for (const auto& item : part_of(recipe, part).items())
            name_part(item.value(), join_path(part, item.key()), words);
    if (part_of(recipe, "bump").contains("input"))
        name_part(recipe["bump"]["input"], "bump.input", words);
    return words;
}

std::string part_words(std::string_view place) {
    const auto parts = split_path(place);
    if (parts[0] == "texture") return "base colour";
    if (parts[0] == "bump") return "height";
    return spoken(parts.size() > 1 ? parts[1] : parts[0]);
}

std::string place_words(const Json& recipe, const std::string& place) {
    const std::size_t dot = place.rfind('.');
    const NodeWords words = node_words(recipe);
    const auto owner = words.find(place.substr(0, dot == std::string::npos ? 0 : dot));
    if (owner == words.end()) return part_words(place);
    return fmt::format("{} of {}", spoken(place.substr(dot + 1)), owner->second);
}

}  // namespace burl
