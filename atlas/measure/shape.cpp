#include "atlas/measure/shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "atlas/base/weighted_percentile.h"
#include "atlas/solid/weights.h"

namespace burl {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Twice the signed area in the texture; positive when the corners run from x to y, which is
/// clockwise on a picture whose first row is on top.
double cross(const std::array<Vec2d, 3>& c) {
    const Vec2d u = c[1] - c[0], v = c[2] - c[0];
    return u.x * v.y - u.y * v.x;
}

double longest_squared(const std::array<Vec2d, 3>& c) {
    const Vec2d u = c[1] - c[0], v = c[2] - c[0], w = c[2] - c[1];
    return std::max({glm::dot(u, u), glm::dot(v, v), glm::dot(w, w)});
}

bool vanishes(const std::array<Vec2d, 3>& c) {
    return !(std::abs(cross(c)) > 1e-9 * longest_squared(c));
}

std::uint64_t count_flipped(const Atlas& atlas, std::span<const std::uint32_t> charts,
                            std::uint32_t chart_count) {
    std::vector<double> balance(chart_count, 0.0);
    for (std::size_t t = 0; t < charts.size(); ++t) balance[charts[t]] += cross(atlas.corners[t]);
    std::uint64_t flipped = 0;
    for (std::size_t t = 0; t < charts.size(); ++t) {
        const auto& corners = atlas.corners[t];
        if (!vanishes(corners) && cross(corners) * balance[charts[t]] < 0.0) ++flipped;
    }
    return flipped;
}

}  // namespace

double anisotropy(const std::array<Vec3d, 3>& points, const std::array<Vec2d, 3>& corners) {
    const Vec3d p = points[1] - points[0], q = points[2] - points[0];
    const double length = glm::length(p), area = glm::length(glm::cross(p, q));
    if (!(length > 0.0) || !(area > 0.0)) return infinite;
    // In the plane of the triangle p is (length, 0) and q is (along, height).
    const double along = glm::dot(p, q) / length, height = area / length;
    const Vec2d u = corners[1] - corners[0], v = corners[2] - corners[0];
    const Vec2d ds = u / length, dt = (v - along * ds) / height;
    const double squares = glm::dot(ds, ds) + glm::dot(dt, dt);  // sigma1^2 + sigma2^2
    const double product = std::abs(ds.x * dt.y - ds.y * dt.x);  // sigma1 sigma2
    if (!(product > 0.0)) return infinite;
    const double x = 0.5 * squares / product;
    return x + std::sqrt(std::max(0.0, (x - 1.0) * (x + 1.0)));
}

ShapeMetrics measure_shape(const Mesh& mesh, const Atlas& atlas,
                           std::span<const std::uint32_t> charts, std::uint32_t chart_count) {
    ShapeMetrics metrics;
    const std::vector<double> areas = triangle_areas(mesh).areas;
    std::vector<WeightedValue> values;
    double total = 0.0;
    for (std::size_t t = 0; t < areas.size(); ++t) {
        if (areas[t] == 0.0) continue;
        const auto& [a, b, c] = mesh.triangles[t];
        const auto& corners = atlas.corners[t];
        const bool gone = vanishes(corners);
        metrics.vanished += gone ? 1 : 0;
        const double value =
            gone ? infinite
                 : anisotropy({mesh.positions[a], mesh.positions[b], mesh.positions[c]}, corners);
        values.push_back({value, areas[t]});
        total += areas[t];
        // Rows run downwards on a picture, so a triangle that is counter-clockwise on the surface
        // and on the picture has a negative cross product.
        if (!gone && cross(corners) > 0.0) metrics.mirrored += areas[t];
    }
    metrics.flipped = count_flipped(atlas, charts, chart_count);
    if (values.empty()) return metrics;
    metrics.mirrored /= total;
    std::sort(values.begin(), values.end());
    metrics.anisotropy_50 = weighted_percentile(values, total, 0.5);
    metrics.anisotropy_95 = weighted_percentile(values, total, 0.95);
    return metrics;
}

}  // namespace burl
