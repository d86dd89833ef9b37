#include "procedural/glsl/graph.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "atlas/base/error.h"
#include "procedural/glsl/duals.h"
#include "procedural/glsl/noise_sum.h"
#include "procedural/glsl/simplex.h"
#include "procedural/glsl/tiles.h"
#include "procedural/graph/masks.h"
#include "procedural/graph/table.h"
#include "procedural/graph/value_program.h"
#include "procedural/graph/values.h"

namespace burl {

namespace {

bool has_node(const TextureGraph& graph, std::string_view name) {
    return std::ranges::any_of(graph.nodes.begin() + 1, graph.nodes.end(),
                               [&](const GraphNode& node) { return type_of(node).name == name; });
}

/// The parts that functions with gradients of colours need besides those of values.
std::vector<GlslPart> color_parts(const TextureGraph& graph, const GlslMapTables& maps) {
    std::vector<GlslPart> parts{
        {"graph/dual.glsl"}, {"colour maps", maps.text()}, {"graph/dual_map.glsl"}};
    if (!graph.images.empty()) parts.push_back({"graph/dual_image.glsl"});
    return parts;
}

/// The parts that the functions of slopes need besides those of values. Slopes are of numbers, and
/// `split` alone makes numbers of colours.
std::vector<GlslPart> slope_parts(const TextureGraph& graph, const GlslMapTables& maps) {
    if (!has_node(graph, "slope")) return {};
    if (has_node(graph, "split")) return color_parts(graph, maps);
    return {{"graph/dual.glsl"}};
}

/// A step as text. Constants need no line: their output is the number itself.
struct GlslStep {
    std::string lines;
    std::vector<std::string> outputs;  ///< expressions of type real
};

/// The steps of a value program as GLSL: lines of the function that evaluates it, and functions
/// that precede it.
class GlslSteps {
  public:
    GlslSteps(const ValueProgram& program, GlslFunctions& functions);

    /// The colour maps of functions with gradients.
    const GlslMapTables& maps() const { return maps_; }
    /// Writes a step; `inputs` are operands.
    GlslStep write(const ValueWork& work, const std::vector<std::string>& inputs);

  private:
    using Inputs = std::vector<std::string>;

    GlslStep step(const ValueOperation& operation, const Inputs& inputs);
    GlslStep step(const NoiseSum& sum, const Inputs& inputs);
    GlslStep step(const SimplexOctaves& octaves, const Inputs& inputs);
    GlslStep step(const CurlOctaves& octaves, const Inputs& inputs);
    GlslStep step(const ColorPieces& pieces, const Inputs& inputs);
    GlslStep step(const DotsWeight& dots, const Inputs& inputs);
    GlslStep step(const CellNumber& cell, const Inputs& inputs);
    GlslStep step(const CellFeature& feature, const Inputs& inputs);
    GlslStep step(const ScatteredShapes& shapes, const Inputs& inputs);
    GlslStep step(const ImageLookup& lookup, const Inputs& inputs);
    GlslStep step(const GraphSlope& slope, const Inputs& inputs);
    GlslStep step(const MaskRead& read, const Inputs& inputs);

    std::string number(double value) const { return functions_.number(value); }
    std::string expression(const ValueOperation& operation, const Inputs& in) const;
    /// The step "real vN = expression;".
    GlslStep value(const std::string& expression);
    /// The step "real3 colorN = expression;".
    GlslStep color(const std::string& expression);

    GlslFunctions& functions_;
    GlslNoiseSums sums_;
    GlslMapTables maps_;
    bool has_angles_ = false;  ///< only angles depend on signs of zeros
    std::size_t values_ = 0;
    std::vector<std::pair<std::shared_ptr<const GraphEvaluator>, std::string>> graphs_;
};

GlslSteps::GlslSteps(const ValueProgram& program, GlslFunctions& functions)
    : functions_(functions), sums_(functions), maps_(functions.real()) {
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
    const std::string zero = number(0.0), one = number(1.0);
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

/// Writes a value program: a variable per step, with a comment that names the step's node.
class GraphWriter {
  public:
    GraphWriter(const TextureGraph& graph, GlslReal real)
        : graph_(graph), values_(graph), functions_(real), steps_(values_.program(), functions_) {}

    GlslTexture texture() {
        names_ = {"solid.x", "solid.y", "solid.z"};
        for (const ValueStep& step : values_.program().steps()) write(step);
        std::string body = "real3 texture_color(real3 solid) {\n" + lines_;
        body += fmt::format("    return real3({}, {}, {});\n}}\n", name(values_.results()[0]),
                            name(values_.results()[1]), name(values_.results()[2]));
        return functions_.texture(body, slope_parts(graph_, steps_.maps()));
    }

  private:
    const std::string& name(Register r) const { return names_[r]; }

    void write(const ValueStep& step) {
        std::vector<std::string> inputs;
        for (const Register r : step.inputs) inputs.push_back(glsl_operand(name(r)));
        GlslStep written = steps_.write(step.work, inputs);
        if (!written.lines.empty() && step.node != node_) {
            node_ = step.node;
            lines_ += fmt::format("    // {} (node {})\n", type_of(graph_.nodes[step.node]).name,
                                  step.node);
        }
        lines_ += written.lines;
        for (std::size_t i = 0; i < step.outputs.size(); ++i) {
            const Register r = step.outputs[i];
            names_.resize(std::max<std::size_t>(names_.size(), r + 1));
            names_[r] = std::move(written.outputs[i]);
        }
    }

    const TextureGraph& graph_;
    GraphValues values_;
    GlslFunctions functions_;
    GlslSteps steps_;
    std::string lines_;
    std::vector<std::string> names_;  ///< expressions of the registers at the current step
    std::uint32_t node_ = 0;
};

/// The reason why colour maps with gradients, whose stops are written out, are too large; empty
/// where none is.
std::string too_many_stops(const TextureGraph& graph) {
    for (const Texture& texture : graph.textures)
        if (texture.colors.stops.size() > most_sloped_stops)
            return fmt::format(
                "a colour map of it has {} stops, and shaders with gradients take at most {}",
                texture.colors.stops.size(), most_sloped_stops);
    return "";
}

void check(const std::string& why) {
    if (!why.empty())
        throw Error(ExitCode::unsupported,
                    fmt::format("the texture cannot be written as GLSL: {}", why));
}

}  // namespace

std::string no_graph_shader(const TextureGraph& graph) {
    const std::string mask = first_mask_node(graph, GraphOutput::color);
    if (!mask.empty()) return no_texels_for(mask);
    return has_node(graph, "slope") ? too_many_stops(graph) : "";
}

std::string no_filtered_shader(const TextureGraph& graph, const Filter& filter) {
    const std::string mask = first_mask_node(graph, GraphOutput::color);
    if (!mask.empty()) return no_texels_for(mask);
    const bool tables = filter.kind == FilterKind::table_mip ||
                        filter.kind == FilterKind::table_sat ||
                        filter.kind == FilterKind::table_sat3;
    if (tables && has_node(graph, "color_map"))
        return "colour tables filter graphs on the host alone";
    return too_many_stops(graph);
}

GlslTexture glsl_graph(const TextureGraph& graph, GlslReal real) {
    check(no_graph_shader(graph));
    return GraphWriter(graph, real).texture();
}

GlslTexture glsl_filtered_graph(const TextureGraph& graph, const Filter& filter, GlslReal real) {
    check(no_filtered_shader(graph, filter));
    GlslFunctions functions(real);
    GlslMapTables maps(real);
    const std::string body =
        glsl_filtered_function(graph, "texture_color", filter, functions, maps);
    return functions.texture(body, color_parts(graph, maps));
}

}  // namespace burl
