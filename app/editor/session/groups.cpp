#include "app/editor/session/groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <ranges>
#include <span>
#include <system_error>
#include <utility>

#include "app/recipe/parameters.h"

namespace burl {

namespace {

using Name = std::pair<std::string_view, std::string_view>;  // a key, and its name

/// Names for the parameters of nodes whose keys no parameter of the recipe has.
constexpr std::array node_labels{
    Name{"aa", "smoothing"},
    Name{"amount", "share of b"},
    Name{"vs", "first axis"},
    Name{"vt", "second axis"},
};

constexpr std::array titles{
    Name{"animation", "Animation"},  Name{"atlas", "Texture's size and layout"},
    Name{"bump", "Relief"},          Name{"color_map", "Colour map"},
    Name{"filter", "Filter"},        Name{"material", "Material"},
    Name{"precision", "Arithmetic"}, Name{"quadric", "Shape (quadric)"},
    Name{"recipe", "Name"},          Name{"solid", "Scale and place"},
    Name{"texture", "Colours"},
};

std::string_view in_words(const auto& names, std::string_view key) {
    const auto found = std::ranges::find(names, key, &Name::first);
    return found == names.end() ? std::string_view() : found->second;
}

// Keys by how much they change a texture, most first; all other keys are sorted at "".
constexpr std::array<std::string_view, 30> order{
    "kind",       "fade",      "feature",   "radius2",   "size",      "scale",
    "strength",   "variation", "height",    "amplitude", "frequency", "period",
    "spacing",    "radius",    "threshold", "wobble",    "octaves",   "gain",
    "lacunarity", "sum",       "seed",      "",          "phase",     "rotate",
    "translate",  "offset",    "space",     "time",      "weights",   "range"};

std::size_t place_of(std::string_view key) {
    const auto found = std::ranges::find(order, key);
    return std::size_t((found != order.end() ? found : std::ranges::find(order, "")) -
                       order.begin());
}

/// The recipe's parameters with this key; a node's parameter with the same key means the same.
auto parameters_with(std::string_view key) {
    return parameters() | std::views::filter([key](const RecipeParameter& parameter) {
               return parameter.path.substr(parameter.path.rfind('.') + 1) == key;
           });
}

/// Returns the kind of noise that a key applies to; empty: every kind.
std::string_view kind_of(std::string_view key) {
    constexpr std::array<Name, 3> kinds{Name{"fade", "value"}, Name{"feature", "worley"},
                                        Name{"radius2", "simplex"}};
    return in_words(kinds, key);
}

bool is_noise(const std::string& group) {
    const std::size_t last = group.rfind("noise ");
    return last != std::string::npos && (last == 0 || group[last - 1] == ' ');
}

/// Whether a parameter of a group with this kind of noise is rarely needed.
bool is_rare(const RecipeLeaf& leaf, std::string_view kind) {
    if (const std::string_view wanted = kind_of(leaf.label); !wanted.empty()) return wanted != kind;
    // A pattern's period is important, a noise's is not.
    if (leaf.label == "period") return is_noise(leaf.group);
    if (leaf.label == "period_u" || leaf.label == "period_v") return true;
    return std::ranges::any_of(parameters_with(leaf.label),
                               [](const RecipeParameter& one) { return one.rare; });
}

/// Returns the sort key of a group: 0 first; the texture's own groups are 1.
int group_place(std::string_view name) {
    constexpr std::array<std::pair<std::string_view, int>, 9> places{{{"pose", 3},
                                                                      {"solid", 0},
                                                                      {"texture", 2},
                                                                      {"material", 4},
                                                                      {"animation", 4},
                                                                      {"filter", 5},
                                                                      {"atlas", 6},
                                                                      {"precision", 7},
                                                                      {"recipe", 8}}};
    for (const auto& [group, place] : places)
        if (group == name) return place;
    if (name == "bump" || name.starts_with("bump >")) return 3;
    return name == "quadric" ? 2 : 1;
}

bool begins_open(std::string_view name) {
    return group_place(name) <= 3 && !name.ends_with("quadric");
}

std::string capitalised(std::string text) {
    std::ranges::replace(text, '_', ' ');
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = char(text[0] - 'a' + 'A');
    return text;
}

/// Returns the part of the leaf's path before its key: the path of a node, a term or a section.
std::string_view owner_of(const RecipeLeaf& leaf) {
    const std::size_t at = leaf.path.size() - leaf.label.size();
    return std::string_view(leaf.path).substr(0, at > 0 ? at - 1 : 0);
}

/// Returns the heading of a group of leaves that `owner` has: a node's or term's words, or the
/// section's name.
std::string title_of(std::string_view name, const std::string& owner, const NodeWords& words) {
    constexpr std::string_view arrow = " > ";
    const std::size_t at = name.rfind(arrow);
    const std::string_view last =
        at == std::string_view::npos ? name : name.substr(at + arrow.size());
    const auto node = words.find(owner);
    // The terms of the one field of a plain texture need no place.
    if (node != words.end() && !name.starts_with("noise ")) return capitalised(node->second);
    const std::string_view known = in_words(titles, last);
    std::string title = capitalised(std::string(known.empty() ? last : known));
    const auto field = words.find(owner.substr(0, std::min(owner.rfind('.'), owner.size())));
    if (at == std::string_view::npos || field == words.end()) return title;
    return fmt::format("{} of {}", title, field->second);
}

ParameterGroup make_group(std::span<const RecipeLeaf> leaves, const NodeWords& words) {
    ParameterGroup group;
    group.name = leaves.front().group;
    group.title = title_of(group.name, std::string(owner_of(leaves.front())), words);
    group.open = begins_open(group.name);
    const auto kind = std::ranges::find(leaves, "kind", &RecipeLeaf::label);
    const std::string noise =
        kind != leaves.end() && kind->value.is_string() ? kind->value.get<std::string>() : "";
    for (const RecipeLeaf& leaf : leaves)
        (is_rare(leaf, noise) ? group.more : group.first).push_back(leaf);
    if (group.first.empty()) group.first.swap(group.more);
    std::ranges::stable_sort(group.first, {},
                             [](const RecipeLeaf& leaf) { return place_of(leaf.label); });
    return group;
}

/// Parses an index; empty where the text is not a number.
std::optional<std::size_t> index_of(std::string_view text) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
    if (error != std::errc() || end != text.data() + text.size()) return {};
    return index;
}

/// Returns the suffix of an array item: " x", " y", " z", then " 4", " 5" and so on.
std::string item_name(std::size_t index) {
    return index < 3 ? fmt::format(" {}", char('x' + int(index))) : fmt::format(" {}", index + 1);
}

/// Returns the suffix of the parameter's name for the number at `path`; empty where the leaf has no
/// such number.
std::optional<std::string> item_of(const RecipeLeaf& leaf, std::string_view path) {
    if (path == leaf.path && leaf.value.is_number()) return std::string();
    if (!leaf.value.is_array() || !path.starts_with(leaf.path + ".")) return {};
    const auto index = index_of(path.substr(leaf.path.size() + 1));
    if (!index || *index >= leaf.value.size()) return {};
    return item_name(*index);
}

/// Returns the name of a colour stop's position, such as "texture.stops.1.0"; empty for any other
/// path.
std::optional<std::string> stop_label(const NodeWords& words, const std::string& path) {
    constexpr std::string_view stops = ".stops.", place = ".0";
    const std::size_t at = path.find(stops);
    if (at == std::string::npos || !path.ends_with(place)) return {};
    const std::size_t from = at + stops.size();
    if (from + place.size() >= path.size()) return {};
    const auto index =
        index_of(std::string_view(path).substr(from, path.size() - place.size() - from));
    if (!index) return {};
    return fmt::format("{}: stop {}, place", map_title(words, path.substr(0, at)), *index + 1);
}

}  // namespace

std::vector<ParameterGroup> parameter_groups(const std::vector<RecipeLeaf>& leaves,
                                             const NodeWords& words) {
    std::vector<ParameterGroup> groups;
    for (auto first = leaves.begin(); first != leaves.end();) {
        const auto last = std::find_if(first, leaves.end(), [&](const RecipeLeaf& leaf) {
            return leaf.group != first->group || owner_of(leaf) != owner_of(*first);
        });
        groups.push_back(make_group({first, last}, words));
        first = last;
    }
    std::ranges::stable_sort(groups, {},
                             [](const ParameterGroup& group) { return group_place(group.name); });
    return groups;
}

std::string map_title(const NodeWords& words, const std::string& path) {
    const auto map = words.find(path);
    return path == "texture" || map == words.end() ? "Colours" : capitalised(map->second);
}

std::string number_label(const std::vector<ParameterGroup>& groups, const NodeWords& words,
                         const std::string& path) {
    if (const auto label = stop_label(words, path)) return *label;
    for (const ParameterGroup& group : groups)
        for (const std::vector<RecipeLeaf>* leaves : {&group.first, &group.more})
            for (const RecipeLeaf& leaf : *leaves)
                if (const auto item = item_of(leaf, path))
                    return fmt::format("{}: {}{}", group.title, parameter_label(leaf.label), *item);
    return path;
}

std::string parameter_label(std::string_view key) {
    for (const RecipeParameter& parameter : parameters_with(key))
        if (!parameter.label.empty()) return std::string(parameter.label);
    if (const std::string_view words = in_words(node_labels, key); !words.empty())
        return std::string(words);
    std::string text(key);
    std::ranges::replace(text, '_', ' ');
    return text;
}

}  // namespace burl
