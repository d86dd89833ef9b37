#pragma once
// The instructions that a node's definition is written in: each adds a step to the graph's program
// and returns the register that the step fills.
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
    /// The coordinates of the point that the node is evaluated at.
    const std::vector<Register>& point() const { return channels_[self().place]; }
    Register axis(std::size_t i) const { return point()[i]; }
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
    Register sine(Register a) { return apply(ValueOp::sine, {a}); }
    Register length(Register a, Register b) { return apply(ValueOp::length, {a, b}); }
    /// The angle of the point (x, y), in radians, in [-pi, pi].
    Register angle(Register y, Register x) { return apply(ValueOp::angle, {y, x}); }
    Register octaves(const OctaveSum& sum) { return apply(sum, point()); }

    /// The channels of the blend of inputs 0 and 1 by `weight`.
    std::vector<Register> blend(Register weight);
    /// Adds a step that gives red, green and blue, and returns these and an alpha of 1.
    std::vector<Register> opaque(GraphWork colors, std::vector<Register> inputs);

  private:
    const TextureGraph& graph_;
    std::uint32_t number_;
    std::span<const std::vector<Register>> channels_;
    GraphProgram& program_;
};

}  // namespace burl
