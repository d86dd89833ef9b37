#include "app/recipe_check.h"

#include <algorithm>
#include <cmath>

#include "app/schema_tree.h"
#include "atlas/error.h"
#include "procedural/noise_spec.h"

namespace burl {

namespace {

std::string join(const std::string& path, std::string_view key) {
    return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}

std::string quoted_list(const std::vector<std::string_view>& words) {
    return fmt::format("\"{}\"", fmt::join(words, "\", \""));
}

/// A value as messages show it: not more than a line of it.
std::string shown(const Json& value) {
    if (value.is_object()) return "an object";
    if (std::any_of(value.begin(), value.end(), [](const Json& v) { return v.is_structured(); }))
        return "an array of arrays or objects";
    const std::string text = print_json_value(value);
    return text.size() <= 60 ? text : text.substr(0, 57) + "...";
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
            return "an sRGB colour \"#rrggbb\"";
    }
    return {};
}

bool number_fits(const Parameter& p, const Json& value) {
    if (!value.is_number()) return false;
    const double x = value.get<double>();
    return std::isfinite(x) && x >= p.low && x <= p.high;
}

bool is_color(const std::string& text) {
    return text.size() == 7 && text[0] == '#' &&
           text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
}

bool is_utf8(const Json& text) {
    try {
        (void)text.dump();
        return true;
    } catch (const Json::type_error&) {
        return false;  // the library throws for what it could not write
    }
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
            return value.is_string() && is_utf8(value);
        case ParameterType::color:
            return value.is_string() && is_color(value.get_ref<const std::string&>());
        case ParameterType::choice: {
            const auto words = split_choices(p.choices);
            return value.is_string() &&
                   std::find(words.begin(), words.end(), value.get_ref<const std::string&>()) !=
                       words.end();
        }
    }
    return false;
}

using Found = std::optional<RecipeProblem>;

Found check(const SchemaNode& node, const Json& value, const std::string& path);

RecipeProblem mismatch(const std::string& path, const Json& value, const std::string& wanted) {
    return {path, fmt::format("{} is {}, must be {}", path.empty() ? "the recipe" : path,
                              shown(value), wanted)};
}

Found check_leaf(const Parameter& parameter, const Json& value, const std::string& path) {
    if (fits(parameter, value)) return {};
    // For one wrong number of an array, name its index.
    if (parameter.type == ParameterType::numbers && value.is_array() &&
        value.size() == parameter.count) {
        for (std::size_t i = 0; i < value.size(); ++i)
            if (!number_fits(parameter, value[i]))
                return mismatch(join(path, std::to_string(i)), value[i],
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

Found check_array(const SchemaNode& node, const Json& value, const std::string& path) {
    if (!value.is_array()) return mismatch(path, value, "an array");
    const SchemaNode& item = *node.children[0].second;
    for (std::size_t i = 0; i < value.size(); ++i)
        if (Found found = check(item, value[i], join(path, std::to_string(i)))) return found;
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
        if (Found found = check(*node.children[i].second, value[i], join(path, std::to_string(i))))
            return found;
    return {};
}

RecipeProblem unknown_key(const SchemaNode& node, const std::string& key, const std::string& path) {
    std::vector<std::string_view> known;
    for (const auto& [name, child] : node.children) known.push_back(name);
    const std::string_view nearest = nearest_word(key, known);
    const std::string hint = nearest.empty() ? fmt::format("known keys: {}", quoted_list(known))
                                             : fmt::format("did you mean \"{}\"?", nearest);
    return {join(path, key), fmt::format("unknown key {} in {}; {}", shown(Json(key)),
                                         path.empty() ? "the recipe" : path, hint)};
}

Found check_object(const SchemaNode& node, const Json& value, const std::string& path) {
    if (!value.is_object()) return mismatch(path, value, "an object");
    // The kind of a node decides what its other keys may be, so it is looked at first.
    if (const SchemaNode* kind = node.child("node"); kind && value.contains("node"))
        if (Found found = check(*kind, value["node"], join(path, "node"))) return found;
    for (const auto& item : value.items()) {
        const SchemaNode* child = node.child(item.key());
        if (!child) return unknown_key(node, item.key(), path);
        if (Found found = check(*child, item.value(), join(path, item.key()))) return found;
    }
    return {};
}

Found check(const SchemaNode& node, const Json& value, const std::string& path) {
    if (node.parameter) return check_leaf(*node.parameter, value, path);
    if (node.is_array()) return check_array(node, value, path);
    if (node.is_tuple()) return check_tuple(node, value, path);
    return check_object(node, value, path);
}

/// What the table cannot say: a colour map has stops, in order.
Found check_stops(const Json& recipe) {
    const Json::json_pointer pointer("/texture/stops");
    if (!recipe.contains(pointer)) return {};
    const Json& stops = recipe[pointer];
    if (stops.empty())
        return RecipeProblem{"texture.stops",
                             "texture.stops is empty, must have at least one stop"};
    for (std::size_t i = 1; i < stops.size(); ++i) {
        if (stops[i][0].get<double>() >= stops[i - 1][0].get<double>()) continue;
        const std::string path = fmt::format("texture.stops.{}.0", i);
        return RecipeProblem{
            path, fmt::format("{} is {}, must not be below the stop before it ({})", path,
                              shown(stops[i][0]), shown(stops[i - 1][0]))};
    }
    return {};
}

/// Why a noise term cannot repeat as asked, without its path; empty if it can.
std::string period_problem(const Json& term) {
    const auto number = [&term](const char* key, double otherwise) {
        return term.contains(key) ? term[key].get<double>() : otherwise;
    };
    const double lacunarity = number("lacunarity", 2.0);
    const bool simplex = term.value("kind", "value") == "simplex";
    for (const Json& item : term["period"]) {
        const double period = item.get<double>();
        if (period != std::floor(period)) return "must be whole numbers of cells";
        if (period == 0.0) continue;
        if (simplex && std::fmod(period, 3.0) != 0.0) return "must be multiples of 3 for simplex";
        if (lacunarity != std::floor(lacunarity)) return "needs a whole lacunarity";
        if (period * std::pow(lacunarity, number("octaves", 1.0) - 1.0) > double(largest_period))
            return fmt::format("exceeds {} cells in the last octave; use fewer octaves",
                               largest_period);
    }
    return {};
}

Found check_periods(const Json& recipe) {
    const Json::json_pointer pointer("/texture/input/noise");
    if (!recipe.contains(pointer)) return {};
    for (std::size_t i = 0; i < recipe[pointer].size(); ++i) {
        const Json& term = recipe[pointer][i];
        if (!term.contains("period")) continue;
        const std::string sentence = period_problem(term);
        if (sentence.empty()) continue;
        const std::string path = fmt::format("texture.input.noise.{}.period", i);
        return RecipeProblem{path,
                             fmt::format("{} is {}, {}", path, shown(term["period"]), sentence)};
    }
    return {};
}

}  // namespace

std::optional<RecipeProblem> find_problem(const Json& recipe) {
    if (Found found = check(build_schema(), recipe, "")) return found;
    if (Found found = check_stops(recipe)) return found;
    return check_periods(recipe);
}

}  // namespace burl
