#pragma once
// The translation of a graph's nodes into the operations of a value program, node by node: patterns
// become arithmetic, and affine maps of the point are multiplied out beforehand.
#include <string_view>

#include "procedural/graph/table.h"
#include "procedural/graph/value_program.h"

namespace burl {

/// The point at which nodes are evaluated: an affine image of three registers.
struct LoweredPlace {
    std::array<Register, 3> base{0, 1, 2};
    Affine3 map;
};

/// The result of a lowered node: its channels, or a place.
struct LoweredNode {
    std::vector<Register> channels;
    LoweredPlace place;
};

/// A node to be lowered, with its inputs, its place and the program that it is added to.
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
    /// The register of d . point + offset.
    Register along(const Vec3d& d, double offset = 0.0) const;
    /// The register of the point's coordinate i.
    Register axis(int i) const;
    std::vector<Register> point() const { return {axis(0), axis(1), axis(2)}; }

    // Sums and products of registers; an operation that a constant makes redundant is left out.
    Register add(Register a, Register b) const;
    Register multiply(Register a, Register b) const;
    /// The register of p a + q.
    Register linear(double p, Register a, double q = 0.0) const;
    /// The register of (1 - w) a + w b.
    Register lerp(Register w, Register a, Register b) const;

    /// A node whose result is a number.
    LoweredNode number(Register r) const { return {{r}, {}}; }
    /// A node whose result is input 0 where `weight` is 0 and input 1 where it is 1.
    LoweredNode blend(Register weight) const;
};

using Lowering = LoweredNode (*)(const LoweringCall&);

/// A node type's name and the function that lowers its nodes.
struct NamedLowering {
    std::string_view node;
    Lowering lower = nullptr;
};

/// The lowerings of the irregular textures (lowering_noise.cpp).
std::span<const NamedLowering> noise_lowerings();
/// The lowerings of numbers, patterns, colours and mappings (lowering_patterns.cpp).
std::span<const NamedLowering> pattern_lowerings();

}  // namespace burl
