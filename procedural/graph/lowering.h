#pragma once
// From a graph's nodes to the operations of a value program, node by node: patterns become
// arithmetic, affine maps of the point are multiplied out before anything is computed.
#include <string_view>

#include "procedural/graph/table.h"
#include "procedural/graph/value_program.h"

namespace burl {

/// The point nodes are evaluated at: an affine image of three registers.
struct LoweredPlace {
    std::array<Register, 3> base{0, 1, 2};
    Affine3 map;
};

/// What a node became: its channels, or a place.
struct LoweredNode {
    std::vector<Register> channels;
    LoweredPlace place;
};

/// One node to be lowered, and what it may use.
struct LoweringCall {
    const TextureGraph* graph = nullptr;
    const GraphNode* node = nullptr;
    std::array<const LoweredNode*, 4> inputs{};
    LoweredPlace place;
    ValueProgram* program = nullptr;

    double parameter(std::string_view key, std::size_t component = 0) const;
    Vec3d vector(std::string_view key) const;
    bool is_color() const { return node->wire == Wire::color; }

    /// Channel c of input k; a number where a colour is wanted is an opaque grey.
    Register input(std::size_t k, std::size_t c = 0) const;
    /// d . point + offset.
    Register along(const Vec3d& d, double offset = 0.0) const;
    /// The point's coordinate.
    Register axis(int i) const;
    std::vector<Register> point() const { return {axis(0), axis(1), axis(2)}; }

    // Sums and products, left out where a constant makes them idle.
    Register add(Register a, Register b) const;
    Register multiply(Register a, Register b) const;
    /// p a + q.
    Register linear(double p, Register a, double q = 0.0) const;
    Register lerp(Register w, Register a, Register b) const;

    /// What the node gives: a number, or input 0 where weight is 0 and input 1 where it is 1.
    LoweredNode number(Register r) const { return {{r}, {}}; }
    LoweredNode blend(Register weight) const;
};

using Lowering = LoweredNode (*)(const LoweringCall&);

/// Lowers a node of that type; null for constants and nodes that only others know.
struct NamedLowering {
    std::string_view node;
    Lowering lower = nullptr;
};

/// graph_lowering_noise.cpp: the irregular textures.
std::span<const NamedLowering> noise_lowerings();
/// graph_lowering_patterns.cpp: numbers, patterns, colours and mappings.
std::span<const NamedLowering> pattern_lowerings();

}  // namespace burl
