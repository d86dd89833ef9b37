#include "procedural/glsl_graph.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "atlas/error.h"
#include "procedural/glsl_steps.h"
#include "procedural/graph_table.h"
#include "procedural/graph_values.h"

namespace burl {

namespace {

/// What functions with gradients need besides those of values.
std::span<const std::string_view> graph_files(const ValueProgram& program) {
    static constexpr std::array<std::string_view, 1> dual{"dual.glsl"};
    for (const ValueStep& step : program.steps())
        if (std::holds_alternative<GraphSlope>(step.work)) return dual;
    return {};
}

/// Walks the program: one value per step, under the name of the node it was added for.
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
        return functions_.texture(body, graph_files(values_.program()));
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
    std::vector<std::string> names_;  ///< what the program's arrays hold at the current step
    std::uint32_t node_ = 0;
};

}  // namespace

std::string no_graph_shader(const TextureGraph& graph) {
    for (const Texture& texture : graph.textures)
        if (texture.colors.stops.size() > most_glsl_stops)
            return fmt::format("a colour map of it has {} stops, and shaders take at most {}",
                               texture.colors.stops.size(), most_glsl_stops);
    return "";
}

GlslTexture glsl_graph(const TextureGraph& graph, GlslReal real) {
    if (const std::string why = no_graph_shader(graph); !why.empty())
        throw Error(ExitCode::unsupported,
                    fmt::format("the texture cannot be written as GLSL: {}", why));
    return GraphWriter(graph, real).texture();
}

TextureGraph graph_of_texture(const Texture& texture) {
    const auto type = [](std::string_view name) {
        return std::uint32_t(find_node(name) - graph_table().data());
    };
    TextureGraph graph;
    graph.textures = {texture};
    graph.nodes.resize(3);
    graph.nodes[0].wire = Wire::point;
    GraphNode &field = graph.nodes[1], &color = graph.nodes[2];
    field.type = type("field");
    field.texture = color.texture = 0;
    color.type = type("color_map");
    color.wire = Wire::color;
    color.inputs = {1};
    return graph;
}

}  // namespace burl
