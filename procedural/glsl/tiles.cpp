#include "procedural/glsl/tiles.h"

#include <fmt/format.h>

#include "procedural/glsl/duals.h"

namespace burl {

namespace {

constexpr const char* tiles_file = "graph/tiles.glsl";

/// The text "real3(x, y, z)"; coordinates that are missing are 0.
std::string point_of(std::span<const std::string> axes, const GlslFunctions& functions) {
    std::vector<std::string> all(axes.begin(), axes.end());
    all.resize(3, functions.number(0.0));
    return fmt::format("real3({})", fmt::join(all, ", "));
}

}  // namespace

std::string glsl_call(const CellNumber& cell, std::span<const std::string> axes,
                      GlslFunctions& functions) {
    functions.need(tiles_file);
    return fmt::format("cell_number({}, {}u)", point_of(axes, functions), cell.seed);
}

std::string glsl_call(const CellFeature& feature, std::span<const std::string> axes,
                      GlslFunctions& functions) {
    functions.need(tiles_file);
    return fmt::format("cell_feature({}, {}u, {}, {})", point_of(axes, functions),
                       feature.points.seed, functions.number(feature.points.jitter),
                       int(feature.gives));
}

std::string glsl_call(const ScatteredShapes& shapes, std::span<const std::string> axes,
                      GlslFunctions& functions) {
    functions.need(tiles_file);
    const auto number = [&](double value) { return functions.number(value); };
    return fmt::format("scattered_at(ScatteredShapes({}u, {}, {}, {}, {}, {}, {}, {}, {}), {}, {})",
                       shapes.seed, int(shapes.form), number(shapes.radius), number(shapes.spread),
                       number(shapes.turn), number(shapes.jitter), number(shapes.chance),
                       int(shapes.gives), number(shapes.outside()), axes[0], axes[1]);
}

GlslDuals::Names GlslDuals::step(const CellNumber& number) {
    Names axes = inputs_;
    for (std::string& x : axes) x += ".x";
    return {dual(fmt::format("dual({})", glsl_call(number, axes, functions_)))};
}

GlslDuals::Names GlslDuals::step(const CellFeature& feature) {
    const Names axes{in(0) + ".x", in(1) + ".x", in(2) + ".x"};
    const std::string n = variable("real4", glsl_call(feature, axes, functions_));
    return {dual(fmt::format("dual_at({0}.x, {0}.yzw, {1}, {2}, {3})", n, in(0), in(1), in(2)))};
}

GlslDuals::Names GlslDuals::step(const ScatteredShapes& shapes) {
    const Names axes{in(0) + ".x", in(1) + ".x"};
    const std::string n = variable("real4", glsl_call(shapes, axes, functions_));
    return {dual(fmt::format("dual_at({0}.x, {0}.yzw, {1}, {2}, {2})", n, in(0), in(1)))};
}

}  // namespace burl
