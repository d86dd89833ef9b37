// The steps, in order: the mesh in the unit frame, its division into flat charts (divide), each
// turned into the rectangle of least area round it, all packed (pack), and the corners of the
// triangles in texels.
#include "atlas/outline/layout.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

#include "atlas/mesh/unit_frame.h"
#include "atlas/outline/divide.h"
#include "atlas/outline/pack.h"

namespace burl {
namespace {

/// The convex hull of points, counter-clockwise (Andrew's monotone chain, 1979).
std::vector<Vec2d> hull_of(std::vector<Vec2d> points) {
    std::ranges::sort(points, [](const Vec2d& a, const Vec2d& b) {
        return a.x < b.x || (a.x == b.x && a.y < b.y);
    });
    std::vector<Vec2d> hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t first = hull.size();
        for (const Vec2d& p : points) {
            while (hull.size() >= first + 2 &&
                   cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0)
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();
        std::ranges::reverse(points);
    }
    return hull;
}

/// Turns the chart so that the box round it has the least area, with its longer side along x.
void straighten(FlatChart& chart) {
    const std::vector<Vec2d> hull = hull_of(chart.outline);
    double least = std::numeric_limits<double>::infinity();
    Vec2d along(1.0, 0.0);
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Vec2d edge = hull[(i + 1) % hull.size()] - hull[i];
        if (!(glm::length(edge) > 0.0)) continue;
        const Vec2d u = glm::normalize(edge), v(-u.y, u.x);
        Vec2d low(std::numeric_limits<double>::infinity()), high = -low;
        for (const Vec2d& p : hull) {
            const Vec2d q(glm::dot(p, u), glm::dot(p, v));
            low = glm::min(low, q);
            high = glm::max(high, q);
        }
        const Vec2d size = high - low;
        if (!(size.x * size.y < least)) continue;
        least = size.x * size.y;
        along = size.x >= size.y ? u : v;
    }
    const auto turn = [&](Vec2d& p) { p = {glm::dot(p, along), cross(along, p)}; };
    std::ranges::for_each(chart.places, turn);
    std::ranges::for_each(chart.outline, turn);
}

/// Sets corners and charts of the mapped triangles.
void place_charts(const FlatCharts& flat, const Packing& packing, Atlas& atlas) {
    for (std::uint32_t c = 0; c < flat.charts.size(); ++c) {
        const FlatChart& chart = flat.charts[c];
        for (std::size_t t = 0; t < chart.faces.size(); ++t) {
            atlas.charts[chart.faces[t]] = c;
            for (std::size_t k = 0; k < 3; ++k)
                atlas.corners[chart.faces[t]][k] =
                    packing.outlines[c](chart.places[chart.triangles[t][k]]);
        }
    }
    atlas.chart_count = std::uint32_t(flat.charts.size());
}

/// Places triangles without a map at their first point's place, in charts of their own.
void place_unmapped(const Mesh& mesh, const FlatCharts& flat, Atlas& atlas) {
    if (flat.unmapped.empty()) return;
    std::unordered_map<std::uint32_t, Vec2d> place_of_point;
    for (const FlatChart& chart : flat.charts)
        for (const std::uint32_t t : chart.faces)
            for (std::size_t k = 0; k < 3; ++k)
                place_of_point.emplace(mesh.triangles[t][k], atlas.corners[t][k]);
    for (const std::uint32_t t : flat.unmapped) {
        atlas.charts[t] = atlas.chart_count++;
        const auto place = place_of_point.find(mesh.triangles[t][0]);
        atlas.corners[t].fill(place == place_of_point.end() ? Vec2d(0.5) : place->second);
    }
}

}  // namespace

std::optional<Atlas> layout_charts(const Mesh& mesh, const Connectivity& connectivity,
                                   const AtlasOptions& options, const std::stop_token& stop) {
    FlatCharts flat = divide_into_charts(in_unit_frame(mesh), connectivity, {.stop = stop});
    if (stop.stop_requested()) return std::nullopt;
    std::vector<Outline> outlines;
    for (FlatChart& chart : flat.charts) {
        straighten(chart);
        outlines.push_back({chart.outline, chart.area});
    }
    const std::optional<Packing> packing = pack_outlines(outlines, options.size);
    if (!packing) return std::nullopt;
    Atlas atlas;
    atlas.options = options;
    atlas.notes.texels_total = std::uint64_t{options.size} * options.size;
    atlas.corners.resize(mesh.triangles.size());
    atlas.charts.resize(mesh.triangles.size());
    place_charts(flat, *packing, atlas);
    place_unmapped(mesh, flat, atlas);
    return atlas;
}

}  // namespace burl
