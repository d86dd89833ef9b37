// The steps, in order: the mesh in the unit frame, its division into flat charts, each turned into
// the rectangle of least area round it (divide), all packed (pack), and the corners of the
// triangles in texels.
#include "atlas/outline/layout.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "atlas/mesh/copies.h"
#include "atlas/mesh/unit_frame.h"
#include "atlas/outline/divide.h"
#include "atlas/outline/pack.h"

namespace burl {
namespace {

/// Sets corners and charts of the mapped triangles.
void place_charts(const FlatCharts& flat, const PackedOutlines& packing, Atlas& atlas) {
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

/// Where charts put the edges and points of triangles that have no map.
class PlacesOfOthers {
  public:
    PlacesOfOthers(const Mesh& mesh, const FlatCharts& flat, const Atlas& atlas) : mesh_(mesh) {
        std::vector<bool> wanted(mesh.positions.size(), false);
        for (const std::uint32_t t : flat.unmapped)
            for (const std::uint32_t p : mesh.triangles[t]) wanted[p] = true;
        for (const FlatChart& chart : flat.charts)
            for (const std::uint32_t t : chart.faces)
                for (std::size_t k = 0; k < 3; ++k) {
                    const std::uint32_t p = mesh.triangles[t][k],
                                        q = mesh.triangles[t][(k + 1) % 3];
                    if (!wanted[p]) continue;
                    const Vec2d &at_p = atlas.corners[t][k], &at_q = atlas.corners[t][(k + 1) % 3];
                    points_.emplace(p, at_p);
                    if (wanted[q])
                        edges_.emplace(key(p, q), p < q ? Ends{at_p, at_q} : Ends{at_q, at_p});
                }
    }

    /// Corners without area: an edge's two ends, where a chart has that edge, with the third corner
    /// at the nearer one; or a single place, that of a point that a chart has.
    std::array<Vec2d, 3> corners(const Triangle& triangle) const {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t p = triangle[k], q = triangle[(k + 1) % 3],
                                r = triangle[(k + 2) % 3];
            const auto edge = edges_.find(key(p, q));
            if (edge == edges_.end()) continue;
            std::array<Vec2d, 3> result;
            result[k] = edge->second[p < q ? 0 : 1];
            result[(k + 1) % 3] = edge->second[p < q ? 1 : 0];
            const auto& at = mesh_.positions;
            const bool near_p = glm::distance(at[r], at[p]) <= glm::distance(at[r], at[q]);
            result[(k + 2) % 3] = result[near_p ? k : (k + 1) % 3];
            return result;
        }
        for (const std::uint32_t p : triangle)
            if (const auto point = points_.find(p); point != points_.end())
                return {point->second, point->second, point->second};
        return {Vec2d(0.5), Vec2d(0.5), Vec2d(0.5)};
    }

  private:
    using Ends = std::array<Vec2d, 2>;  ///< of the point with the lower number, of the other

    static std::uint64_t key(std::uint32_t p, std::uint32_t q) {
        return std::uint64_t{std::min(p, q)} << 32 | std::max(p, q);
    }

    const Mesh& mesh_;
    std::unordered_map<std::uint32_t, Vec2d> points_;
    std::unordered_map<std::uint64_t, Ends> edges_;
};

/// Places triangles without a map on edges or points of the charts, in charts of their own.
void place_unmapped(const Mesh& mesh, const FlatCharts& flat, Atlas& atlas) {
    if (flat.unmapped.empty()) return;
    const PlacesOfOthers places(mesh, flat, atlas);
    for (const std::uint32_t t : flat.unmapped) {
        atlas.charts[t] = atlas.chart_count++;
        atlas.corners[t] = places.corners(mesh.triangles[t]);
    }
}

/// A mesh without the copies of its triangles: those on the same points that face the same way and
/// have the same label.
struct WithoutCopies {
    Mesh mesh;  ///< points and triangles alone
    Connectivity connectivity;
    std::vector<std::uint32_t> first;   ///< for each triangle the first of its copies, or itself
    std::vector<std::uint32_t> number;  ///< number in `mesh` of each triangle that is no copy
};

std::optional<WithoutCopies> without_copies(const Mesh& mesh, const Connectivity& connectivity) {
    WithoutCopies result;
    const std::vector<std::uint32_t>& labels = connectivity.labels;
    visit_copies(mesh.triangles, least_first, [&](std::uint32_t t, std::uint32_t first) {
        if (!labels.empty() && labels[t] != labels[first]) return;
        if (result.first.empty()) {
            result.first.resize(mesh.triangles.size());
            std::iota(result.first.begin(), result.first.end(), 0u);
        }
        result.first[t] = first;
    });
    if (result.first.empty()) return std::nullopt;
    result.mesh.positions = mesh.positions;
    result.number.resize(mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        if (result.first[t] != t) continue;
        result.number[t] = std::uint32_t(result.mesh.triangles.size());
        result.mesh.triangles.push_back(mesh.triangles[t]);
        result.connectivity.neighbours.push_back(connectivity.neighbours[t]);
    }
    for (auto& sides : result.connectivity.neighbours)
        for (std::int32_t& side : sides)
            if (side >= 0)
                side = result.first[std::size_t(side)] == std::uint32_t(side)
                           ? std::int32_t(result.number[std::size_t(side)])
                           : -1;
    return result;
}

/// Places all triangles of the mesh by an atlas of it without copies.
Atlas with_copies(const Mesh& mesh, WithoutCopies firsts, Atlas atlas) {
    const auto own = std::exchange(atlas.corners, {});
    const auto charts = std::exchange(atlas.charts, {});
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::uint32_t first = firsts.first[t], number = firsts.number[first];
        std::size_t turn = 0;
        while (turn < 2 && mesh.triangles[first][turn] != mesh.triangles[t][0]) ++turn;
        const auto& at = own[number];
        atlas.corners.push_back({at[turn], at[(turn + 1) % 3], at[(turn + 2) % 3]});
        atlas.charts.push_back(charts[number]);
    }
    atlas.copy_of = std::move(firsts.first);
    return atlas;
}

/// The atlas of a mesh in which every triangle gets a place of its own.
std::optional<Atlas> layout_all(const Mesh& mesh, const Connectivity& connectivity,
                                const AtlasOptions& options, const std::stop_token& stop) {
    const FlatCharts flat = divide_into_charts(in_unit_frame(mesh), connectivity, {.stop = stop});
    if (stop.stop_requested()) return std::nullopt;
    std::vector<Outline> outlines;
    for (const FlatChart& chart : flat.charts) outlines.push_back({chart.outline, chart.area});
    const std::optional<PackedOutlines> packing = pack_outlines(outlines, options.size);
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

}  // namespace

std::optional<Atlas> layout_charts(const Mesh& mesh, const Connectivity& connectivity,
                                   const AtlasOptions& options, const std::stop_token& stop) {
    auto firsts = without_copies(mesh, connectivity);
    if (!firsts) return layout_all(mesh, connectivity, options, stop);
    auto atlas = layout_all(firsts->mesh, firsts->connectivity, options, stop);
    if (!atlas) return std::nullopt;
    return with_copies(mesh, std::move(*firsts), std::move(*atlas));
}

}  // namespace burl
