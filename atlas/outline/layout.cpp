// The steps, in order: the mesh in the unit frame, one or two divisions into flat charts (divide),
// each turned into the rectangle of least area round it, all packed (pack), the division of least
// cost, and the corners of its triangles in texels.
#include "atlas/outline/layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "atlas/mesh/unit_frame.h"
#include "atlas/outline/divide.h"
#include "atlas/outline/pack.h"

namespace burl {
namespace {

constexpr PartitionOptions partition{.patches = 8, .seed = 1, .least_share = 0.05};
constexpr double crease_degrees = 30.0;
/// The cost of a division is the area of a texel on the surface times this power of the mean
/// energy, and half a per cent more for each chart, whose borders blur the upper levels.
constexpr double energy_power = 8.0, per_chart = 0.005;

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

/// The divisions that are tried: a partition, and the creases where they divide the mesh well.
std::vector<Regions> divisions(const Mesh& mesh, const Connectivity& connectivity) {
    std::vector<Regions> all{partition_mesh(mesh, connectivity, partition)};
    Regions creases = crease_regions(mesh, connectivity, crease_degrees, partition);
    if (divides_well(mesh, creases)) all.push_back(std::move(creases));
    return all;
}

/// A division, packed.
struct Candidate {
    FlatCharts flat;
    Packing packing;
    double cost = 0.0;
};

std::optional<Candidate> candidate(const Mesh& mesh, const Connectivity& connectivity,
                                   const Regions& regions, std::uint32_t size,
                                   const std::stop_token& stop) {
    Candidate result{divide_into_charts(mesh, connectivity, regions, {.stop = stop}), {}};
    if (stop.stop_requested()) return std::nullopt;
    std::vector<Outline> outlines;
    for (FlatChart& chart : result.flat.charts) {
        straighten(chart);
        outlines.push_back({chart.outline, chart.area});
    }
    std::optional<Packing> packing = pack_outlines(outlines, size);
    if (!packing) return std::nullopt;
    result.packing = std::move(*packing);
    result.cost = std::pow(mean_energy(result.flat), energy_power) *
                  (1.0 + per_chart * double(outlines.size())) /
                  (result.packing.scale * result.packing.scale);
    return result;
}

}  // namespace

std::optional<Atlas> layout_charts(const Mesh& mesh, const Connectivity& connectivity,
                                   const AtlasOptions& options, const std::stop_token& stop) {
    const Mesh unit = in_unit_frame(mesh);
    std::optional<Candidate> best;
    for (const Regions& regions : divisions(unit, connectivity)) {
        std::optional<Candidate> other = candidate(unit, connectivity, regions, options.size, stop);
        if (stop.stop_requested()) return std::nullopt;
        if (other && (!best || other->cost < best->cost)) best = std::move(other);
    }
    if (!best) return std::nullopt;
    Atlas atlas;
    atlas.options = options;
    atlas.notes.texels_total = std::uint64_t{options.size} * options.size;
    atlas.corners.resize(mesh.triangles.size());
    atlas.charts.resize(mesh.triangles.size());
    place_charts(best->flat, best->packing, atlas);
    place_unmapped(mesh, best->flat, atlas);
    return atlas;
}

}  // namespace burl
