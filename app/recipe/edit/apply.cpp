#include "app/recipe/edit/apply.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "app/recipe/edit/check.h"
#include "app/recipe/edit/controls.h"
#include "app/recipe/edit/leaves.h"
#include "app/recipe/edit/settings.h"
#include "app/recipe/schema_check.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

/// `path` lies at, above or below `other`.
bool concerns(const std::string& path, const std::string& other) {
    const std::string& shorter = path.size() < other.size() ? path : other;
    const std::string& longer = path.size() < other.size() ? other : path;
    return longer.starts_with(shorter) &&
           (longer.size() == shorter.size() || longer[shorter.size()] == '.');
}

/// Returns the end of a sentence about an edit whose path leads nowhere in a recipe with controls.
std::string hint_of_controls(const Json& before, const std::string& path) {
    Json::json_pointer place;
    for (const std::string_view part : split_path(path)) place /= std::string(part);
    if (!before.contains("controls") || before.contains(place)) return "";
    return fmt::format("; this recipe has no {}, and `burl show` lists its controls", path);
}

/// Throws Error(usage) for the recipe's first problem, naming the last edit that may have made it.
void check_edited(const Json& before, const Json& recipe, const std::vector<ControlEdit>& edits) {
    const auto problem = find_problem(recipe);
    if (!problem) return;
    for (std::size_t i = edits.size(); i-- > 0;)
        if (concerns(problem->path, edits[i].path))
            throw Error(ExitCode::usage,
                        fmt::format("--set {}: {}{}", edits[i].said, problem->sentence,
                                    hint_of_controls(before, edits[i].path)));
    throw Error(ExitCode::usage, "--set: " + problem->sentence);
}

/// Throws Error(usage) for a setting of what may be a misspelt control.
void check_spelt(const Json& recipe, const std::string& setting) {
    const std::string nearest = nearest_control(recipe, setting);
    if (nearest.empty()) return;
    throw Error(ExitCode::usage,
                fmt::format("--set: there is no parameter or control \"{}\"; did you mean \"{}\"?",
                            setting.substr(0, setting.find('=')), nearest));
}

/// Applies settings of controls after those of paths, `plain`.
std::vector<ControlEdit> apply_controls(Json& recipe, const std::vector<std::string>& settings,
                                        const std::vector<ControlEdit>& plain) {
    std::vector<ControlEdit> edits = control_edits(recipe, settings, plain);
    std::vector<std::string> texts;
    for (const ControlEdit& edit : edits) texts.push_back(edit.setting());
    for (const std::string& text : with_arrays(recipe, texts)) apply_setting(recipe, text);
    return edits;
}

}  // namespace

void apply_settings(Json& recipe, const std::vector<std::string>& settings) {
    const Json before = recipe;
    std::vector<ControlEdit> edits;
    std::vector<std::string> named;
    for (const std::string& setting : settings) {
        check_setting_form(setting);
        if (sets_control(before, setting)) {
            named.push_back(setting);
            continue;
        }
        check_spelt(before, setting);
        edits.push_back({setting, apply_setting(recipe, setting), "", true});
    }
    if (!named.empty()) {
        check_edited(before, recipe, edits);
        edits = apply_controls(recipe, named, edits);
    }
    check_edited(before, recipe, edits);
}

std::vector<std::string> with_arrays(const Json& recipe, const std::vector<std::string>& settings) {
    std::vector<std::string> all;
    for (const RecipeLeaf& leaf : recipe_leaves(recipe)) {
        const std::string front = leaf.path + ".";
        const auto inside = [&](const std::string& setting) { return setting.starts_with(front); };
        if (leaf.parameter->type == ParameterType::numbers &&
            std::any_of(settings.begin(), settings.end(), inside))
            all.push_back(fmt::format("{}={}", leaf.path, leaf.value.dump()));
    }
    all.insert(all.end(), settings.begin(), settings.end());
    return all;
}

}  // namespace burl
