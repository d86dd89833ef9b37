#include "procedural/glsl/duals.h"

#include <fmt/format.h>

#include "procedural/graph/box_means.h"
#include "procedural/graph/table.h"

namespace burl {

std::string GlslDuals::new_name(std::string_view stem) {
    return fmt::format("{}{}", stem, variables_++);
}

void GlslDuals::line(const std::string& text) {
    lines_ += fmt::format("    {}\n", text);
}

std::string GlslDuals::constant(double value) const {
    return fmt::format("dual({})", number(value));
}

std::string GlslDuals::real3(const Vec3d& v) const {
    return fmt::format("real3({}, {}, {})", number(v.x), number(v.y), number(v.z));
}

std::string GlslDuals::variable(const std::string& type, const std::string& expression) {
    std::string name = new_name("d");
    line(fmt::format("{} {} = {};", type, name, expression));
    return name;
}

std::string GlslDuals::along(const std::string& x, char step) const {
    return filter_ ? fmt::format("dot_of({}.yzw, step_{})", x, step) : number(0.0);
}

std::string GlslDuals::box_width(const std::string& x) const {
    if (!filter_) return number(0.0);
    return fmt::format("length_of({}, {})", along(x, 'u'), along(x, 'v'));
}

/// The expression of the inputs' sum with these factors, without the terms of factor 0.
std::string GlslDuals::sum(const std::vector<double>& factors, double offset) const {
    std::vector<double> used;
    std::vector<std::string> terms;
    for (std::size_t k = 0; k < factors.size(); ++k) {
        if (factors[k] == 0.0) continue;
        used.push_back(factors[k]);
        terms.push_back(in(k));
    }
    if (terms.empty()) return constant(offset);
    const std::string text = glsl_sum(used, terms, 0.0, functions_.real());
    return offset == 0.0 ? text : fmt::format("{} + {}", text, constant(offset));
}

/// The call "FUNCTION(input 0, input 1, ...)".
std::string GlslDuals::inputs_of(const char* function) const {
    return fmt::format("{}({})", function, fmt::join(inputs_, ", "));
}

std::string GlslDuals::expression(const ValueOperation& work) const {
    const auto [p, q, r, s] = work.parameters;
    switch (work.op) {
        case ValueOp::constant:
            return constant(p);
        case ValueOp::affine:
            return sum({p, q, r}, s);
        case ValueOp::linear:
            return sum({p}, q);
        case ValueOp::combine:
            return sum({p, q});
        case ValueOp::add:
            return fmt::format("{} + {}", in(0), in(1));
        case ValueOp::multiply:
            return inputs_of("dual_product");
        case ValueOp::products:
            return fmt::format("dual_product({}, {}) + dual_product({}, {})", in(0), in(1), in(2),
                               in(3));
        case ValueOp::ratio:
            return inputs_of("dual_ratio");
        case ValueOp::minimum:
            return inputs_of("dual_min");
        case ValueOp::maximum:
            return inputs_of("dual_max");
        case ValueOp::absolute:
            return inputs_of("dual_abs");
        case ValueOp::floor:
            return inputs_of("dual_floor");
        case ValueOp::fract:
            return inputs_of("dual_fract");
        case ValueOp::odd:
            return fmt::format("dual(odd_cell({}.x))", in(0));
        case ValueOp::at_least:
            return fmt::format("dual({}.x >= {} ? {} : {})", in(0), number(p), number(1.0),
                               number(0.0));
        case ValueOp::smoothstep:
            return fmt::format("dual_smoothstep({}, {}, {})", number(p), number(q), in(0));
        case ValueOp::lerp:
            return inputs_of("dual_lerp");
        case ValueOp::length:
            return inputs_of("dual_length");
        case ValueOp::power:
            if (p == 0.0) return constant(1.0);
            return p == std::floor(p) ? fmt::format("dual_whole_power({}, {}u)", in(0), p)
                                      : fmt::format("dual_power({}, {})", in(0), number(p));
        case ValueOp::sine:
            return inputs_of("dual_sin");
        case ValueOp::angle:
            return inputs_of("dual_angle");
    }
    return constant(0.0);
}

GlslDuals::Names GlslDuals::step(const ValueOperation& work) {
    if (work.op == ValueOp::constant) return {constant(work.parameters[0])};
    return {dual(expression(work))};
}

GlslDuals::Names GlslDuals::step(const BoxMean& mean) {
    const char* function = mean.function == ValueOp::odd     ? "box_odd"
                           : mean.function == ValueOp::fract ? "box_fract"
                                                             : "box_sin";
    return {dual(fmt::format("{}({}, {})", function, in(0), box_width(in(0))))};
}

GlslDuals::Names GlslDuals::step(const BoxStep& share) {
    const std::string above = dual(
        fmt::format("({}) - {}", sum({share.factor}, share.offset), constant(share.threshold)));
    std::string box = fmt::format("{}, {}", above, box_width(above));
    if (share.widest < widest_box)
        box += fmt::format(", {}, {}", number(share.mean), number(share.widest));
    return {dual(fmt::format("box_step({})", box))};
}

GlslDuals::Names GlslDuals::step(const BoxPulse& pulse) {
    return {dual(
        fmt::format("box_pulse({}, {}, {})", in(0), box_width(in(0)), number(pulse.threshold)))};
}

GlslDuals::Names GlslDuals::step(const PositiveTurn&) {
    return {dual(fmt::format("{0}.x < {1} ? {0} + {2} : {0}", in(0), number(0.0), constant(1.0)))};
}

/// No shader is written of what reads a mask (no_graph_shader, no_filtered_shader).
GlslDuals::Names GlslDuals::step(const MaskRead&) {
    return {constant(0.0)};
}

/// No shader is written of functions that other programs define, either.
GlslDuals::Names GlslDuals::step(const PointFunction&) {
    return {constant(0.0), constant(0.0), constant(0.0)};
}

GlslDuals::Names GlslDuals::step(const SlopeAlong& slope) {
    return {dual(fmt::format("dual(dot_of({}, {}.yzw))", real3(slope.direction), in(0)))};
}

std::vector<std::string> GlslDuals::write(const TextureGraph& graph) {
    GraphProgram program = program_of(graph);
    program.results.resize(std::min<std::size_t>(program.results.size(), 3));  // over black
    drop_unread(program.steps, std::span<const Register>(program.results), program.registers);
    Names names(program.registers);
    for (std::size_t i = 0; i < 3; ++i)
        names[i] = dual(fmt::format("real4(solid.{}, {}, {}, {})", "xyz"[i], number(i == 0),
                                    number(i == 1), number(i == 2)));
    std::uint32_t node = 0;
    for (const GraphStep& next : program.steps) {
        if (next.node != node)
            line(fmt::format("// {} (node {})", type_of(graph.nodes[next.node]).name, next.node));
        node = next.node;
        inputs_.clear();
        for (const Register r : next.inputs) inputs_.push_back(names[r]);
        const Names outputs = std::visit([&](const auto& work) { return step(work); }, next.work);
        for (std::size_t k = 0; k < outputs.size(); ++k) names[next.outputs[k]] = outputs[k];
    }
    Names results;
    for (const Register r : program.results) results.push_back(names[r]);
    return results;
}

std::string glsl_gradient_function(const TextureGraph& graph, const std::string& name,
                                   GlslFunctions& functions, GlslMapTables& maps) {
    GlslDuals text(functions, maps, nullptr);
    const std::string result = text.write(graph).front();
    return fmt::format("real4 {}(real3 solid) {{\n{}    return {};\n}}\n\n", name, text.lines(),
                       result);
}

std::string glsl_filtered_function(const TextureGraph& graph, const std::string& name,
                                   const Filter& filter, GlslFunctions& functions,
                                   GlslMapTables& maps) {
    GlslDuals text(functions, maps, &filter);
    std::vector<std::string> results = text.write(graph);
    results.resize(3, results.front());
    return fmt::format(
        "real3 {}(real3 solid, real3 step_u, real3 step_v) {{\n{}"
        "    return real3({}.x, {}.x, {}.x);\n}}\n\n",
        name, text.lines(), results[0], results[1], results[2]);
}

}  // namespace burl
