#include "procedural/glsl/duals.h"

#include <fmt/format.h>

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

std::string GlslDuals::variable(const std::string& type, const std::string& expression) {
    std::string name = new_name("d");
    line(fmt::format("{} {} = {};", type, name, expression));
    return name;
}

std::string GlslDuals::along(const std::string& x, char step) const {
    return filtering_ ? fmt::format("dot_of({}.yzw, step_{})", x, step) : number(0.0);
}

std::string GlslDuals::box_width(const std::string& x) const {
    if (!filtering_) return number(0.0);
    return fmt::format("length_of({}, {})", along(x, 'u'), along(x, 'v'));
}

/// The name of a float variable with the number of octaves that the footprint shows.
std::string GlslDuals::visible(std::size_t octaves, double lacunarity,
                               const std::array<std::string, 3>& point) {
    return variable(
        "float",
        fmt::format("float(visible_octaves({}, {}, {}, step_u, step_v, {}, {}))", point[0],
                    point[1], point[2], number(std::log2(lacunarity)), number(double(octaves))));
}

std::string GlslDuals::octaves(const NoiseSum& sum, const std::array<std::string, 3>& point,
                               const std::optional<GlslFade>& fade) {
    const std::string kept =
        filtering_ && fade ? visible(sum.octaves.size(), fade->lacunarity, point) : "";
    const GlslSum written = sums_.slopes(sum, {point[0] + ".x", point[1] + ".x", point[2] + ".x"},
                                         kept, fade ? fade->mean : 0.0, new_name("n"));
    lines_ += written.lines;
    return dual(
        fmt::format("dual_at({}, {}, {}, {})", written.result, point[0], point[1], point[2]));
}

std::string GlslDuals::lattice_octaves(const NoiseSum& sum, const std::string& point) {
    const GlslSum written =
        sums_.slopes(sum, {point + ".x", point + ".y", point + ".z"}, "", 0.0, new_name("n"));
    lines_ += written.lines;
    return written.result;
}

double GlslNodeCall::parameter(std::string_view key, std::size_t component) const {
    NodeCall call;
    call.node = node;
    return call.parameter(key, component);
}

Vec3d GlslNodeCall::vector(std::string_view key) const {
    return {parameter(key, 0), parameter(key, 1), parameter(key, 2)};
}

std::string GlslNodeCall::input(std::size_t k, std::size_t c) const {
    const std::vector<std::string>& channels = inputs[k]->channels;
    if (c < channels.size()) return channels[c];
    return c < 3 ? channels[0] : text->constant(1.0);
}

std::string GlslNodeCall::along(const Vec3d& d, double offset) const {
    std::vector<double> factors;
    std::vector<std::string> terms;
    for (int i = 0; i < 3; ++i) {
        if (d[i] == 0.0) continue;
        factors.push_back(d[i]);
        terms.push_back(axis(std::size_t(i)));
    }
    if (terms.empty()) return text->constant(offset);
    std::string sum = glsl_sum(factors, terms, 0.0, text->functions().real());
    if (offset != 0.0) sum += " + " + text->constant(offset);
    return sum;
}

GlslNode GlslNodeCall::blend(const std::string& weight) const {
    const std::string w = text->dual(weight);
    return channels([&](std::size_t c) {
        return fmt::format("dual_lerp({}, {}, {})", w, input(0, c), input(1, c));
    });
}

namespace {

GlslNode written(const GlslNodeCall& call) {
    const std::string_view name = type_of(*call.node).name;
    for (const auto& table :
         {glsl_math_nodes(), glsl_pattern_nodes(), glsl_noise_nodes(), glsl_color_nodes()})
        for (const NamedGlslNode& known : table)
            if (known.node == name) return known.write(call);
    return {{call.text->constant(0.0)}};
}

/// A flag per node: whether the last node needs it.
std::vector<bool> needed_nodes(const TextureGraph& graph) {
    std::vector<bool> needed(graph.nodes.size(), false);
    needed.back() = true;
    for (std::size_t n = graph.nodes.size(); n-- > 1;) {
        if (!needed[n]) continue;
        needed[graph.nodes[n].place] = true;
        for (const std::uint32_t input : graph.nodes[n].inputs) needed[input] = true;
    }
    return needed;
}

/// Writes the nodes, one after the other, and returns the last one's channels.
GlslNode write_nodes(const TextureGraph& graph, GlslDuals& text) {
    const auto solid = [&](const char* axis, const std::array<double, 3>& slope) {
        return text.dual(fmt::format("real4(solid.{}, {}, {}, {})", axis, text.number(slope[0]),
                                     text.number(slope[1]), text.number(slope[2])));
    };
    std::vector<GlslNode> nodes;
    nodes.reserve(graph.nodes.size());
    nodes.push_back({{solid("x", {1, 0, 0}), solid("y", {0, 1, 0}), solid("z", {0, 0, 1})}});
    const std::vector<bool> needed = needed_nodes(graph);
    for (std::size_t n = 1; n < graph.nodes.size(); ++n) {
        const GraphNode& node = graph.nodes[n];
        if (!needed[n]) {
            nodes.emplace_back();
            continue;
        }
        GlslNodeCall call;
        call.graph = &graph;
        call.node = &node;
        for (std::size_t k = 0; k < node.inputs.size(); ++k)
            call.inputs[k] = &nodes[node.inputs[k]];
        call.place = &nodes[node.place];
        call.text = &text;
        text.line(fmt::format("// {} (node {})", type_of(node).name, n));
        nodes.push_back(written(call));
    }
    return nodes.back();
}

}  // namespace

std::string glsl_gradient_function(const TextureGraph& graph, const std::string& name,
                                   GlslFunctions& functions) {
    GlslDuals text(functions, nullptr);
    const GlslNode result = write_nodes(graph, text);
    return fmt::format("real4 {}(real3 solid) {{\n{}    return {};\n}}\n\n", name, text.lines(),
                       result.channels[0]);
}

std::string glsl_filtered_function(const TextureGraph& graph, const std::string& name,
                                   GlslFunctions& functions, GlslFiltering& filtering) {
    GlslDuals text(functions, &filtering);
    GlslNode result = write_nodes(graph, text);
    if (result.channels.size() == 1) result.channels.resize(3, result.channels.front());
    return fmt::format(
        "real3 {}(real3 solid, real3 step_u, real3 step_v) {{\n{}"
        "    return real3({}.x, {}.x, {}.x);\n}}\n\n",
        name, text.lines(), result.channels[0], result.channels[1], result.channels[2]);
}

}  // namespace burl
