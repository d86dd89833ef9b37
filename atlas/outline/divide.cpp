#include "atlas/outline/divide.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "atlas/chart/covering.h"
#include "atlas/chart/least_rectangle.h"
#include "atlas/chart/planar_map.h"
#include "atlas/mesh/dual_graph.h"
#include "atlas/outline/unfold.h"
#include "atlas/patch/cut.h"

namespace burl {
namespace {

/// Share of the mesh's area below which a chart may be distorted `small_slack` times as much: its
/// own borders would cost more.
constexpr double small_share = 0.005, small_slack = 4.0;

/// Longest side of the box round a chart relative to that of a square with the mesh's area: a
/// longer chart would leave much of the texture empty. Charts of up to `few_triangles` are kept all
/// the same.
constexpr double longest_chart = 1.3;
constexpr std::size_t few_triangles = 16;
/// Longest side of the box round triangles of a net that do not lie in a plane, likewise.
constexpr double longest_net = 0.75;

/// Area of a patch, relative to that of a circle with its border, above which it is not flattened:
/// in the plane no border encloses more than a circle. Of 1,738 patches that came to a wanted
/// energy none had more than 2.11, which small charts' distortion allows.
constexpr double most_bulge = 2.5;

/// Farthest that a chart's places may lie beyond its outline, in sides of the box round that, and
/// how much more area than in the outline its triangles may have, in squares of that side.
constexpr double most_beyond = 1e-6;

/// Whether the disk's border is too short for its area.
bool bulges(const Patch& disk) {
    const double border = length_of(disk, disk.loops[0]);
    return 4.0 * std::numbers::pi * area_of(disk) > most_bulge * border * border;
}

/// The area that a closed polygon goes round, once for each turn.
double area_in(std::span<const Vec2d> polygon) {
    double twice = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        twice += cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
    return 0.5 * twice;
}

/// The border with all others inside: the box round it is the largest, though a hole's may be
/// longer. Of equal boxes that of more area counts, and of those the longest.
std::vector<Vec2d> outer_border(const Patch& patch, std::span<const Vec2d> places) {
    std::vector<Vec2d> outer;
    std::pair most(-1.0, 0.0);
    for (const auto& loop : patch.loops) {
        std::vector<Vec2d> border;
        Vec2d low = places[patch.start(loop[0])], high = low;
        for (const HalfEdge h : loop) {
            const Vec2d& at = border.emplace_back(places[patch.start(h)]);
            low = glm::min(low, at);
            high = glm::max(high, at);
        }
        const std::pair extent(high.x - low.x + high.y - low.y, area_in(border));
        if (extent <= most) continue;
        most = extent;
        outer = std::move(border);
    }
    return outer;
}

/// Turns the chart so that the box round it has the least area, with its longer side along x, whose
/// length is returned.
double straighten(FlatChart& chart) {
    const TurnedRectangle box = least_rectangle(convex_hull(chart.outline));
    const Vec2d u = box.axis;
    const Vec2d along = box.size().x >= box.size().y ? u : Vec2d(-u.y, u.x);
    const auto turn = [&](Vec2d& p) { p = {glm::dot(p, along), cross(along, p)}; };
    std::ranges::for_each(chart.places, turn);
    std::ranges::for_each(chart.outline, turn);
    return box.longer();
}

/// The area of a chart's triangles in the plane.
double mapped_area(const FlatChart& chart) {
    double twice = 0.0;
    for (const auto& [i, j, k] : chart.triangles)
        twice += cross(chart.places[j] - chart.places[i], chart.places[k] - chart.places[i]);
    return 0.5 * twice;
}

/// Whether no place lies beyond the box round the outline, and the outline encloses the triangles'
/// area, but for `most_beyond`. Triangles without area may reach out of a map that is one to one,
/// and the border with the largest box may be theirs.
bool outline_holds(const FlatChart& chart) {
    const auto box = [](std::span<const Vec2d> points) {
        std::array<Vec2d, 2> ends{points[0], points[0]};
        for (const Vec2d& p : points) ends = {glm::min(ends[0], p), glm::max(ends[1], p)};
        return ends;
    };
    const auto [low, high] = box(chart.outline);
    const auto [least, most] = box(chart.places);
    const Vec2d beyond = glm::max(low - least, most - high);
    const double side = std::max(high.x - low.x, high.y - low.y);
    return std::max(beyond.x, beyond.y) <= most_beyond * side &&
           mapped_area(chart) - area_in(chart.outline) <= most_beyond * side * side;
}

/// The chart of a patch with these places; triangles that close holes are left out.
FlatChart chart_of(const Patch& patch, std::vector<Vec2d> places) {
    FlatChart chart;
    chart.places = std::move(places);
    for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
        if (patch.faces[t] == not_in_mesh) continue;
        chart.faces.push_back(patch.faces[t]);
        chart.triangles.push_back(patch.triangles[t]);
    }
    chart.outline = outer_border(patch, chart.places);
    chart.area = area_of(patch);
    return chart;
}

/// The places of a planar patch in its plane.
std::vector<Vec2d> in_plane(const PlanarMap& map) {
    const Vec2d sides(glm::length(map.along_u), glm::length(map.along_v));
    std::vector<Vec2d> places;
    places.reserve(map.uv.size());
    for (const Vec2d& uv : map.uv) places.push_back(uv * sides);
    return places;
}

/// The mesh's shells, each as ascending triangles.
Regions shells_of(const Mesh& mesh, const Connectivity& connectivity) {
    const auto count = std::uint32_t(mesh.triangles.size());
    DisjointSets sets(count);
    for (std::uint32_t t = 0; t < count; ++t)
        for (const std::int32_t n : connectivity.neighbours[t])
            if (n >= 0) sets.join(t, std::uint32_t(n));
    Regions shells;
    std::vector<std::uint32_t> number(count);
    for (std::uint32_t t = 0; t < count; ++t) {
        const std::uint32_t first = sets.find(t);
        if (first == t) {
            number[t] = std::uint32_t(shells.size());
            shells.emplace_back();
        }
        shells[number[first]].push_back(t);
    }
    return shells;
}

/// The triangles that are lines: lower than what rounding to the unit frame moves points by.
std::vector<bool> lines_of(const Mesh& mesh) {
    std::vector<bool> lines(mesh.triangles.size());
    for (std::size_t t = 0; t < lines.size(); ++t) {
        double longest = 0.0;
        for (std::size_t k = 0; k < 3; ++k)
            longest = std::max(longest, edge_length(mesh, std::uint32_t(t), k));
        lines[t] = 2.0 * triangle_area(mesh, t) <= most_overlap * longest;
    }
    return lines;
}

/// The triangles that are lines with a point of a triangle with area, whose place is theirs.
std::vector<bool> lines_on_others(const Mesh& mesh) {
    std::vector<bool> lines = lines_of(mesh);
    if (std::ranges::find(lines, true) == lines.end()) return {};
    std::vector<bool> has_area(mesh.positions.size(), false);
    for (std::size_t t = 0; t < lines.size(); ++t)
        for (const std::uint32_t p : mesh.triangles[t])
            if (!lines[t]) has_area[p] = true;
    for (std::size_t t = 0; t < lines.size(); ++t)
        lines[t] = lines[t] && std::ranges::any_of(mesh.triangles[t],
                                                   [&](std::uint32_t p) { return has_area[p]; });
    return lines;
}

/// Flattens regions, halving those that distort too much.
class Division {
  public:
    Division(const Mesh& mesh, const Connectivity& connectivity, double area,
             const DivisionOptions& options)
        : mesh_(mesh),
          connectivity_(connectivity),
          area_(area),
          options_(options),
          lines_(lines_on_others(mesh)),
          local_([&mesh] { return std::vector<std::int32_t>(mesh.triangles.size(), -1); }) {}

    /// Flattens shells that need no division, and then the regions in all others.
    FlatCharts flatten_shells(const Regions& shells) {
        std::vector<std::vector<FlatChart>> by_shell(shells.size());
        tbb::parallel_for(std::size_t(0), shells.size(), [&](std::size_t i) {
            if (!options_.stop.stop_requested() && !are_lines(shells[i]))
                by_shell[i] = flatten_shell(shells[i]);
        });
        FlatCharts result;
        std::vector<bool> done(mesh_.triangles.size(), false);
        for (const auto& shell : shells) {
            if (!are_lines(shell)) continue;
            std::ranges::copy(shell, std::back_inserter(result.unmapped));
            done[shell.front()] = true;
        }
        for (std::vector<FlatChart>& charts : by_shell)
            for (FlatChart& chart : charts) {
                for (const std::uint32_t face : chart.faces) done[face] = true;
                result.charts.push_back(std::move(chart));
            }
        if (std::ranges::all_of(shells, [&](const auto& shell) { return done[shell.front()]; }))
            return result;
        Regions regions = partition_mesh(mesh_, connectivity_, options_.partition);
        std::erase_if(regions, [&](const auto& region) { return done[region.front()]; });
        FlatCharts others = flatten_all(regions);
        std::ranges::move(others.charts, std::back_inserter(result.charts));
        std::ranges::copy(others.unmapped, std::back_inserter(result.unmapped));
        return result;
    }

  private:
    /// Whether all these triangles are lines that take their places from others.
    bool are_lines(const std::vector<std::uint32_t>& faces) const {
        return !lines_.empty() &&
               std::ranges::all_of(faces, [&](std::uint32_t t) { return lines_[t]; });
    }

    FlatCharts flatten_all(const Regions& regions) {
        std::vector<FlatCharts> by_region(regions.size());
        tbb::parallel_for(std::size_t(0), regions.size(),
                          [&](std::size_t i) { by_region[i] = flatten(regions[i]); });
        FlatCharts result;
        for (FlatCharts& of : by_region) {
            std::ranges::move(of.charts, std::back_inserter(result.charts));
            std::ranges::copy(of.unmapped, std::back_inserter(result.unmapped));
        }
        return result;
    }

    FlatCharts flatten(const std::vector<std::uint32_t>& faces) {
        FlatCharts result;
        if (options_.stop.stop_requested() || are_lines(faces)) {
            result.unmapped = faces;
            return result;
        }
        const Regions pieces = flatten_or_divide(faces, result);
        return pieces.empty() ? std::move(result) : flatten_all(pieces);
    }

    /// Flattens the faces into `result`, or returns the pieces to flatten instead.
    Regions flatten_or_divide(const std::vector<std::uint32_t>& faces, FlatCharts& result) {
        std::vector<std::int32_t>& local = local_.local();
        Patch patch = extract_patch(mesh_, connectivity_, faces, local);
        Regions components = component_faces(patch);
        if (components.size() > 1) return components;
        if (auto chart = flatten(std::move(patch))) {
            result.charts.push_back(std::move(*chart));
            return {};
        }
        if (faces.size() > 1) return bisect_region(mesh_, connectivity_, faces, local);
        result.unmapped = faces;
        return {};
    }

    /// A shell as one chart, or as few exact ones; nothing where it has to be divided.
    std::vector<FlatChart> flatten_shell(const std::vector<std::uint32_t>& faces) {
        std::vector<FlatChart> charts;
        Patch patch = extract_patch(mesh_, connectivity_, faces, local_.local());
        if (!patch.loops.empty())
            if (auto chart = flatten(std::move(patch))) charts.push_back(std::move(*chart));
        if (!charts.empty()) return charts;
        const NetOptions options{.longest_flat = longest_chart * std::sqrt(area_),
                                 .longest = longest_net * std::sqrt(area_),
                                 .gap = std::sqrt(area_) / 256.0};
        auto net = unfold(mesh_, connectivity_, faces, options);
        if (!net) return {};
        std::ranges::for_each(*net, straighten);
        if (!std::ranges::all_of(*net, outline_holds)) return {};
        return std::move(*net);
    }

    /// The chart of a connected patch; nothing where it would be distorted too much, overlap, reach
    /// out of its outline, or be too long.
    std::optional<FlatChart> flatten(Patch patch) const {
        if (const auto planar = map_planar(patch))
            return if_sound(chart_of(patch, in_plane(*planar)));
        if (!cut_to_disk(patch, connectivity_) || bulges(patch)) return std::nullopt;
        const double most = most_energy(area_of(patch));
        auto map = map_freely(patch, {.wanted = most});
        if (!map || !(map->energy <= most) || overlaps_itself(patch, map->places) ||
            covers_twice(patch, map->places, most_overlap))
            return std::nullopt;
        return if_sound(chart_of(patch, std::move(map->places)));
    }

    std::optional<FlatChart> if_sound(FlatChart chart) const {
        const double longer = straighten(chart);
        if (!outline_holds(chart)) return std::nullopt;
        if (chart.faces.size() > few_triangles && longer > longest_chart * std::sqrt(area_))
            return std::nullopt;
        return chart;
    }

    double most_energy(double area) const {
        const double slack = area < small_share * area_ ? small_slack : 1.0;
        return 1.0 + slack * (options_.most_energy - 1.0);
    }

    const Mesh& mesh_;
    const Connectivity& connectivity_;
    double area_;
    DivisionOptions options_;
    std::vector<bool> lines_;  ///< lines_on_others(); empty where there are none
    tbb::enumerable_thread_specific<std::vector<std::int32_t>> local_;
};

}  // namespace

FlatCharts divide_into_charts(const Mesh& mesh, const Connectivity& connectivity,
                              const DivisionOptions& options) {
    double area = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) area += triangle_area(mesh, t);
    FlatCharts result =
        Division(mesh, connectivity, area, options).flatten_shells(shells_of(mesh, connectivity));
    std::ranges::sort(result.unmapped);
    return result;
}

}  // namespace burl
