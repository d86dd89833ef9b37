#pragma once
// Definitions of nodes: the instructions that they are written in, each of which adds a step to the
// graph's program and returns the register that the step fills, and the columns and families of the
// table of nodes (table.h).
#include <array>

#include "procedural/graph/program.h"
#include "procedural/graph/table.h"

namespace burl {

/// One node that is being added to a program: its parameters, inputs and point, and instructions.
class NodeOps : public NodeParameters {
  public:
    /// `number` is the node's in the graph; `channels` are those of the nodes before it.
    NodeOps(const TextureGraph& graph, std::size_t number,
            std::span<const std::vector<Register>> channels, GraphProgram& program);

    const Texture& texture() const { return graph_.textures[self().texture]; }
    const GraphImage& image() const { return graph_.images[self().image]; }
    /// The number of channels of the node's result.
    std::size_t channels() const { return std::size_t(self().wire); }

    /// Channel c of input k; a number counts as an opaque grey where a colour is wanted.
    Register input(std::size_t k, std::size_t c = 0);
    /// The numbers of the inputs from `first` on: one of a number, three of a colour.
    std::vector<Register> numbers(std::size_t first = 0);
    /// The coordinates of the point that the node is evaluated at.
    const std::vector<Register>& point() const { return channels_[self().place]; }
    Register axis(std::size_t i) const { return point()[i]; }
    /// Component c of the mask that the node reads, at the texel.
    Register mask(std::size_t c = 0);
    /// The affine combination d . point + offset.
    Register along(const Vec3d& d, double offset = 0.0);
    /// The coordinates of map(point).
    std::vector<Register> moved(const Affine3& map);

    /// Adds a step with `count` results.
    std::vector<Register> add(GraphWork work, std::vector<Register> inputs, std::size_t count = 1);
    /// Adds a step with one result.
    Register apply(GraphWork work, std::vector<Register> inputs);
    Register apply(ValueOp op, std::vector<Register> inputs, const std::array<double, 4>& p = {});

    Register constant(double value) { return apply(ValueOp::constant, {}, {value}); }
    /// The number p a + q.
    Register linear(double p, Register a, double q = 0.0) {
        return apply(ValueOp::linear, {a}, {p, q});
    }
    /// The number p a + q b.
    Register combine(double p, Register a, double q, Register b) {
        return apply(ValueOp::combine, {a, b}, {p, q});
    }
    Register multiply(Register a, Register b) { return apply(ValueOp::multiply, {a, b}); }
    /// The blend (1 - w) a + w b.
    Register lerp(Register w, Register a, Register b) { return apply(ValueOp::lerp, {w, a, b}); }
    /// The ratio a / b, and 0 where b is not above 0.
    Register ratio(Register a, Register b) { return apply(ValueOp::ratio, {a, b}); }
    Register minimum(Register a, Register b) { return apply(ValueOp::minimum, {a, b}); }
    Register maximum(Register a, Register b) { return apply(ValueOp::maximum, {a, b}); }
    /// The number a, at least `low` and at most `high`; `high` where low > high. Its gradient is 0
    /// from either bound on.
    Register clamped(Register a, double low = 0.0, double high = 1.0);
    /// The share (a - low) / (high - low) of the way from low to high; 0 below low and 1 from it on
    /// where low = high.
    Register share(Register a, double low, double high);
    Register sine(Register a) { return apply(ValueOp::sine, {a}); }
    Register length(Register a, Register b) { return apply(ValueOp::length, {a, b}); }
    /// The angle of the point (x, y), in radians, in [-pi, pi].
    Register angle(Register y, Register x) { return apply(ValueOp::angle, {y, x}); }
    Register octaves(const OctaveSum& sum) { return apply(sum, point()); }

    /// The channels of the blend of inputs 0 and 1 by `weight`.
    std::vector<Register> blend(Register weight);
    /// Adds a step that gives red, green and blue, and returns these and an alpha of 1.
    std::vector<Register> opaque(GraphWork colors, std::vector<Register> inputs);
    /// Adds a step that gives red, green and blue, and one whose first result is alpha.
    std::vector<Register> with_alpha(GraphWork colors, GraphWork alpha,
                                     const std::vector<Register>& inputs);

  private:
    const TextureGraph& graph_;
    std::uint32_t number_;
    std::span<const std::vector<Register>> channels_;
    GraphProgram& program_;
};

}  // namespace burl

namespace burl::nodes {

using Outputs = std::vector<Register>;
using Inputs = std::array<NodeInput, 7>;
using Parameters = std::array<Parameter, 10>;

/// The parameter of a number.
constexpr Parameter real(std::string_view key, double low, double high, std::string_view otherwise,
                         std::string_view tip) {
    return {key, ParameterType::number, low, high, 0.05, 1, "", otherwise, "", tip};
}
/// The parameter of a whole number.
constexpr Parameter whole(std::string_view key, double low, double high, std::string_view otherwise,
                          std::string_view tip) {
    return {key, ParameterType::integer, low, high, 1, 1, "", otherwise, "", tip};
}
/// The parameter of `count` numbers.
constexpr Parameter several(std::string_view key, std::size_t count, std::string_view otherwise,
                            std::string_view tip) {
    return {key, ParameterType::numbers, -1e6, 1e6, 0.1, count, "", otherwise, "", tip};
}
/// The parameter of a choice.
constexpr Parameter one_of(std::string_view key, std::string_view otherwise,
                           std::string_view choices, std::string_view tip) {
    return {key, ParameterType::choice, 0, 0, 0, 1, "", otherwise, choices, tip};
}

/// The input of a number.
constexpr NodeInput a_number(std::string_view key, std::string_view tip,
                             std::string_view otherwise = {}) {
    return {key, Wire::number, false, otherwise, tip};
}
/// The input of a colour, of which a number is an opaque grey.
constexpr NodeInput a_color(std::string_view key, std::string_view tip,
                            std::string_view otherwise = {}) {
    return {key, Wire::color, false, otherwise, tip};
}
/// The input of a number or colour that sets what the node gives.
constexpr NodeInput any(std::string_view key, std::string_view tip,
                        std::string_view otherwise = {}) {
    return {key, Wire::color, true, otherwise, tip};
}

inline constexpr Inputs one_number{a_number("input", "a number")};
inline constexpr Inputs two_sides{any("a", "where the pattern is 0", "0"),
                                  any("b", "where the pattern is 1", "1")};
inline constexpr Inputs moved_input{any("input", "what is evaluated at the point made here")};

inline constexpr std::string_view slides = "Chuang 2008", pbrt = "pbrt (Chuang 2008)", own = "-";

/// A row of the table.
constexpr NodeType a_node(std::string_view name, NodeResult result, Outputs (*define)(NodeOps&),
                          std::string_view text, std::string_view source, const Inputs& inputs = {},
                          const Parameters& parameters = {}) {
    return {name, result, define, text, source, inputs, parameters};
}

// The families of nodes in the table's order, each defined in its file of procedural/nodes.
std::span<const NodeType> numbers();
std::span<const NodeType> colors();
std::span<const NodeType> channels();
std::span<const NodeType> patterns();
std::span<const NodeType> tiles();
std::span<const NodeType> noises();
std::span<const NodeType> blender_nodes();
std::span<const NodeType> materialx_nodes();
std::span<const NodeType> masks();
std::span<const NodeType> points();

}  // namespace burl::nodes
