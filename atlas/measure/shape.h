#pragma once
// The shape that the map gives each triangle: anisotropy sigma1 / sigma2 of the affine map from the
// surface to the texture (Sander, Snyder, Gortler, Hoppe, "Texture Mapping Progressive Meshes",
// 2001, section 3), triangles that vanish in the texture, and triangles turned over.
#include <cstdint>
#include <span>

#include "atlas/solid/atlas.h"

namespace burl {

/// Measures of the triangles' shapes in the texture.
struct ShapeMetrics {
    /// Smallest anisotropy that 50 % (95 %) of the surface's area does not exceed; 1 is isotropic.
    /// Infinite when more than the other 50 % (5 %) of the area vanishes in the texture.
    double anisotropy_50 = 0.0, anisotropy_95 = 0.0;
    /// Number of triangles with area on the surface, but in the texture lower than 1e-9 of their
    /// longest edge.
    std::uint64_t vanished = 0;
    /// Number of triangles whose orientation differs from most of their chart's texture area: the
    /// chart folds there.
    std::uint64_t flipped = 0;
    /// Share of the surface's area that is mirrored: its texture reads reversed from outside.
    double mirrored = 0.0;
};

/// Measures the shapes; `charts` holds each triangle's chart, a number below `chart_count`.
ShapeMetrics measure_shape(const Mesh& mesh, const Atlas& atlas,
                           std::span<const std::uint32_t> charts, std::uint32_t chart_count);

/// Anisotropy sigma1 / sigma2 >= 1 of the map that takes the triangle `points` to `corners`;
/// infinite where the triangle in the texture has no area, and for a triangle of points without
/// area.
double anisotropy(const std::array<Vec3d, 3>& points, const std::array<Vec2d, 3>& corners);

}  // namespace burl
