#include "app/recipe/schema_check.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/base/messages.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "atlas/base/utf8.h"
#include "procedural/graph/json.h"

namespace burl {

namespace {

/// The node at a path, created where it is missing.
SchemaNode& place(SchemaNode& root, std::string_view path) {
    SchemaNode* node = &root;
    for (const std::string_view part : split_path(path)) {
        if (!node->child(part)) node->children.emplace_back(part, std::make_unique<SchemaNode>());
        node = const_cast<SchemaNode*>(node->child(part));
    }
    return *node;
}

std::string quoted_list(const std::vector<std::string_view>& words) {
    return fmt::format("\"{}\"", fmt::join(words, "\", \""));
}

std::string range_text(const Parameter& p) {
    return fmt::format("from {} to {}", p.low, p.high);
}

std::string expectation(const Parameter& p) {
    switch (p.type) {
        case ParameterType::number:
            return "a number " + range_text(p);
        case ParameterType::integer:
            return fmt::format("a whole number from {:.0f} to {:.0f}", p.low, p.high);
        case ParameterType::numbers:
            return fmt::format("an array of {} numbers {}", p.count, range_text(p));
        case ParameterType::text:
            return "a string in UTF-8";
        case ParameterType::choice:
            return (p.choices.find('|') == std::string_view::npos ? "" : "one of ") +
                   quoted_list(split_choices(p.choices));
        case ParameterType::color:
            return p.alpha ? "an sRGB colour \"#rrggbb\" or \"#rrggbbaa\""
                           : "an sRGB colour \"#rrggbb\"";
    }
    return {};
}

bool number_fits(const Parameter& p, const Json& value) {
    if (!value.is_number()) return false;
    const double x = value.get<double>();
    return std::isfinite(x) && x >= p.low && x <= p.high;
}

bool is_hex_color(const Parameter& p, const std::string& text) {
    return (text.size() == 7 || (p.alpha && text.size() == 9)) && text[0] == '#' &&
           text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
}

bool fits(const Parameter& p, const Json& value) {
    const auto number = [&p](const Json& v) { return number_fits(p, v); };
    switch (p.type) {
        case ParameterType::number:
            return number(value);
        case ParameterType::integer:
            return number(value) && value.get<double>() == std::floor(value.get<double>());
        case ParameterType::numbers:
            return value.is_array() && value.size() == p.count &&
                   std::all_of(value.begin(), value.end(), number);
        case ParameterType::text:
            return value.is_string() && is_utf8(value.get_ref<const std::string&>());
        case ParameterType::color:
            return value.is_string() && is_hex_color(p, value.get_ref<const std::string&>());
        case ParameterType::choice: {
            const auto words = split_choices(p.choices);
            return value.is_string() &&
                   std::find(words.begin(), words.end(), value.get_ref<const std::string&>()) !=
                       words.end();
        }
    }
    return false;
}

}  // namespace

const Json& part_of(const Json& recipe, const char* key) {
    static const Json none = Json::object();
    return recipe.is_object() && recipe.contains(key) ? recipe[key] : none;
}

Json without_channel_nodes(Json material) {
    for (const std::string_view channel : enum_names<Channel>) {
        const auto found = material.find(std::string(channel));
        if (found != material.end() && is_graph_channel(*found)) material.erase(found);
    }
    return material;
}

std::vector<std::string_view> split_path(std::string_view path) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0; begin <= path.size();) {
        const std::size_t end = std::min(path.find('.', begin), path.size());
        parts.push_back(path.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

SchemaNode build_schema() {
    SchemaNode root;
    for (const Parameter& parameter : parameters())
        place(root, parameter.path).parameter = &parameter;
    place(root, "bump.input").elsewhere = true;  // a graph, which graph_check.h checks
    return root;
}

const SchemaNode& recipe_schema() {
    static const SchemaNode schema = build_schema();
    return schema;
}

std::string join_path(const std::string& path, std::string_view key) {
    return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}

std::string shown(const Json& value) {
    if (value.is_object()) return "an object";
    if (std::any_of(value.begin(), value.end(), [](const Json& v) { return v.is_structured(); }))
        return "an array of arrays or objects";
    const std::string text = print_json_value(value);
    return text.size() <= 60 ? text : text.substr(0, 57) + "...";
}

RecipeProblem mismatch(const std::string& path, const Json& value, const std::string& wanted) {
    return {path, fmt::format("{} is {}, must be {}", path.empty() ? "the recipe" : path,
                              shown(value), wanted)};
}

std::optional<RecipeProblem> check_leaf(const Parameter& parameter, const Json& value,
                                        const std::string& path) {
    if (fits(parameter, value)) return {};
    // The index is named where one number of an array is wrong.
    if (parameter.type == ParameterType::numbers && value.is_array() &&
        value.size() == parameter.count) {
        for (std::size_t i = 0; i < value.size(); ++i)
            if (!number_fits(parameter, value[i]))
                return mismatch(join_path(path, std::to_string(i)), value[i],
                                "a number " + range_text(parameter));
    }
    RecipeProblem problem = mismatch(path, value, expectation(parameter));
    if (parameter.type == ParameterType::choice && value.is_string()) {
        const std::string_view nearest =
            nearest_word(value.get_ref<const std::string&>(), split_choices(parameter.choices));
        if (!nearest.empty() && parameter.choices.find('|') != std::string_view::npos)
            problem.sentence += fmt::format("; did you mean \"{}\"?", nearest);
    }
    return problem;
}

RecipeProblem unknown_key(const std::vector<std::string_view>& known, const std::string& key,
                          const std::string& path) {
    const std::string_view nearest = nearest_word(key, known);
    const std::string hint = nearest.empty() ? fmt::format("known keys: {}", quoted_list(known))
                                             : fmt::format("did you mean \"{}\"?", nearest);
    return {join_path(path, key), fmt::format("unknown key {} in {}; {}", shown(Json(key)),
                                              path.empty() ? "the recipe" : path, hint)};
}

namespace {

using Found = std::optional<RecipeProblem>;

Found check_array(const SchemaNode& node, const Json& value, const std::string& path) {
    if (!value.is_array()) return mismatch(path, value, "an array");
    const SchemaNode& item = *node.children[0].second;
    for (std::size_t i = 0; i < value.size(); ++i)
        if (Found found = check_value(item, value[i], join_path(path, std::to_string(i))))
            return found;
    return {};
}

Found check_tuple(const SchemaNode& node, const Json& value, const std::string& path) {
    if (!value.is_array() || value.size() != node.children.size()) {
        std::vector<std::string> wanted;
        for (const auto& [name, child] : node.children)
            wanted.push_back(expectation(*child->parameter));
        return mismatch(path, value, fmt::format("[{}]", fmt::join(wanted, ", ")));
    }
    for (std::size_t i = 0; i < value.size(); ++i)
        if (Found found =
                check_value(*node.children[i].second, value[i], join_path(path, std::to_string(i))))
            return found;
    return {};
}

Found check_object(const SchemaNode& node, const Json& value, const std::string& path) {
    if (!value.is_object()) return mismatch(path, value, "an object");
    // "node" decides which other keys are allowed, so it is checked first.
    if (const SchemaNode* kind = node.child("node"); kind && value.contains("node"))
        if (Found found = check_value(*kind, value["node"], join_path(path, "node"))) return found;
    for (const auto& item : value.items()) {
        const SchemaNode* child = node.child(item.key());
        if (!child) {
            if (path.empty() && item.key() == "made_from")
                return RecipeProblem{"made_from", "this is the record of a bake, not a recipe"};
            std::vector<std::string_view> known = node.keys();
            if (path.empty()) known.emplace_back("define");  // which graphs are read with
            return unknown_key(known, item.key(), path);
        }
        if (Found found = check_value(*child, item.value(), join_path(path, item.key())))
            return found;
    }
    return {};
}

}  // namespace

std::optional<RecipeProblem> check_value(const SchemaNode& node, const Json& value,
                                         const std::string& path) {
    if (node.elsewhere) return {};
    if (node.parameter) return check_leaf(*node.parameter, value, path);
    if (node.is_array()) return check_array(node, value, path);
    if (node.is_tuple()) return check_tuple(node, value, path);
    return check_object(node, value, path);
}

}  // namespace burl
