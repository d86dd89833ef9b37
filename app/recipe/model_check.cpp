#include "app/recipe/model_check.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "procedural/noise/spec.h"

namespace burl {

namespace {

using Found = std::optional<RecipeProblem>;

/// The first problem of a colour map's stops: there must be at least one, and positions must not
/// descend.
Found check_stops(const Json& map, const std::string& map_path) {
    if (!map.contains("stops")) return {};
    const Json& stops = map["stops"];
    const std::string stops_path = join_path(map_path, "stops");
    if (stops.empty())
        return RecipeProblem{stops_path, stops_path + " is empty, must have at least one stop"};
    for (std::size_t i = 1; i < stops.size(); ++i) {
        if (stops[i][0].get<double>() >= stops[i - 1][0].get<double>()) continue;
        const std::string path = fmt::format("{}.{}.0", stops_path, i);
        return RecipeProblem{
            path, fmt::format("{} is {}, must not be below the stop before it ({})", path,
                              shown(stops[i][0]), shown(stops[i - 1][0]))};
    }
    return {};
}

/// The reason why a noise term cannot have its period, without its path; empty where it can.
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

/// The reason why a noise term cannot have a time, without its path; empty where it can.
std::string term_time_problem(const Json& term) {
    const bool still = !term.contains("period") ||
                       std::all_of(term["period"].begin(), term["period"].end(),
                                   [](const Json& cells) { return cells.get<double>() == 0.0; });
    return time_problem(term.value("kind", "value"),
                        !still || term.value("time_period", 0.0) != 0.0);
}

/// The first noise term whose period or time its kind cannot have.
Found check_noise(const Json& field, const std::string& field_path) {
    if (!field.contains("noise")) return {};
    for (std::size_t i = 0; i < field["noise"].size(); ++i) {
        const Json& term = field["noise"][i];
        for (const auto& [key, problem] :
             {std::pair("period", &period_problem), std::pair("time", &term_time_problem)}) {
            if (!term.contains(key)) continue;
            const std::string sentence = problem(term);
            if (sentence.empty()) continue;
            const std::string path = fmt::format("{}.noise.{}.{}", field_path, i, key);
            return RecipeProblem{path,
                                 fmt::format("{} is {}, {}", path, shown(term[key]), sentence)};
        }
    }
    return {};
}

}  // namespace

std::string time_problem(std::string_view kind, bool repeats) {
    if (kind == "perlin1985") return "but perlin1985 noise has no fourth dimension; use perlin";
    if (kind == "simplex" && repeats)
        return "but simplex noise in four dimensions has no period; use perlin";
    return "";
}

Found find_map_problem(const Json& map, const std::string& path) {
    for (const char* key : {"wrap", "stops"}) {
        if (!map.contains(key)) continue;
        if (Found found = check_value(*recipe_schema().child("texture")->child(key), map[key],
                                      join_path(path, key)))
            return found;
    }
    return check_stops(map, path);
}

Found find_field_problem(const Json& field, const std::string& path) {
    if (Found found = check_value(*recipe_schema().child("texture")->child("input"), field, path))
        return found;
    return check_noise(field, path);
}

}  // namespace burl
