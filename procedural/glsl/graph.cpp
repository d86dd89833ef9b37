#include "procedural/glsl/graph.h"

#include <algorithm>

#include <fmt/format.h>

#include "atlas/base/error.h"
#include "procedural/glsl/duals.h"
#include "procedural/glsl/value_steps.h"
#include "procedural/graph/masks.h"
#include "procedural/graph/table.h"
#include "procedural/graph/values.h"

namespace burl {

namespace {

bool has_node(const TextureGraph& graph, std::string_view name) {
    return std::ranges::any_of(graph.nodes.begin() + 1, graph.nodes.end(),
                               [&](const GraphNode& node) { return type_of(node).name == name; });
}

/// The parts that functions with gradients of colours need besides those of values.
std::vector<GlslPart> color_parts(bool images, const GlslMapTables& maps) {
    std::vector<GlslPart> parts{
        {"graph/dual.glsl"}, {"colour maps", maps.text()}, {"graph/dual_map.glsl"}};
    if (images) parts.push_back({"graph/dual_image.glsl"});
    return parts;
}

/// The parts that the functions of slopes need besides those of values. Slopes are of numbers, and
/// `split` alone makes numbers of colours.
std::vector<GlslPart> slope_parts(const TextureGraph& graph, const GlslMapTables& maps) {
    if (!has_node(graph, "slope")) return {};
    if (has_node(graph, "split")) return color_parts(!graph.images.empty(), maps);
    return {{"graph/dual.glsl"}};
}

/// The type of the planes of a material.
std::string planes_struct(const TextureGraph& graph) {
    std::string text =
        "// The channels that vary over the surface. The base colour is multiplied by its alpha.\n"
        "struct TexturePlanes {\n    real4 base_color;\n";
    for (const GraphChannel& one : graph.channels)
        text += fmt::format("    {} {};\n", is_color(one.channel) ? "real3" : "real",
                            to_string(one.channel));
    return text + "};\n\n";
}

constexpr const char* color_of_planes =
    "real3 texture_color(real3 solid) {\n"
    "    return texture_planes(solid).base_color.rgb;\n"
    "}\n";

/// Writes a value program: a variable per step, with a comment that names the step's node.
class GraphWriter {
  public:
    /// Definitions that the steps need are added to `functions` and `maps`.
    GraphWriter(const TextureGraph& graph, GraphOutput output, GlslFunctions& functions,
                GlslMapTables& maps)
        : graph_(graph),
          values_(graph, nullptr, output),
          real_(functions.real()),
          steps_(values_.program(), functions, maps) {
        for (const ValueStep& step : values_.program().steps()) write(step);
    }

    /// The function texture_color.
    std::string color() const {
        return fmt::format("real3 texture_color(real3 solid) {{\n{}    return real3({});\n}}\n",
                           lines_, results(0, 3));
    }

    /// The struct TexturePlanes, texture_planes and texture_color; for GraphOutput::planes.
    std::string planes() const {
        const PlaneLayout layout(graph_);
        std::string all =
            fmt::format("real4({}, {})", results(0, 3),
                        layout.alpha() ? results(*layout.alpha(), 1) : glsl_number(1.0, real_));
        for (const GraphChannel& one : graph_.channels) {
            const std::size_t first = *layout.of(one.channel);
            all += is_color(one.channel) ? fmt::format(", real3({})", results(first, 3))
                                         : ", " + results(first, 1);
        }
        return planes_struct(graph_) + fmt::format(
                                           "TexturePlanes texture_planes(real3 solid) {{\n{}"
                                           "    return TexturePlanes({});\n}}\n\n{}",
                                           lines_, all, color_of_planes);
    }

  private:
    /// The expressions of `count` results from the first on, with commas between.
    std::string results(std::size_t first, std::size_t count) const {
        std::string text;
        for (std::size_t i = first; i < first + count; ++i)
            text += (i == first ? "" : ", ") + names_[values_.results()[i]];
        return text;
    }

    void write(const ValueStep& step) {
        std::vector<std::string> inputs;
        for (const Register r : step.inputs) inputs.push_back(glsl_operand(names_[r]));
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
    GlslReal real_;
    GlslSteps steps_;
    std::string lines_;
    /// The expressions of the registers at the current step.
    std::vector<std::string> names_{"solid.x", "solid.y", "solid.z"};
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

/// The reason why a graph that reads a mask, or one of another program's nodes, has no shader;
/// empty where it reads none.
std::string masks_problem(const TextureGraph& graph, GraphOutput output) {
    if (const std::string mask = first_mask_node(graph, output); !mask.empty())
        return no_texels_for(mask);
    const std::string node = first_host_node(graph, output);
    return node.empty() ? "" : fmt::format("its node \"{}\" is evaluated on the host alone", node);
}

void check(const std::string& why, const char* what = "texture") {
    if (!why.empty())
        throw Error(ExitCode::unsupported,
                    fmt::format("the {} cannot be written as GLSL: {}", what, why));
}

}  // namespace

std::string no_graph_shader(const TextureGraph& graph) {
    if (std::string why = masks_problem(graph, GraphOutput::color); !why.empty()) return why;
    return has_node(graph, "slope") ? too_many_stops(graph) : "";
}

std::string no_filtered_shader(const TextureGraph& graph, const Filter& filter) {
    if (std::string why = masks_problem(graph, GraphOutput::color); !why.empty()) return why;
    const bool tables = filter.kind == FilterKind::table_mip ||
                        filter.kind == FilterKind::table_sat ||
                        filter.kind == FilterKind::table_sat3;
    if (tables && has_node(graph, "color_map"))
        return "colour tables filter graphs on the host alone";
    return too_many_stops(graph);
}

GlslTexture glsl_graph(const TextureGraph& graph, GlslReal real) {
    check(no_graph_shader(graph));
    GlslFunctions functions(real);
    GlslMapTables maps(real);
    const std::string body = GraphWriter(graph, GraphOutput::color, functions, maps).color();
    return functions.texture(body, slope_parts(graph, maps));
}

std::string no_height_shader(const TextureGraph& height) {
    std::string why = height.empty() ? "" : masks_problem(height, GraphOutput::color);
    return why.empty() ? too_many_stops(height) : why;
}

bool has_glsl_planes(const TextureGraph& graph) {
    return !graph.channels.empty() || !is_opaque(graph, graph.result);
}

GlslTexture glsl_material(const TextureGraph& graph, const TextureGraph& height, GlslReal real) {
    check(no_graph_shader(graph));
    check(masks_problem(graph, GraphOutput::planes), "material");
    check(no_height_shader(height), "height of the bumps");
    GlslFunctions functions(real);
    GlslMapTables maps(real);
    if (!height.empty())
        functions.add(glsl_gradient_function(height, "bump_input", functions, maps));
    const bool planes = has_glsl_planes(graph);
    const GraphWriter writer(graph, planes ? GraphOutput::planes : GraphOutput::color, functions,
                             maps);
    const std::string body = planes ? writer.planes() : writer.color();
    const bool images = !graph.images.empty() || !height.images.empty();
    return functions.texture(body,
                             height.empty() ? slope_parts(graph, maps) : color_parts(images, maps));
}

GlslTexture glsl_filtered_graph(const TextureGraph& graph, const Filter& filter, GlslReal real) {
    check(no_filtered_shader(graph, filter));
    GlslFunctions functions(real);
    GlslMapTables maps(real);
    const std::string body =
        glsl_filtered_function(graph, "texture_color", filter, functions, maps);
    return functions.texture(body, color_parts(!graph.images.empty(), maps));
}

}  // namespace burl
