#pragma once
// The atlas measures of Carr & Hart 2001, section 3, and counts and percentiles to read the
// relative scale S with: a few nearly zero-area faces can dominate S, so area-weighted density
// percentiles stand beside it.
#include <array>
#include <cstdint>

#include "atlas/solid/atlas.h"
#include "atlas/solid/solid_atlas.h"

namespace burl {

/// Figures of how well an atlas uses its texture. A(u) is a triangle's area in a texture of area 1,
/// A(x) its area on the surface.
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

}  // namespace burl
