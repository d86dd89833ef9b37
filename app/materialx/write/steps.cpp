#include "app/materialx/write/steps.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "app/materialx/write/calls.h"
#include "procedural/graph/table.h"
#include "procedural/graph/values.h"

namespace burl::materialx {

namespace {

/// Whether MaterialX has nodes for a step's work, whose masks are `masks`.
struct HasEquivalent {
    const std::vector<GraphMask>& masks;

    bool operator()(const ValueOperation&) const { return true; }
    /// Only pbrt's marble, which has noise, has curves.
    bool operator()(const ColorPieces& pieces) const { return pieces.degree == 1; }
    bool operator()(const ImageLookup&) const { return true; }
    bool operator()(const PointFunction& function) const {
        return std::holds_alternative<MaterialXCall>(function);
    }
    bool operator()(const NoiseSum& sum) const { return sum.octaves.empty(); }
    bool operator()(const MaskRead& read) const {
        const MaskKind kind = masks[read.mask].kind;
        return kind == MaskKind::mesh_uv || kind == MaskKind::facing ||
               kind == MaskKind::vertex_color;
    }
    template <class Work>
    bool operator()(const Work&) const {
        return false;
    }
};

/// A channel of a straight piece at a distance from its begin.
double value_of(const ColorPieces& pieces, std::size_t piece, std::size_t channel, double x) {
    const double* c = &pieces.table[piece * pieces.stride() + 1 + 2 * channel];
    return c[0] + c[1] * x;
}

std::string color_text(const ColorPieces& pieces, std::size_t piece, double x) {
    return fmt::format("{}, {}, {}", value_text(value_of(pieces, piece, 0, x)),
                       value_text(value_of(pieces, piece, 1, x)),
                       value_text(value_of(pieces, piece, 2, x)));
}

/// Writes a map of colours at a number: pieces from the left, each over what is left of it.
class PiecesWriter {
  public:
    PiecesWriter(const ColorPieces& pieces, const Operand& x, XmlNodes& nodes)
        : pieces_(pieces), nodes_(nodes) {
        if (pieces.argument == ColorPieces::Argument::repeat)
            x_ = nodes.binary("modulo", x, {1.0});
        else
            x_ = nodes.number("clamp", {{"in", x}, {"low", {0.0}}, {"high", {1.0}}});
    }

    /// The name of a node of type color3.
    std::string color() {
        std::string sum = own(0);
        for (std::size_t i = 1; i < pieces_.begins.size(); ++i) {
            const bool last = i + 1 == pieces_.begins.size();
            if (has_width(i) && continues(i))
                sum = line(i, node_input("bg", "color3", sum));
            else if (has_width(i) || last)
                sum = nodes_.add(
                    "ifgreatereq", "color3",
                    {nodes_.input("value1", x_), number_input("value2", begin(i)),
                     node_input("in1", "color3", own(i)), node_input("in2", "color3", sum)});
        }
        return sum;
    }

  private:
    double begin(std::size_t i) const { return i == 0 ? 0.0 : pieces_.begins[i]; }
    double end(std::size_t i) const {
        return i + 1 < pieces_.begins.size() ? pieces_.begins[i + 1] : 1.0;
    }
    bool has_width(std::size_t i) const { return end(i) > begin(i); }

    /// An input with the colour of a piece at a place.
    XmlElement color_at(const std::string& name, std::size_t i, double x) const {
        return value_input(name, "color3", color_text(pieces_, i, x - pieces_.begins[i]));
    }

    /// Whether a piece begins with the colour that the one before ends with.
    bool continues(std::size_t i) const {
        for (std::size_t c = 0; c < 3; ++c) {
            const double before = value_of(pieces_, i - 1, c, begin(i) - pieces_.begins[i - 1]);
            if (std::abs(before - value_of(pieces_, i, c, 0.0)) > 1e-9) return false;
        }
        return true;
    }

    /// The colours of a piece alone.
    std::string own(std::size_t i) {
        if (has_width(i)) return line(i, color_at("bg", i, begin(i)));
        return nodes_.add("constant", "color3", {color_at("value", i, begin(i))});
    }

    /// From the colour below a piece to that at its end.
    std::string line(std::size_t i, XmlElement below) {
        const Operand share =
            nodes_.number("remap", {{"in", x_}, {"inlow", {begin(i)}}, {"inhigh", {end(i)}}});
        const Operand clamped =
            nodes_.number("clamp", {{"in", share}, {"low", {0.0}}, {"high", {1.0}}});
        return nodes_.add(
            "mix", "color3",
            {color_at("fg", i, end(i)), std::move(below), nodes_.input("mix", clamped)});
    }

    const ColorPieces& pieces_;
    XmlNodes& nodes_;
    Operand x_;
};

using Operands = std::vector<Operand>;

/// The factor of `whole` copies, by squares.
Operand whole_power(const Operand& x, std::uint32_t whole, XmlNodes& nodes) {
    if (whole == 0) return {1.0};
    if (whole == 1) return x;
    const Operand half = whole_power(x, whole / 2, nodes);
    const Operand square = nodes.binary("multiply", half, half);
    return whole % 2 == 0 ? square : nodes.binary("multiply", square, x);
}

Operand power(const Operand& x, double exponent, XmlNodes& nodes) {
    if (exponent == std::floor(exponent)) return whole_power(x, std::uint32_t(exponent), nodes);
    return nodes.binary("power", nodes.binary("max", x, {0.0}), {exponent});
}

/// The ratio a / b, and 0 where b is not above 0.
Operand ratio(const Operand& a, const Operand& b, XmlNodes& nodes) {
    const Operand quotient = nodes.binary("divide", a, b);
    if (b.is_constant()) return b.constant > 0.0 ? quotient : Operand{};
    return nodes.choose("ifgreater", b, {0.0}, quotient, {0.0});
}

Operand smooth_step(const Operand& x, double low, double high, XmlNodes& nodes) {
    if (!(high > low)) return nodes.choose("ifgreatereq", x, {high}, {1.0}, {0.0});
    return nodes.number("smoothstep", {{"in", x}, {"low", {low}}, {"high", {high}}});
}

Operand write_operation(const ValueOperation& operation, const Operands& in, XmlNodes& nodes) {
    const auto [p, q, r, s] = operation.parameters;
    switch (operation.op) {
        case ValueOp::constant:
            return {p};
        case ValueOp::affine:
            return nodes.sum(in, {p, q, r}, s);
        case ValueOp::linear:
            return nodes.sum(in, {p}, q);
        case ValueOp::combine:
            return nodes.sum(in, {p, q}, r);
        case ValueOp::add:
            return nodes.binary("add", in[0], in[1]);
        case ValueOp::multiply:
            return nodes.binary("multiply", in[0], in[1]);
        case ValueOp::products:
            return nodes.binary("add", nodes.binary("multiply", in[0], in[1]),
                                nodes.binary("multiply", in[2], in[3]));
        case ValueOp::ratio:
            return ratio(in[0], in[1], nodes);
        case ValueOp::minimum:
            return nodes.binary("min", in[0], in[1]);
        case ValueOp::maximum:
            return nodes.binary("max", in[0], in[1]);
        case ValueOp::absolute:
            return nodes.unary("absval", in[0]);
        case ValueOp::floor:
            return nodes.unary("floor", in[0]);
        case ValueOp::fract:
            return nodes.binary("modulo", in[0], {1.0});
        case ValueOp::odd:
            return nodes.binary("modulo", nodes.unary("floor", in[0]), {2.0});
        case ValueOp::at_least:
            return nodes.choose("ifgreatereq", in[0], {p}, {1.0}, {0.0});
        case ValueOp::smoothstep:
            return smooth_step(in[0], p, q, nodes);
        case ValueOp::lerp:
            return nodes.number("mix", {{"fg", in[2]}, {"bg", in[1]}, {"mix", in[0]}});
        case ValueOp::length:
            return {0.0, nodes.add("magnitude", "float",
                                   {node_input("in", "vector2", nodes.combined("vector2", in))})};
        case ValueOp::power:
            return power(in[0], p, nodes);
        case ValueOp::sine:
            return nodes.unary("sin", in[0]);
        case ValueOp::angle:
            return nodes.binary("atan2", in[0], in[1]);
    }
    return {};
}

/// Writes the work of steps.
class StepWriter {
  public:
    StepWriter(const TextureGraph& graph, XmlNodes& nodes)
        : graph_(graph), masks_(graph_masks(graph)), nodes_(nodes) {}

    Operands write(const ValueWork& work, const Operands& inputs) {
        return std::visit([&](const auto& known) { return step(known, inputs); }, work);
    }

  private:
    Operands step(const ValueOperation& operation, const Operands& in) {
        return {write_operation(operation, in, nodes_)};
    }

    Operands step(const ColorPieces& pieces, const Operands& in) {
        return components_of(PiecesWriter(pieces, in[0], nodes_).color(), "color3");
    }

    Operands step(const NoiseSum& sum, const Operands&) { return {{sum.offset}}; }

    Operands step(const ImageLookup& lookup, const Operands& in) {
        for (const GraphImage& known : graph_.images) {
            if (known.pixels == lookup.pixels) return image(known, lookup.wrap, in, false);
            if (known.pixels->alpha() == lookup.pixels.get())
                return image(known, lookup.wrap, in, true);
        }
        return Operands(3);
    }

    /// Colours times their alpha, or the alpha three times. MaterialX's second coordinate points
    /// up.
    Operands image(const GraphImage& known, ImageWrap wrap, const Operands& in, bool alpha) {
        const bool has_alpha = known.pixels->alpha() != nullptr;
        const char* type = has_alpha ? "color4" : "color3";
        const char* mode = wrap == ImageWrap::repeat  ? "periodic"
                           : wrap == ImageWrap::clamp ? "clamp"
                                                      : "constant";
        const Operand v = nodes_.binary("subtract", {1.0}, in[1]);
        XmlElement file = value_input("file", "filename", known.file);
        file.attributes.emplace_back("colorspace", "srgb_texture");
        std::string node =
            nodes_.add("image", type,
                       {std::move(file),
                        node_input("texcoord", "vector2", nodes_.combined("vector2", {in[0], v})),
                        value_input("uaddressmode", "string", mode),
                        value_input("vaddressmode", "string", mode)});
        if (alpha) return Operands(3, components_of(node, type)[3]);
        if (has_alpha) node = nodes_.add("premult", type, {node_input("in", type, node)});
        Operands colors = components_of(node, type);
        colors.resize(3);
        return colors;
    }

    Operands step(const MaskRead& read, const Operands&) {
        const GraphMask& mask = masks_[read.mask];
        if (mask.kind == MaskKind::facing) return {facing(mask)};
        const bool uv = mask.kind == MaskKind::mesh_uv;
        const std::string type = uv ? "vector2" : "color4";
        const std::string node = nodes_.add(uv ? "texcoord" : "geomcolor", type, {});
        const Operand part = components_of(node, type)[mask.component];
        if (uv && mask.component == 1) return {nodes_.binary("subtract", {1.0}, part)};
        return {part};
    }

    Operands step(const PointFunction& function, const Operands& in) {
        const auto* call = std::get_if<MaterialXCall>(&function);
        return call ? write_call(*call, in, nodes_) : Operands(3);
    }

    Operand facing(const GraphMask& mask) {
        const double length = std::hypot(mask.numbers[0], mask.numbers[1], mask.numbers[2]);
        const std::string normal =
            nodes_.add("normal", "vector3", {value_input("space", "string", "object")});
        std::vector<double> direction(mask.numbers.begin(), mask.numbers.begin() + 3);
        for (double& d : direction) d = length > 0.0 ? d / length : 0.0;
        return nodes_.sum(components_of(normal, "vector3"), direction, 0.0);
    }

    /// Not asked for: nodes_without_equivalent() names these.
    template <class Work>
    Operands step(const Work&, const Operands&) {
        return Operands(3);
    }

    const TextureGraph& graph_;
    std::vector<GraphMask> masks_;
    XmlNodes& nodes_;
};

}  // namespace

std::vector<std::uint32_t> nodes_without_equivalent(const TextureGraph& graph, GraphOutput output) {
    const GraphValues values(graph, nullptr, output);
    const std::vector<GraphMask> masks = graph_masks(graph);
    std::set<std::uint32_t> found;
    for (const ValueStep& step : values.program().steps())
        if (!std::visit(HasEquivalent{masks}, step.work)) found.insert(step.node);
    return {found.begin(), found.end()};
}

std::vector<Operand> write_graph(const TextureGraph& graph, GraphOutput output,
                                 const std::vector<Operand>& point, XmlNodes& nodes) {
    const GraphValues values(graph, nullptr, output);
    StepWriter writer(graph, nodes);
    std::vector<Operand> registers = point;
    std::uint32_t last = 0;
    for (const ValueStep& step : values.program().steps()) {
        Operands inputs;
        for (const Register r : step.inputs) inputs.push_back(registers[r]);
        if (step.node != last)
            nodes.set_comment(
                fmt::format("{} (node {})", type_of(graph.nodes[step.node]).name, step.node));
        last = step.node;
        const Operands results = writer.write(step.work, inputs);
        for (std::size_t i = 0; i < step.outputs.size(); ++i) {
            const Register r = step.outputs[i];
            registers.resize(std::max<std::size_t>(registers.size(), r + 1));
            registers[r] = results[i];
        }
    }
    Operands results;
    for (const Register r : values.results()) results.push_back(registers[r]);
    return results;
}

}  // namespace burl::materialx
