#include "procedural/glsl/value_steps.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "procedural/glsl/simplex.h"
#include "procedural/glsl/tiles.h"

namespace burl {

GlslSteps::GlslSteps(const ValueProgram& program, GlslFunctions& functions, GlslMapTables& maps)
    : functions_(functions), sums_(functions), maps_(maps) {
    for (const ValueStep& step : program.steps()) {
        const auto* operation = std::get_if<ValueOperation>(&step.work);
        if (operation && operation->op == ValueOp::angle) has_angles_ = true;
    }
}

GlslStep GlslSteps::write(const ValueWork& work, const Inputs& inputs) {
    return std::visit([&](const auto& known) { return step(known, inputs); }, work);
}

GlslStep GlslSteps::value(const std::string& expression) {
    const std::string name = fmt::format("v{}", values_++);
    return {fmt::format("    exact real {} = {};\n", name, expression), {name}};
}

GlslStep GlslSteps::color(const std::string& expression) {
    const std::string name = fmt::format("color{}", values_++);
    return {fmt::format("    real3 {} = {};\n", name, expression),
            {name + ".r", name + ".g", name + ".b"}};
}

GlslStep GlslSteps::step(const ValueOperation& operation, const Inputs& inputs) {
    if (operation.op == ValueOp::constant) return {"", {number(operation.parameters[0])}};
    return value(expression(operation, inputs));
}

std::string GlslSteps::expression(const ValueOperation& operation, const Inputs& in) const {
    const auto [p, q, r, s] = operation.parameters;
    const auto sum = [&](const std::vector<double>& factors, double constant) {
        std::string text = glsl_sum(factors, in, constant, functions_.real());
        return constant == 0.0 && has_angles_ ? fmt::format("unsigned_zero({})", text) : text;
    };
    std::string zero = number(0.0);
    const std::string one = number(1.0);
    const auto product = [&](const std::string& a, const std::string& b) {
        return a == one ? b : b == one ? a : fmt::format("{} * {}", a, b);
    };
    switch (operation.op) {
        case ValueOp::constant:
            break;
        case ValueOp::affine:
            return sum({p, q, r}, s);
        case ValueOp::linear:
            return sum({p}, q);
        case ValueOp::combine:
            return sum({p, q}, r);
        case ValueOp::add:
            return fmt::format("{} + {}", in[0], in[1]);
        case ValueOp::multiply:
            return fmt::format("{} * {}", in[0], in[1]);
        case ValueOp::products:
            return fmt::format("{} + {}", product(in[0], in[1]), product(in[2], in[3]));
        case ValueOp::ratio:
            return fmt::format("ratio({}, {})", in[0], in[1]);
        case ValueOp::minimum:
            return fmt::format("{1} < {0} ? {1} : {0}", in[0], in[1]);
        case ValueOp::maximum:
            return fmt::format("{0} < {1} ? {1} : {0}", in[0], in[1]);
        case ValueOp::absolute:
            return fmt::format("abs({})", in[0]);
        case ValueOp::floor:
            return fmt::format("floor({})", in[0]);
        case ValueOp::fract:
            return fmt::format("fraction_of({})", in[0]);
        case ValueOp::odd:
            return fmt::format("odd_cell({})", in[0]);
        case ValueOp::at_least:
            return fmt::format("{} >= {} ? {} : {}", in[0], number(p), one, zero);
        case ValueOp::smoothstep:
            return fmt::format("smooth_step({}, {}, {})", number(p), number(q), in[0]);
        case ValueOp::lerp:
            return fmt::format("blend({}, {}, {})", in[0], in[1], in[2]);
        case ValueOp::length:
            return fmt::format("length_of({}, {})", in[0], in[1]);
        case ValueOp::power:
            return p == std::floor(p) ? fmt::format("whole_power({}, {}u)", in[0], p)
                                      : fmt::format("power({}, {})", in[0], number(p));
        case ValueOp::sine:
            return fmt::format("sine({})", in[0]);
        case ValueOp::angle:
            return fmt::format("angle({}, {})", in[0], in[1]);
    }
    return zero;
}

GlslStep GlslSteps::step(const NoiseSum& sum, const Inputs& inputs) {
    if (sum.octaves.empty()) return {"", {number(sum.offset)}};
    const GlslSum written = sums_.values(sum, inputs, fmt::format("n{}", values_));
    GlslStep step = value(written.result);
    step.lines.insert(0, written.lines);
    return step;
}

GlslStep GlslSteps::step(const SimplexOctaves& octaves, const Inputs& inputs) {
    return value(glsl_simplex_sum(octaves, inputs, functions_));
}

GlslStep GlslSteps::step(const CurlOctaves& octaves, const Inputs& inputs) {
    return color(glsl_curl_sum(octaves, inputs, functions_));
}

GlslStep GlslSteps::step(const ColorPieces& pieces, const Inputs& inputs) {
    return color(fmt::format("{}({})", functions_.color_map(pieces), inputs[0]));
}

GlslStep GlslSteps::step(const DotsWeight& dots, const Inputs& inputs) {
    return value(fmt::format("dot_weight({}, {}, {}u, uvec2({}u, {}u), {})", inputs[0], inputs[1],
                             dots.seed, dots.period_u, dots.period_v, number(dots.radius)));
}

GlslStep GlslSteps::step(const CellNumber& cell, const Inputs& inputs) {
    return value(glsl_call(cell, inputs, functions_));
}

GlslStep GlslSteps::step(const CellFeature& feature, const Inputs& inputs) {
    return value(glsl_call(feature, inputs, functions_) + ".x");
}

GlslStep GlslSteps::step(const ScatteredShapes& shapes, const Inputs& inputs) {
    return value(glsl_call(shapes, inputs, functions_) + ".x");
}

GlslStep GlslSteps::step(const ImageLookup& lookup, const Inputs& inputs) {
    return color(fmt::format("image_color({}, {}, {}, {})", functions_.image(lookup.pixels),
                             inputs[0], inputs[1], int(lookup.wrap)));
}

/// Writes the graph as a function of its own, with gradients.
GlslStep GlslSteps::step(const GraphSlope& slope, const Inputs&) {
    const auto same = [&](const auto& known) {
        return known.first->graph() == slope.graph->graph();
    };
    auto known = std::ranges::find_if(graphs_, same);
    if (known == graphs_.end()) {
        const std::string name = functions_.new_name("gradient");
        functions_.add(glsl_gradient_function(slope.graph->graph(), name, functions_, maps_));
        known = graphs_.emplace(graphs_.end(), slope.graph, name);
    }
    const Vec3d& d = slope.direction;
    return value(fmt::format("dot_of(real3({}, {}, {}), {}(solid).yzw)", number(d.x), number(d.y),
                             number(d.z), known->second));
}

/// No shader is written of what reads a mask (no_graph_shader).
GlslStep GlslSteps::step(const MaskRead&, const Inputs&) {
    return {"", {number(0.0)}};
}

/// No shader is written of functions that other programs define, either.
GlslStep GlslSteps::step(const PointFunction&, const Inputs&) {
    return {"", {number(0.0), number(0.0), number(0.0)}};
}

}  // namespace burl
