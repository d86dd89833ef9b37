#pragma once
// All measures of `burl metrics` that need no texture's values, for Burl's atlases and for any
// mesh's UVs.
#include <array>
#include <cstdint>
#include <span>

#include "atlas/measure/charts.h"
#include "atlas/solid/atlas.h"
#include "atlas/solid/solid_atlas.h"

namespace burl {

/// Figures of how well an atlas uses its texture (Carr & Hart 2001, section 3). A(u) is a
/// triangle's area in a texture of area 1, A(x) its area on the surface. A few nearly zero-area
/// faces can dominate the relative scale S, so area-weighted density percentiles stand beside it.
struct AtlasMetrics {
    double coverage = 0.0;  ///< coverage C = sum A(u_i), eq. (1)
    /// S = sqrt(sum_j A(x_j) * (1/M) sum_i A(u_i)/A(x_i)), eq. (2); triangles of zero area are left
    /// out.
    double relative_scale = 0.0;
    std::array<double, 3> density{};  ///< area-weighted 5, 50 and 95 % of A(u)/A(x) * sum A(x)
    double texel_coverage = 0.0;      ///< share of texels that lie in a span
    std::uint64_t triangles = 0, zero_area = 0, charts = 0;
    double area = 0.0;  ///< sum A(x), squared mesh units
};

/// Measures the atlas; `solid` is its rasterisation, in any space.
AtlasMetrics measure(const Mesh& mesh, const Atlas& atlas, const SolidAtlas& solid);

/// Measures of the triangles' shapes in the texture. Anisotropy is sigma1 / sigma2 of the affine
/// map from the surface to the texture (Sander, Snyder, Gortler, Hoppe, "Texture Mapping
/// Progressive Meshes", 2001, section 3).
struct ShapeMetrics {
    /// Smallest anisotropy that 50 % (95 %) of the surface's area does not exceed; 1 is isotropic.
    /// Infinite when more than the other 50 % (5 %) of the area vanishes in the texture.
    double anisotropy_50 = 0.0, anisotropy_95 = 0.0;
    /// Number of triangles with area on the surface, but in the texture lower than 1e-9 of their
    /// longest edge.
    std::uint64_t vanished = 0;
    /// Number of triangles whose orientation differs from most of their chart's texture area: the
    /// chart folds there. Triangles lower than 2^-24 of the texture's longer side do not count.
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

/// Numbers of texels that the surface can read, and of those that show more than one place of it.
struct TexelMetrics {
    std::uint64_t readable = 0;    ///< texels that a lookup at some surface point reads
    std::uint64_t covered = 0;     ///< texels whose centre lies in or on a triangle
    std::uint64_t overlapped = 0;  ///< texels whose centre lies inside more than one triangle
    std::uint64_t outside = 0;     ///< triangles that leave the texture by more than 1e-6 texel
};

/// Counts the texels. A bilinear lookup (nearest: a whole texel) reads a texel from less than one
/// (half a) texel away in x and in y. A centre is inside a triangle by more than 1e-6 texel in x
/// and y, so triangles that share an edge do not overlap. Triangles outside the texture are
/// counted, and clipped.
TexelMetrics measure_texels(const Atlas& atlas);

/// Use of the texture, charts, shapes of triangles and texels of one atlas.
struct AtlasMeasures {
    AtlasMetrics use;
    ChartMetrics charts;
    ShapeMetrics shape;
    TexelMetrics texels;
};

/// All measures of an atlas; `solid` is the atlas's own rasterisation, in any space.
AtlasMeasures measure_atlas(const Mesh& mesh, const Atlas& atlas, const SolidAtlas& solid,
                            std::span<const MeshEdge> edges);

}  // namespace burl
