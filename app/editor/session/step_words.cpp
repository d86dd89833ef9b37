#include "app/editor/session/step_words.h"

#include <algorithm>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "app/edit/node_words.h"
#include "app/editor/session/groups.h"
#include "app/recipe/edit/controls.h"
#include "app/recipe/edit/leaves.h"
#include "app/recipe/schema_check.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

/// The paths of the values that differ, and whether nodes or lists came or went.
struct ValueDifferences {
    std::vector<std::string> paths;
    bool form = false;

    void compare(const Json& before, const Json& after, const std::string& path) {
        if (before == after) return;
        const bool same_kind =
            before.type() == after.type() || (before.is_number() && after.is_number());
        form |= !same_kind || (before.is_structured() && before.size() != after.size());
        if (!before.is_structured() || form) {
            paths.push_back(path);
            return;
        }
        for (const auto& [key, value] : before.items()) {
            const Json* other = after.is_array()      ? &after[std::stoul(key)]
                                : after.contains(key) ? &after[key]
                                                      : nullptr;
            form |= other == nullptr || (key == "node" && value != *other);
            if (other) compare(value, *other, join_path(path, key));
        }
    }
};

/// The control that sets all of the paths; empty: none.
std::string control_of(const Json& recipe, const std::vector<std::string>& paths) {
    const std::set<std::string> changed(paths.begin(), paths.end());
    const std::vector<RecipePlace> places = recipe_places(recipe);
    for (const ControlState& state : control_states(recipe)) {
        std::set<std::string> set;
        for (const std::string& entry : state.control.sets)
            if (const RecipePlace* place = find_place(places, control_target(entry).path))
                set.insert(place->path);
        if (std::ranges::includes(set, changed)) return state.control.name;
    }
    return "";
}

/// The number of a colour stop that a path lies in, from 1 on; 0: it lies in none.
std::size_t stop_of(const std::string& path) {
    const std::size_t at = path.find(".stops.");
    return at == std::string::npos ? 0 : std::stoul(path.substr(at + 7)) + 1;
}

/// The name of what lies at a path, with its value where that is short.
std::string named(const Json& recipe, const std::string& path) {
    const NodeWords words = node_words(recipe);
    const auto groups = parameter_groups(recipe_leaves(recipe), words);
    if (const std::size_t stop = stop_of(path))
        return fmt::format("{}: stop {}", map_title(words, path.substr(0, path.find(".stops."))),
                           stop);
    std::string label = number_label(groups, words, path);
    if (label != path) return label;
    for (const ParameterGroup& group : groups)
        for (const auto* leaves : {&group.first, &group.more})
            for (const RecipeLeaf& leaf : *leaves)
                if (path == leaf.path || path.starts_with(leaf.path + "."))
                    return fmt::format("{}: {}", group.title, parameter_label(leaf.label));
    return path;
}

std::string value_at(const Json& recipe, const std::string& path) {
    const Json* at = &recipe;
    for (const std::string_view part : split_path(path)) {
        const std::string key(part);
        at = at->is_array() ? &(*at)[std::stoul(key)] : &(*at)[key];
    }
    if (at->is_number_float()) return fmt::format(" {:.4g}", at->get<double>());
    const std::string text = at->is_string() ? at->get<std::string>() : at->dump();
    return at->is_structured() || text.size() > 24 ? "" : " " + text;
}

std::string values_words(const Json& before, const Json& after) {
    ValueDifferences differences;
    differences.compare(before, after, "");
    const std::vector<std::string>& paths = differences.paths;
    if (std::string control = control_of(after, paths); !control.empty() && !differences.form)
        return control;
    if (differences.form && paths.size() == 1 && stop_of(paths[0] + ".0") > 0)
        return "colour stops";
    if (differences.form && paths.size() == 1 && paths[0].ends_with("stops")) return "colour stops";
    if (differences.form) return "other nodes";
    if (paths.size() == 1) return named(after, paths[0]) + value_at(after, paths[0]);
    const auto owner = [](const std::string& path) { return path.substr(0, path.rfind('.')); };
    const bool one = std::ranges::all_of(
        paths, [&](const std::string& path) { return owner(path) == owner(paths[0]); });
    const bool in_solid = std::ranges::all_of(
        paths, [](const std::string& path) { return path.starts_with("solid."); });
    if (in_solid) return "move the texture";
    return one ? named(after, owner(paths[0])) : fmt::format("{} values", paths.size());
}

}  // namespace

std::string step_words(const Recipe& before, const Recipe& after) {
    if (before.paint != after.paint) return after.paint.empty() ? "clear paint" : "paint";
    const Json old = slider_json(before), now = slider_json(after);
    if (old != now) return values_words(old, now);
    return before.animation != after.animation ? "keys" : "nothing";
}

}  // namespace burl
