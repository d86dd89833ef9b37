// The check of a recipe's "controls" (controls.h).
#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "app/base/messages.h"
#include "app/recipe/edit/controls.h"
#include "app/recipe/edit/formula.h"

namespace burl {

namespace {

constexpr std::size_t most_controls = 100;  // more would not be few

using FoundProblem = std::optional<RecipeProblem>;

std::string letters_lowered(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return text;
}

/// Whether a control of this name could be mistaken for a path: one of its parts before a dot is a
/// key of recipes.
bool is_path_name(const std::string& name) {
    const std::string_view first = std::string_view(name).substr(0, name.find('.'));
    return first == "define" || recipe_schema().child(first) != nullptr;
}

/// The checks of one recipe's controls.
class ControlChecker {
  public:
    explicit ControlChecker(const Json& recipe)
        : controls_(recipe["controls"]), places_(recipe_places(recipe)) {}

    FoundProblem check(std::size_t index) {
        const Json& control = controls_[index];
        at_ = fmt::format("controls.{}", index);
        for (const char* key : {"name", "sets"})
            if (!control.contains(key))
                return RecipeProblem{at_, fmt::format("{}.{} is missing", at_, key)};
        if (FoundProblem found = check_name(index)) return found;
        if (control["sets"].empty())
            return RecipeProblem{at_ + ".sets",
                                 at_ + ".sets is empty, must have at least one path"};
        paths_.clear();
        for (std::size_t i = 0; i < control["sets"].size(); ++i)
            if (FoundProblem found = check_target(control, i)) return found;
        return check_value_of(control);
    }

  private:
    FoundProblem check_name(std::size_t index) const {
        const Json& json = controls_[index]["name"];
        const std::string name = json.get<std::string>(), path = at_ + ".name";
        if (name.empty() || name.front() == ' ' || name.back() == ' ')
            return mismatch(path, json, "a name without blanks around it");
        if (name.find('=') != std::string::npos)
            return mismatch(path, json, "a name without \"=\"");
        if (is_path_name(name)) return mismatch(path, json, "a name that is no path of a recipe");
        for (std::size_t i = 0; i < index; ++i)
            if (letters_lowered(controls_[i]["name"].get<std::string>()) == letters_lowered(name))
                return mismatch(path, json,
                                fmt::format("another name than that of controls.{}", i));
        return {};
    }

    /// Checks an entry of "sets" and notes its place in paths_.
    FoundProblem check_target(const Json& control, std::size_t i) {
        const Json& entry = control["sets"][i];
        const ControlTarget target = control_target(entry.get<std::string>());
        const std::string path = fmt::format("{}.sets.{}", at_, i);
        const RecipePlace* place = find_place(places_, target.path);
        if (!place) return unknown_place(entry, target.path, path);
        const auto known = std::ranges::find(paths_, place->path);
        if (known != paths_.end())
            return mismatch(
                path, entry,
                fmt::format("another path than that of {}.sets.{}", at_, known - paths_.begin()));
        paths_.push_back(place->path);
        const bool color = find_place(places_, paths_[0])->is_color();
        if (place->is_color() != color)
            return mismatch(path, entry,
                            fmt::format("the path of a {0}, as {1}.sets.0 is one",
                                        color ? "colour" : "number", at_));
        return target.formula.empty() ? FoundProblem() : check_formula(control, target, i);
    }

    RecipeProblem unknown_place(const Json& entry, const std::string& wanted,
                                const std::string& path) const {
        std::vector<std::string_view> known;
        for (const RecipePlace& place : places_) known.push_back(place.path);
        const std::string_view nearest = nearest_word(wanted, known);
        RecipeProblem problem =
            mismatch(path, entry, "the path of a number or colour that the recipe has");
        if (!nearest.empty()) problem.sentence += fmt::format("; did you mean \"{}\"?", nearest);
        return problem;
    }

    /// Checks the range and the formula; a range that is no two numbers has been refused.
    FoundProblem check_formula(const Json& control, const ControlTarget& target,
                               std::size_t i) const {
        const std::string path = fmt::format("{}.sets.{}", at_, i);
        const auto wrong = [&](const std::string& sentence) {
            return RecipeProblem{
                path, fmt::format("{} is {}, {}", path, shown(control["sets"][i]), sentence)};
        };
        if (i == 0) return wrong("must be a path alone, whose value is the control's own");
        if (find_place(places_, paths_[0])->is_color())
            return wrong("but colours have no formulas; leave it out");
        const std::string problem = formula_problem(target.formula);
        if (!problem.empty())
            return wrong(
                fmt::format("but its formula {}; it may have numbers, x, + - * / ( ), "
                            "sqrt, abs, pow, min and max",
                            problem));
        if (!control.contains("range")) return {};
        for (const Json& end : control["range"])
            if (!std::isfinite(formula_value(target.formula, end.get<double>())))
                return wrong(
                    fmt::format("but its formula gives no number at {}, an end of the "
                                "range",
                                shown(end)));
        return {};
    }

    FoundProblem check_value_of(const Json& control) const {
        const RecipePlace& place = *find_place(places_, paths_[0]);
        const std::string path = at_ + ".range";
        if (place.is_color() && control.contains("range"))
            return mismatch(path, control["range"], "left out, since colours have no range");
        if (place.is_color()) return {};
        if (!control.contains("range"))
            return RecipeProblem{path, path +
                                           " is missing, must be the least and the greatest "
                                           "value of the number"};
        if (FoundProblem found = check_range(control, place)) return found;
        const double low = control["range"][0].get<double>();
        const double high = control["range"][1].get<double>();
        const double value = place.value.get<double>();
        if (value >= low && value <= high) return {};
        return mismatch(place.path, place.value,
                        fmt::format("from {} to {}, the range of the control {}.name, {}", low,
                                    high, at_, shown(control["name"])));
    }

    FoundProblem check_range(const Json& control, const RecipePlace& place) const {
        const Json& range = control["range"];
        const double low = range[0].get<double>(), high = range[1].get<double>();
        if (low >= high)
            return mismatch(at_ + ".range", range, "the least value, then a greater one");
        if (!place.parameter) return {};
        for (std::size_t i = 0; i < 2; ++i) {
            const double end = range[i].get<double>();
            if (end < place.parameter->low || end > place.parameter->high)
                return mismatch(fmt::format("{}.range.{}", at_, i), range[i],
                                fmt::format("from {} to {} as {}", place.parameter->low,
                                            place.parameter->high, place.path));
        }
        return {};
    }

    const Json& controls_;
    std::vector<RecipePlace> places_;
    std::string at_;                  ///< the path of the control that is checked
    std::vector<std::string> paths_;  ///< the places that it sets
};

}  // namespace

FoundProblem find_control_problem(const Json& recipe) {
    if (!recipe.contains("controls") || recipe["controls"].empty()) return {};
    if (const std::size_t count = recipe["controls"].size(); count > most_controls)
        return RecipeProblem{
            "controls",
            fmt::format("controls has {} controls, must have at most {}", count, most_controls)};
    ControlChecker checker(recipe);
    for (std::size_t i = 0; i < recipe["controls"].size(); ++i)
        if (FoundProblem found = checker.check(i)) return found;
    return {};
}

}  // namespace burl
