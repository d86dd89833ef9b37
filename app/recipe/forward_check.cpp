#include "app/recipe/forward_check.h"

#include <fmt/format.h>

#include "atlas/base/error.h"
#include "procedural/bresenham/field.h"

namespace burl {

namespace {

std::string forward_problem(const Recipe& recipe) {
    const Texture* texture = plain_texture(recipe.texture);
    if (!texture) return "the texture has other nodes than a color_map over a field";
    if (const std::string why = no_forward_form(expand_octaves(*texture)); !why.empty()) return why;
    if (recipe.filter.kind != FilterKind::none || recipe.filter.band_limit)
        return "filters need f besides the scan line, and differences run along it";
    if (recipe.precision.kind.value_or(PrecisionKind::float64) == PrecisionKind::fixed)
        return "it adds in float64 or float32, not in fixed:I.F";
    return "";
}

}  // namespace

void check_forward(const Recipe& recipe) {
    if (const std::string problem = forward_problem(recipe); !problem.empty())
        throw Error(ExitCode::usage, fmt::format("--kernel forward: {}; leave it out", problem));
}

}  // namespace burl
