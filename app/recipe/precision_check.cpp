#include "app/recipe/precision_check.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "procedural/graph/json.h"

namespace burl {

namespace {

/// The feature of a noise term that has no fixed-point form; empty where all have one.
std::string noise_problem(const Json& term) {
    const std::string kind = term.value("kind", "value");
    if (kind != "value" && kind != "perlin") return kind + " noise";
    if (term.contains("time")) return "noise in time";
    const Json period = term.value("period", Json::array());
    const bool repeats = std::any_of(period.begin(), period.end(),
                                     [](const Json& cells) { return cells.get<double>() != 0.0; });
    return repeats ? "noise with a period" : "";
}

std::string texture_problem(const Json& texture) {
    if (is_graph(texture))
        return "the texture has other nodes than a color_map over a field; use float64";
    const Json none = Json::object();
    const Json& field = texture.contains("input") ? texture["input"] : none;
    if (!field.contains("noise")) return "";
    for (std::size_t i = 0; i < field["noise"].size(); ++i)
        if (const std::string problem = noise_problem(field["noise"][i]); !problem.empty())
            return fmt::format(
                "texture.input.noise.{} is {}; fixed point has value and perlin noise without "
                "period and time",
                i, problem);
    return "";
}

std::string filter_problem(const Json& filter) {
    const std::string kind = filter.value("kind", "none");
    if (kind != "none" && kind != "supersample")
        return fmt::format(
            "filter.kind is \"{}\", which needs gradients, and fixed point has none; use "
            "supersample or none",
            kind);
    if (filter.value("octaves", "keep") == "fade")
        return "filter.octaves is \"fade\"; fixed point keeps all octaves";
    return "";
}

}  // namespace

std::optional<RecipeProblem> find_precision_problem(const Json& recipe) {
    const Json none = Json::object();
    const auto part = [&](const char* key) -> const Json& {
        return recipe.contains(key) ? recipe[key] : none;
    };
    if (part("precision").value("kind", "") != "fixed") return {};
    std::string problem = texture_problem(part("texture"));
    if (problem.empty()) problem = filter_problem(part("filter"));
    if (problem.empty()) return {};
    return RecipeProblem{"precision.kind",
                         fmt::format("precision.kind is \"fixed\", but {}", problem)};
}

}  // namespace burl
