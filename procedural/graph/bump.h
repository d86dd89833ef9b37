#pragma once
// Bump mapping: the height of any scalar node over the surface, visible in the shading only. The
// normal moves against the height's gradient along the surface (Blinn, "Simulation of Wrinkled
// Surfaces", 1978), which for a solid texture is the node's own gradient less its part along the
// normal (Perlin, "An Image Synthesizer", 1985): no differences, no parametrisation.
#include "procedural/graph/graph.h"
#include "procedural/numbers/dual.h"

namespace burl {

/// The bump map of a recipe: a plain comparable value.
struct Bump {
    TextureGraph input;  ///< graph whose result is a number; empty: no bumps
    /// The rise of the surface along its normal per unit of `input`, in units of the solid before
    /// the recipe's scale: the mesh's longest side for SolidSpace::unit, otherwise the file's unit.
    double height = 0.01;

    bool empty() const { return input.empty(); }
    bool operator==(const Bump&) const = default;
};

/// The gradient of height * node with respect to an object's points, given the linear part of the
/// map from those to the node's points s: gradients go back by the transposed map, whatever it
/// stretches or shears. `height` is a length in the object's units.
inline Vec3d height_gradient(const Dual& node, double height, const Mat3d& texture_from_object) {
    return height * (node.slope * texture_from_object);
}

/// The unit normal of the surface raised by a height with this gradient, to first order in the
/// height over the surface's radius of curvature: (n - (g - (g.n) n)) / |...|. The result is
/// exactly `normal` where the gradient has no part along the surface. `normal` has unit length or
/// is zero, which stays zero; both vectors are in the object's space.
inline Vec3d bumped_normal(const Vec3d& normal, const Vec3d& gradient) {
    if (normal == Vec3d(0.0)) return normal;
    const Vec3d along = gradient - glm::dot(gradient, normal) * normal;
    if (along == Vec3d(0.0)) return normal;
    return glm::normalize(normal - along);
}

}  // namespace burl
