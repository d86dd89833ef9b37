#include "app/recipe/edit/controls.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "app/base/messages.h"
#include "app/recipe/edit/formula.h"
#include "app/recipe/edit/settings.h"
#include "atlas/base/error.h"
#include "procedural/model/members.h"

namespace burl {

namespace {

char small_letter(char c) {
    return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
}

bool same_name(std::string_view a, std::string_view b) {
    return std::ranges::equal(a, b, {}, small_letter, small_letter);
}

/// The part of a setting before its first "=", and what comes after it.
std::pair<std::string, std::string> name_and_value(const std::string& setting) {
    const std::size_t equals = std::min(setting.find('='), setting.size());
    return {without_blanks(setting.substr(0, equals)),
            setting.substr(std::min(equals + 1, setting.size()))};
}

/// Whether a setting is one of a control.
auto is_named_in(const std::string& setting) {
    return [name = name_and_value(setting).first](const RecipeControl& control) {
        return same_name(control.name, name);
    };
}

std::vector<RecipeControl> controls_of(const Json& recipe) {
    std::vector<RecipeControl> controls;
    if (recipe.contains("controls")) read_list(parameters(), recipe["controls"], controls);
    return controls;
}

bool is_whole_number(const RecipePlace& place) {
    return place.parameter && place.parameter->type == ParameterType::integer;
}

std::string number_text(const RecipePlace& place, double value) {
    return is_whole_number(place) ? fmt::format("{:.0f}", value) : fmt::format("{}", value);
}

Error wrong_setting(const std::string& setting, const std::string& sentence) {
    return Error(ExitCode::usage, fmt::format("--set {}: {}", setting, sentence));
}

/// The control that a setting sets. Throws Error(usage) where it is none of them.
const RecipeControl& control_named(const std::string& setting,
                                   const std::vector<RecipeControl>& controls) {
    const auto found = std::ranges::find_if(controls, is_named_in(setting));
    if (found != controls.end()) return *found;
    throw wrong_setting(
        setting, "another --set takes this control out of the recipe; leave one of them out");
}

/// The number that a setting gives a control: rounded for a whole one, and within its range.
double number_of(const std::string& setting, const RecipeControl& control,
                 const RecipePlace& place) {
    const auto [low, high] = *control.range;
    const Json value = Json::parse(name_and_value(setting).second, nullptr, false);
    double number = value.is_number() ? value.get<double>() : std::nan("");
    if (is_whole_number(place)) number = std::round(number);
    if (number >= low && number <= high) return number;
    throw wrong_setting(setting,
                        fmt::format("\"{}\" must be a number from {} to {}, the control's range",
                                    control.name, low, high));
}

std::string color_of(const std::string& setting, const RecipeControl& control) {
    const std::string text = name_and_value(setting).second;
    const Json value = Json::parse(text, nullptr, false);
    std::string color = value.is_string() ? value.get<std::string>() : text;
    if (color.starts_with('#')) return color;
    throw wrong_setting(setting, fmt::format("\"{}\" must be a colour \"#rrggbb\"", control.name));
}

/// The edits that one setting of a control makes: its places and their values.
std::vector<ControlEdit> edits_of(const std::string& setting, const RecipeControl& control,
                                  const std::vector<RecipePlace>& places) {
    std::vector<ControlEdit> edits;
    for (const std::string& entry : control.sets) {
        const auto [path, formula] = control_target(entry);
        const RecipePlace& place = *find_place(places, path);
        if (place.is_color()) {
            edits.push_back({setting, place.path, color_of(setting, control), edits.empty()});
            continue;
        }
        const double x = number_of(setting, control, *find_place(places, control.sets[0]));
        const double value = formula.empty() ? x : formula_value(formula, x);
        if (!std::isfinite(value))
            throw wrong_setting(setting, fmt::format("its formula for {} gives no number", path));
        const double rounded = is_whole_number(place) ? std::round(value) : value;
        edits.push_back({setting, place.path, number_text(place, rounded), edits.empty()});
    }
    return edits;
}

void check_no_keys(const Json& recipe, const ControlEdit& edit) {
    const Json& animation = part_of(recipe, "animation");
    if (!animation.contains("tracks")) return;
    for (const Json& track : animation["tracks"])
        if (track["path"] == edit.path)
            throw wrong_setting(edit.said,
                                fmt::format("the recipe has keys for {}, which it sets; leave it "
                                            "out, or change its \"animation\"",
                                            edit.path));
}

/// Whether the place is set twice, so that one of the two would have no effect.
bool disagree(const ControlEdit& a, const ControlEdit& b) {
    return a.said != b.said && a.path == b.path && a.own == b.own && (a.own || a.value != b.value);
}

/// Whether `plain` sets a part of the recipe in which the place of a control's value lies.
bool sets_part_around(const ControlEdit& plain, const ControlEdit& edit) {
    return edit.own && edit.path.starts_with(plain.path + ".");
}

/// Whether another setting sets the place by itself.
bool yields(const ControlEdit& edit, const std::vector<ControlEdit>& all) {
    return !edit.own && std::ranges::any_of(all, [&](const ControlEdit& other) {
        return other.own && other.path == edit.path;
    });
}

/// The first `plain` edits are settings of paths, the others those of controls.
void check_set_once(const std::vector<ControlEdit>& edits, std::size_t plain) {
    for (std::size_t i = 0; i < edits.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (disagree(edits[k], edits[i]) ||
                (k < plain && i >= plain && sets_part_around(edits[k], edits[i])))
                throw Error(ExitCode::usage,
                            fmt::format("--set {} and --set {} both set {}; give one of them",
                                        edits[k].said, edits[i].said, edits[i].path));
}

}  // namespace

ControlTarget control_target(const std::string& entry) {
    const std::size_t equals = entry.find('=');
    if (equals == std::string::npos) return {without_blanks(entry), ""};
    // An empty formula is a problem, unlike no formula.
    const std::string formula = without_blanks(entry.substr(equals + 1));
    return {without_blanks(entry.substr(0, equals)), formula.empty() ? " " : formula};
}

std::vector<ControlState> control_states(const Json& recipe) {
    std::vector<ControlState> states;
    const std::vector<RecipeControl> controls = controls_of(recipe);
    if (controls.empty()) return states;
    const std::vector<RecipePlace> places = recipe_places(recipe);
    for (const RecipeControl& control : controls) {
        const RecipePlace& place = *find_place(places, control.sets[0]);
        states.push_back({control, place.path, place.value, is_whole_number(place)});
    }
    return states;
}

bool sets_control(const Json& recipe, const std::string& setting) {
    return std::ranges::any_of(controls_of(recipe), is_named_in(setting));
}

std::string nearest_control(const Json& recipe, const std::string& setting) {
    const std::string name = name_and_value(setting).first;
    if (name.find('.') != std::string::npos || recipe_schema().child(name)) return "";
    const std::vector<RecipeControl> controls = controls_of(recipe);
    std::vector<std::string_view> names;
    for (const RecipeControl& control : controls) names.push_back(control.name);
    return std::string(nearest_word(name, names));
}

std::vector<ControlEdit> control_edits(const Json& recipe, const std::vector<std::string>& settings,
                                       const std::vector<ControlEdit>& plain) {
    const std::vector<RecipeControl> controls = controls_of(recipe);
    const std::vector<RecipePlace> places = recipe_places(recipe);
    std::vector<ControlEdit> edits = plain, left;
    for (ControlEdit& edit : edits)
        if (const RecipePlace* place = find_place(places, edit.path)) edit.path = place->path;
    for (const std::string& setting : settings)
        std::ranges::move(edits_of(setting, control_named(setting, controls), places),
                          std::back_inserter(edits));
    check_set_once(edits, plain.size());
    for (std::size_t i = plain.size(); i < edits.size(); ++i) {
        check_no_keys(recipe, edits[i]);
        if (!yields(edits[i], edits)) left.push_back(edits[i]);
    }
    return left;
}

}  // namespace burl
