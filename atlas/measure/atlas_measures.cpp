#include "atlas/measure/atlas_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "atlas/base/image.h"
#include "atlas/base/weighted_percentile.h"
#include "atlas/solid/texel_rows.h"
#include "atlas/solid/weights.h"

namespace burl {

namespace {

/// A texture's sides in texels.
Vec2d sides_of(const Atlas& atlas) {
    return {atlas.options.columns(), atlas.options.rows()};
}

double texture_area(const std::array<Vec2d, 3>& corners, const Vec2d& size) {
    return 0.5 *
           std::abs(cross((corners[1] - corners[0]) / size, (corners[2] - corners[0]) / size));
}

double owned_share(const SolidAtlas& solid, const Vec2d& size) {
    double texels = 0.0;
    for (const Span& span : solid.spans) texels += span.count;
    return texels / (size.x * size.y);
}

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Twice the signed area in the texture; positive when the corners run from x to y, which is
/// clockwise on a picture whose first row is on top.
double doubled_area(const std::array<Vec2d, 3>& c) {
    return cross(c[1] - c[0], c[2] - c[0]);
}

double longest_squared(const std::array<Vec2d, 3>& c) {
    const Vec2d u = c[1] - c[0], v = c[2] - c[0], w = c[2] - c[1];
    return std::max({glm::dot(u, u), glm::dot(v, v), glm::dot(w, w)});
}

bool vanishes(const std::array<Vec2d, 3>& c) {
    return !(std::abs(doubled_area(c)) > 1e-9 * longest_squared(c));
}

/// Height over the texture's side below which a triangle has no orientation: texture coordinates of
/// 32 bits do not tell it, and the unit frame (atlas/mesh/unit_frame.h), in which a patch is found
/// to be flat, does not tell on which side such a triangle of the mesh lies.
constexpr double least_told_height = 0x1p-24;

/// Whether the triangle is lower than `height`.
bool is_lower(const std::array<Vec2d, 3>& c, double height) {
    return std::abs(doubled_area(c)) < height * std::sqrt(longest_squared(c));
}

std::uint64_t count_flipped(const Atlas& atlas, std::span<const std::uint32_t> charts,
                            std::uint32_t chart_count) {
    const double height = least_told_height * std::max(sides_of(atlas).x, sides_of(atlas).y);
    std::vector<double> balance(chart_count, 0.0);
    for (std::size_t t = 0; t < charts.size(); ++t)
        balance[charts[t]] += doubled_area(atlas.corners[t]);
    std::uint64_t flipped = 0;
    for (std::size_t t = 0; t < charts.size(); ++t) {
        const auto& corners = atlas.corners[t];
        if (vanishes(corners) || is_lower(corners, height)) continue;
        if (doubled_area(corners) * balance[charts[t]] < 0.0) ++flipped;
    }
    return flipped;
}

constexpr double inset = 1e-6;  // texels

enum Flag : std::uint8_t { readable = 1, covered = 2, inside = 4, overlapped = 8 };

void mark(Image<std::uint8_t>& flags, std::uint32_t row, double low, double high, Flag flag) {
    const TexelRun run = centres_within(low, high, std::uint32_t(flags.width()));
    for (std::uint8_t& texel : flags.row(row).subspan(run.first, run.count)) {
        if (flag == inside && (texel & inside)) texel |= overlapped;
        texel |= flag;
    }
}

bool leaves(const std::array<Vec2d, 3>& corners, double size) {
    return std::any_of(corners.begin(), corners.end(), [&](const Vec2d& c) {
        return !(std::min(c.x, c.y) >= -inset && std::max(c.x, c.y) <= size + inset);
    });
}

void mark_triangle(const std::array<Vec2d, 3>& corners, double reach, Image<std::uint8_t>& flags) {
    const auto size = std::uint32_t(flags.width());
    Interval y;
    for (const Vec2d& corner : corners) y.add(corner.y);
    visit_slices(corners, size, reach - inset, [&](std::uint32_t row, const Interval& x) {
        mark(flags, row, x.low - reach + inset, x.high + reach - inset, readable);
    });
    visit_slices(corners, size, 0.0, [&](std::uint32_t row, const Interval& x) {
        mark(flags, row, x.low, x.high, covered);
        if (y.low + inset < row + 0.5 && row + 0.5 < y.high - inset)
            mark(flags, row, x.low + inset, x.high - inset, inside);
    });
}

}  // namespace

AtlasMetrics measure(const Mesh& mesh, const Atlas& atlas, const SolidAtlas& solid) {
    AtlasMetrics metrics;
    metrics.triangles = mesh.triangles.size();
    metrics.charts = atlas.chart_count;
    metrics.texel_coverage = owned_share(solid, sides_of(atlas));
    const auto [areas, unit] = triangle_areas(mesh);
    std::vector<WeightedValue> densities;
    double ratios = 0.0, total = 0.0;
    for (std::size_t t = 0; t < areas.size(); ++t) {
        const double in_texture = texture_area(atlas.corners[t], sides_of(atlas));
        if (!atlas.is_copy(t)) metrics.coverage += in_texture;
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

double anisotropy(const std::array<Vec3d, 3>& points, const std::array<Vec2d, 3>& corners) {
    const Vec3d p = points[1] - points[0], q = points[2] - points[0];
    const double length = glm::length(p), area = glm::length(glm::cross(p, q));
    if (!(length > 0.0) || !(area > 0.0)) return infinite;
    // In the plane of the triangle p is (length, 0) and q is (along, height).
    const double along = glm::dot(p, q) / length, height = area / length;
    const Vec2d u = corners[1] - corners[0], v = corners[2] - corners[0];
    const Vec2d ds = u / length, dt = (v - along * ds) / height;
    const double squares = glm::dot(ds, ds) + glm::dot(dt, dt);  // sigma1^2 + sigma2^2
    const double product = std::abs(cross(ds, dt));              // sigma1 sigma2
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
        if (!gone && doubled_area(corners) > 0.0) metrics.mirrored += areas[t];
    }
    metrics.flipped = count_flipped(atlas, charts, chart_count);
    if (values.empty()) return metrics;
    metrics.mirrored /= total;
    std::sort(values.begin(), values.end());
    metrics.anisotropy_50 = weighted_percentile(values, total, 0.5);
    metrics.anisotropy_95 = weighted_percentile(values, total, 0.95);
    return metrics;
}

TexelMetrics measure_texels(const Atlas& atlas) {
    TexelMetrics metrics;
    const std::uint32_t size = atlas.options.size;
    const double reach = atlas.options.overscan == Overscan::bilinear ? 1.0 : 0.5;
    Image<std::uint8_t> flags(size, size);
    for (std::size_t t = 0; t < atlas.corners.size(); ++t) {
        if (atlas.is_copy(t)) continue;
        metrics.outside += leaves(atlas.corners[t], size) ? 1 : 0;
        mark_triangle(atlas.corners[t], reach, flags);
    }
    for (const std::uint8_t texel : flags.pixels()) {
        metrics.readable += texel & readable ? 1 : 0;
        metrics.covered += texel & covered ? 1 : 0;
        metrics.overlapped += texel & overlapped ? 1 : 0;
    }
    return metrics;
}

AtlasMeasures measure_atlas(const Mesh& mesh, const Atlas& atlas, const SolidAtlas& solid,
                            std::span<const MeshEdge> edges) {
    AtlasMeasures all;
    all.use = measure(mesh, atlas, solid);
    all.charts = measure_charts(mesh, atlas, edges);
    all.shape = measure_shape(mesh, atlas, all.charts.of_triangle, all.charts.count);
    all.texels = measure_texels(atlas);
    return all;
}

}  // namespace burl
