#pragma once
// The atlas measures of Carr & Hart 2001, section 3, and the honest companions of the relative
// scale: a few nearly zero-area faces can dominate S, so area-weighted density percentiles and
// counts stand beside it.
#include <array>
#include <cstdint>

#include "atlas/solid/atlas.h"
#include "atlas/solid/solid_atlas.h"

namespace burl {

struct AtlasMetrics {
    double coverage = 0.0;  ///< C = sum A(u_i), eq. (1); texture area = 1
    double relative_scale =
        0.0;  ///< S = sqrt(sum_j A(x_j) * (1/M) sum_i A(u_i)/A(x_i)), eq. (2), zero areas skipped
    std::array<double, 3> density{};  ///< area-weighted 5/50/95 % of A(u)/A(x) * sum A
    double texel_coverage = 0.0;      ///< share of texels that lie in a span
    std::uint64_t triangles = 0, zero_area = 0, charts = 0;
    double area = 0.0;  ///< sum A(x), squared mesh units
};

AtlasMetrics measure(const Mesh& mesh, const Atlas& atlas, const SolidAtlas& solid);

}  // namespace burl
