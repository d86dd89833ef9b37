#include "app/edit/node_kinds.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "app/base/messages.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "procedural/graph/node_ops.h"

namespace burl {

namespace {

std::string lowered(std::string_view text) {
    std::string low(text);
    for (char& c : low)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return low;
}

/// The words of a text; blanks within brackets and quotes part none.
std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words(1);
    int depth = 0;
    bool quoted = false;
    for (const char c : text) {
        if (c == '"') quoted = !quoted;
        if (!quoted && (c == '[' || c == '{')) ++depth;
        if (!quoted && (c == ']' || c == '}')) --depth;
        if ((c == ' ' || c == '\t') && depth <= 0 && !quoted)
            words.emplace_back();
        else
            words.back() += c;
    }
    std::erase(words, "");
    return words;
}

/// How well a type answers the words of a search, least first; 3: not at all.
int rank_of(const NodeType& type, const std::vector<std::string>& words) {
    std::string name(type.name);
    std::ranges::replace(name, '_', ' ');
    const std::string both = name + " " + spoken(type.name), about = lowered(type.text);
    const auto within = [](const std::string& text) {
        return [&text](const std::string& word) { return text.find(word) != std::string::npos; };
    };
    const std::string joined = fmt::format("{}", fmt::join(words, " "));
    if (name.starts_with(joined) || type.name.starts_with(joined) ||
        spoken(type.name).starts_with(joined))
        return 0;
    if (std::ranges::all_of(words, within(both))) return 1;
    return std::ranges::all_of(words, within(both + " " + about)) ? 2 : 3;
}

/// Returns the sort key of a node's input: 0 comes first.
int place_of(const NodeInput& input) {
    constexpr std::array<std::string_view, 3> leading{"input", "base", "a"};
    const auto found = std::ranges::find(leading, input.key);
    return int(found - leading.begin());
}

/// The value of a setting's text: JSON, or a word.
Json value_of(const std::string& text) {
    Json value = parse_json_value(text);
    return value.is_discarded() ? Json(text) : value;
}

const NodeType& known_type(const std::string& name) {
    const std::string key = lowered(name);
    if (const NodeType* type = find_node(key)) return *type;
    std::vector<std::string_view> names;
    for (const NodeType& type : graph_table()) names.push_back(type.name);
    const std::string_view nearest = nearest_word(key, names);
    throw Error(ExitCode::usage,
                fmt::format("there is no node \"{}\"{}", name,
                            nearest.empty() ? std::string("; `burl list nodes` names them all")
                                            : fmt::format("; did you mean \"{}\"?", nearest)));
}

/// Adds to `node` what its type requires besides inputs.
void add_content(const NodeType& type, Json& node) {
    if (type.name == "constant") node["value"] = 0.5;
    if (type.name == "color_map") {
        node["wrap"] = "clamp";
        node["stops"] = {{0, "#000000"}, {1, "#ffffff"}};
    }
    if (type.name == "field") node["noise"] = Json::array({{{"kind", "perlin"}, {"amplitude", 1}}});
}

}  // namespace

NodeFamily family_of(const NodeType& type) {
    const auto has = [&](std::span<const NodeType> family) {
        return std::ranges::find(family, type.name, &NodeType::name) != family.end();
    };
    const std::array families{nodes::numbers(),  nodes::colors(), nodes::channels(),
                              nodes::patterns(), nodes::tiles(),  nodes::noises(),
                              nodes::masks(),    nodes::points()};
    for (std::size_t i = 0; i < families.size(); ++i)
        if (has(families[i])) return NodeFamily(i);
    if (has(nodes::blender_nodes()) || has(nodes::materialx_nodes())) return NodeFamily::noise;
    return NodeFamily::number;
}

std::string spoken(std::string_view name) {
    std::string text(name);
    std::ranges::replace(text, '_', ' ');
    if (const std::size_t at = text.find("color"); at != std::string::npos)
        text.replace(at, 5, "colour");
    return text;
}

std::vector<const NodeType*> nodes_with(std::string_view text) {
    std::vector<std::string> words = words_of(lowered(text));
    const auto sets = [](const std::string& word) { return word.find('=') != std::string::npos; };
    if (!words.empty())
        words.erase(std::remove_if(words.begin() + 1, words.end(), sets), words.end());
    std::array<std::vector<const NodeType*>, 4> ranked;
    for (const NodeType& type : graph_table())
        ranked[std::size_t(rank_of(type, words))].push_back(&type);
    std::vector<const NodeType*> found = std::move(ranked[0]);
    for (const std::size_t rank : {1, 2})
        std::ranges::copy(ranked[rank], std::back_inserter(found));
    return found;
}

std::vector<const NodeInput*> leading_inputs(const NodeType& type) {
    std::vector<const NodeInput*> inputs;
    for (const NodeInput& input : type.inputs()) inputs.push_back(&input);
    std::ranges::stable_sort(inputs, {}, [](const NodeInput* input) { return place_of(*input); });
    return inputs;
}

Json vacant_input(const NodeType& type, const NodeInput& input) {
    if (!input.fallback.empty()) return Json::parse(input.fallback);
    const bool factor = type.name == "multiply" || type.name == "scale" ||
                        (type.name == "divide" && input.key == "b");
    if (factor) return 1.0;
    if (type.name == "color_map" || input.sets_wire) return 0.5;
    if (input.wire == Wire::color) return "#808080";
    return 0.0;
}

NewNode new_node(const std::string& text) {
    const std::vector<std::string> words = words_of(text);
    const NodeType& type = known_type(words.empty() ? "" : words[0]);
    NewNode node{{{"node", type.name}}, {}};
    add_content(type, node.json);
    for (const NodeInput& input : type.inputs())
        node.json[std::string(input.key)] = vacant_input(type, input);
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::size_t equals = words[i].find('=');
        if (equals == std::string::npos || equals == 0)
            throw Error(ExitCode::usage,
                        fmt::format("\"{}\" must have the form key=value", words[i]));
        node.given.push_back(words[i].substr(0, equals));
        node.json[node.given.back()] = value_of(words[i].substr(equals + 1));
    }
    return node;
}

}  // namespace burl
