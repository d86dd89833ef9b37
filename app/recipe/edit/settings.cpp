#include "app/recipe/edit/settings.h"

#include <algorithm>
#include <charconv>
#include <span>

#include <fmt/format.h>

#include "app/base/messages.h"
#include "app/recipe/schema_check.h"
#include "app/recipe/spelling.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "procedural/graph/json.h"

namespace burl {

namespace {

/// Reads an index, which has one spelling: no zeros before it.
bool parse_index(std::string_view part, std::size_t& index) {
    if (part.size() > 1 && part[0] == '0') return false;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
    return error == std::errc() && end == part.data() + part.size() && index < 1000000;
}

bool is_index(std::string_view part) {
    std::size_t index = 0;
    return parse_index(part, index);
}

/// All paths of the table, with "*" replaced by the index at that place of `parts`, or by 0.
std::vector<std::string> concrete_paths(const std::vector<std::string_view>& parts) {
    std::vector<std::string> paths;
    for (const Parameter& parameter : parameters()) {
        auto known = split_path(parameter.path);
        for (std::size_t i = 0; i < known.size(); ++i)
            if (known[i] == "*") known[i] = i < parts.size() && is_index(parts[i]) ? parts[i] : "0";
        paths.push_back(fmt::format("{}", fmt::join(known, ".")));
    }
    return paths;
}

Error unknown_path(std::string_view path) {
    const auto parts = split_path(path);
    const std::vector<std::string> paths = concrete_paths(parts);
    // A path without its beginning ("gain") is compared with the ends of the known paths.
    std::vector<std::string_view> ends;
    for (const std::string& known : paths) {
        const auto all = split_path(known);
        const auto* from = all[all.size() - std::min(all.size(), parts.size())].data();
        ends.push_back({from, std::size_t(known.data() + known.size() - from)});
    }
    const std::string_view end = nearest_word(path, ends);
    const auto found = std::find_if(ends.begin(), ends.end(),
                                    [end](std::string_view e) { return e.data() == end.data(); });
    const std::string hint =
        found == ends.end() || end.empty()
            ? "`burl list parameters` names those of recipes, `burl list nodes` those of nodes, "
              "and `burl show` a material's controls"
            : fmt::format("did you mean \"{}\"?", paths[std::size_t(found - ends.begin())]);
    return Error(ExitCode::usage,
                 fmt::format("--set: there is no parameter \"{}\"; {}", path, hint));
}

/// The element at the index `part`, appended where that is one past the end.
Json& array_item(Json& array, std::string_view part, std::string_view path) {
    std::size_t index = 0;
    parse_index(part, index);
    if (!array.is_array()) array = Json::array();
    if (index > array.size())
        throw Error(ExitCode::usage,
                    fmt::format("--set: \"{}\": the array has {} elements, so the next index is {}",
                                path, array.size(), array.size()));
    if (index == array.size()) array.push_back(nullptr);
    return array[index];
}

/// One number of an array parameter; where the array is missing it begins as its default.
Json& number_item(Json& numbers, const Parameter& parameter, std::string_view part,
                  std::string_view path) {
    std::size_t index = 0;
    if (!parse_index(part, index) || index >= parameter.count)
        throw Error(ExitCode::usage, fmt::format("--set: \"{}\": the index must be 0 to {}", path,
                                                 parameter.count - 1));
    if (!numbers.is_array()) {
        if (parameter.default_value.empty())
            throw Error(ExitCode::usage,
                        fmt::format("--set: \"{}\": set all {} numbers first: {}=[...]", path,
                                    parameter.count, path.substr(0, path.rfind('.'))));
        numbers = Json::parse(parameter.default_value);
    }
    return array_item(numbers, part, path);
}

/// The value that the text spells for a place of the recipe: words need no quotes, and a colour may
/// be a node.
Json parse_value(const std::string& text, const SchemaNode& node) {
    Json value = parse_json_value(text);
    const bool color = node.parameter && node.parameter->type == ParameterType::color;
    const bool word = color || (node.parameter && (node.parameter->type == ParameterType::text ||
                                                   node.parameter->type == ParameterType::choice));
    if (color && value.is_object()) return value;
    if (value.is_discarded() || (word && !value.is_string())) return text;
    return value;
}

/// Whether the path leads to a key of a texture graph.
bool lies_in_graph(const Json& recipe, std::span<const std::string_view> parts) {
    if (parts.size() < 2) return false;
    if (parts[0] == "bump") return parts[1] == "input";
    if (parts[0] == "define") return true;
    if (parts[0] == "material") return parts.size() > 2;
    return parts[0] == "texture" && recipe.contains("texture") && is_graph(recipe["texture"]);
}

/// The value at a path within a texture graph, which follows the JSON itself; a key that its node
/// does not have is found when the whole recipe is checked.
Json& graph_place(Json& recipe, std::span<const std::string_view> parts, std::string_view path) {
    Json* place = &recipe;
    for (const std::string_view part : parts) {
        if (place->is_array() && is_index(part)) {
            place = &array_item(*place, part, path);
            continue;
        }
        if (!place->is_object()) *place = Json::object();
        place = &(*place)[std::string(part)];
    }
    return *place;
}

}  // namespace

std::string without_blanks(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return "";
    return std::string(text.substr(begin, text.find_last_not_of(" \t") + 1 - begin));
}

void check_setting_form(const std::string& setting) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos || equals == 0)
        throw Error(ExitCode::usage,
                    fmt::format("--set: \"{}\" must have the form path=value", setting));
}

std::string apply_setting(Json& recipe, const std::string& setting) {
    check_setting_form(setting);
    const std::size_t equals = setting.find('=');
    std::string path = respelled_path(without_blanks(setting.substr(0, equals)));
    const SchemaNode* node = &recipe_schema();
    // The edit is made in a copy, since a wrong path must leave the recipe unchanged.
    Json edited = recipe;
    Json* place = &edited;
    const auto parts = split_path(path);
    if (lies_in_graph(recipe, parts)) {
        graph_place(edited, parts, path) = parse_value(setting.substr(equals + 1), {});
        recipe = std::move(edited);
        return path;
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (node->parameter && node->parameter->type == ParameterType::numbers &&
            i + 1 == parts.size()) {
            place = &number_item(*place, *node->parameter, parts[i], path);
            break;
        }
        const bool item = node->is_array() && is_index(parts[i]);
        node = node->child(item ? "*" : parts[i]);
        if (!node || parts[i] == "*") throw unknown_path(path);
        const bool in_array = item || is_index(parts[i]);
        if (!in_array && !place->is_object()) *place = Json::object();
        place = in_array ? &array_item(*place, parts[i], path) : &(*place)[std::string(parts[i])];
    }
    *place = parse_value(setting.substr(equals + 1), *node);
    if (path == "texture" && path != setting.substr(0, equals)) *place = as_base_color(*place);
    recipe = std::move(edited);
    return path;
}

}  // namespace burl
