#pragma once
// Bumps: the height of any scalar node over the surface, seen in the shading only. The normal moves
// against the height's gradient along the surface (Blinn, "Simulation of Wrinkled Surfaces", 1978),
// which for a solid texture is the node's own gradient less its part along the normal (Perlin, "An
// Image Synthesizer", 1985): no differences, no parametrisation.
#include "procedural/graph/graph.h"
#include "procedural/numbers/dual.h"

namespace burl {

/// Part of a recipe, a plain comparable value.
struct Bump {
    TextureGraph input;  ///< its result is a number; empty: no bumps
    /// How far the surface rises per unit of `input`, along its normal, in units of the solid
    /// before the recipe's scale: of the mesh's longest side for SolidSpace::unit, else of the
    /// file.
    double height = 0.01;

    bool empty() const { return input.empty(); }
    bool operator==(const Bump&) const = default;
};

/// Gradient of height * node with respect to an object's points, where s = texture_from_object
/// takes those to the node's: gradients go back by the transposed map, whatever it stretches or
/// shears. `height` is a length in the object's units.
inline Vec3d height_gradient(const Dual& node, double height, const Mat3d& texture_from_object) {
    return height * (node.slope * texture_from_object);
}

/// The unit normal of the surface raised by a height with this gradient, to first order in the
/// height over the surface's radius of curvature: (n - (g - (g.n) n)) / |...|. Exactly `normal`
/// where the gradient has no part along the surface. `normal` has unit length, or is zero and stays
/// so; both are in the object's space.
inline Vec3d bumped_normal(const Vec3d& normal, const Vec3d& gradient) {
    if (normal == Vec3d(0.0)) return normal;
    const Vec3d along = gradient - glm::dot(gradient, normal) * normal;
    if (along == Vec3d(0.0)) return normal;
    return glm::normalize(normal - along);
}

}  // namespace burl
