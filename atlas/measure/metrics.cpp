// Coverage and relative scale (Carr & Hart 2001, sections 3.3 and 3.4), and the measures that go
// with them.
#include "atlas/measure/metrics.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "atlas/base/weighted_percentile.h"
#include "atlas/solid/weights.h"

namespace burl {

namespace {

double texture_area(const std::array<Vec2d, 3>& corners, double size) {
    const Vec2d u = (corners[1] - corners[0]) / size, v = (corners[2] - corners[0]) / size;
    return 0.5 * std::abs(u.x * v.y - u.y * v.x);
}

double owned_share(const SolidAtlas& solid) {
    double texels = 0.0;
    for (const Span& span : solid.spans) texels += span.count;
    return texels / (double(solid.size) * double(solid.size));
}

}  // namespace

AtlasMetrics measure(const Mesh& mesh, const Atlas& atlas, const SolidAtlas& solid) {
    AtlasMetrics metrics;
    metrics.triangles = mesh.triangles.size();
    metrics.charts = atlas.chart_count;
    metrics.texel_coverage = owned_share(solid);
    const auto [areas, unit] = triangle_areas(mesh);
    std::vector<WeightedValue> densities;
    double ratios = 0.0, total = 0.0;
    for (std::size_t t = 0; t < areas.size(); ++t) {
        const double in_texture = texture_area(atlas.corners[t], atlas.options.size);
        metrics.coverage += in_texture;
        if (areas[t] == 0.0) {
            ++metrics.zero_area;
            continue;
        }
        densities.push_back({in_texture / areas[t], areas[t]});
        ratios += in_texture / areas[t];
        total += areas[t];
    }
    metrics.area = total * unit * unit;
    if (densities.empty()) return metrics;
    metrics.relative_scale = std::sqrt(total * ratios / double(densities.size()));
    std::sort(densities.begin(), densities.end());
    constexpr std::array<double, 3> shares{0.05, 0.5, 0.95};
    for (std::size_t i = 0; i < shares.size(); ++i)
        metrics.density[i] = total * weighted_percentile(densities, total, shares[i]);
    return metrics;
}

}  // namespace burl
