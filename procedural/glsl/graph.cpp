#include "procedural/glsl/graph.h"

#include <algorithm>

#include <fmt/format.h>

#include "atlas/base/error.h"
#include "procedural/glsl/duals.h"
#include "procedural/glsl/steps.h"
#include "procedural/graph/table.h"
#include "procedural/graph/values.h"

namespace burl {

namespace {

/// The parts that functions with gradients need besides those of values.
std::vector<GlslPart> gradient_parts(const ValueProgram& program) {
    for (const ValueStep& step : program.steps())
        if (std::holds_alternative<GraphSlope>(step.work)) return {{"graph/dual.glsl"}};
    return {};
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
        return functions_.texture(body, gradient_parts(values_.program()));
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

}  // namespace

std::string no_graph_shader(const TextureGraph& graph) {
    for (std::size_t n = 1; n < graph.nodes.size(); ++n)
        if (type_of(graph.nodes[n]).name == "slope") return too_many_stops(graph);
    return "";
}

std::string no_filtered_shader(const TextureGraph& graph, const Filter& filter) {
    const bool tables = filter.kind == FilterKind::table_mip ||
                        filter.kind == FilterKind::table_sat ||
                        filter.kind == FilterKind::table_sat3;
    for (std::size_t n = 1; n < graph.nodes.size(); ++n) {
        const std::string_view name = type_of(graph.nodes[n]).name;
        if (name == "color_map" && tables) return "colour tables filter graphs on the host alone";
    }
    return too_many_stops(graph);
}

namespace {

void check(const std::string& why) {
    if (!why.empty())
        throw Error(ExitCode::unsupported,
                    fmt::format("the texture cannot be written as GLSL: {}", why));
}

}  // namespace

GlslTexture glsl_graph(const TextureGraph& graph, GlslReal real) {
    check(no_graph_shader(graph));
    return GraphWriter(graph, real).texture();
}

GlslTexture glsl_filtered_graph(const TextureGraph& graph, const Filter& filter, GlslReal real) {
    check(no_filtered_shader(graph, filter));
    GlslFunctions functions(real);
    GlslFiltering filtering{filter, GlslMapTables(real)};
    const std::string body = glsl_filtered_function(graph, "texture_color", functions, filtering);
    std::vector<GlslPart> parts{
        {"graph/dual.glsl"}, {"colour maps", filtering.maps.text()}, {"graph/dual_map.glsl"}};
    if (!graph.images.empty()) parts.push_back({"graph/dual_image.glsl"});
    return functions.texture(body, parts);
}

}  // namespace burl
