// Mapping with chosen corners: the corner search has already solved for nearly the same patch, so
// the descent starts from its harmonic map.
#include "atlas/chart/rectangle_map.h"

#include <cmath>
#include <numeric>

#include "atlas/chart/laplacian.h"

namespace burl {
namespace {

/// Ratio of a harmonic map's D to the wanted one beyond which a descent does not repair it.
constexpr double hopeless = 16.0;
/// Smallest share of a relaxed map's D - 1 that a descent leaves.
constexpr double least_repair = 0.15;

/// The map that the search found, with the middles of the chosen corners' chords only.
RectangleMap map_of_choice(const Patch& patch, const CornerChoice& choice) {
    RectangleMap map;
    map.corners = choice.corners;
    map.sides = side_masks(patch, choice.corners);
    map.uv.assign(choice.uv.begin(), choice.uv.begin() + std::ptrdiff_t(patch.points.size()));
    std::size_t next = patch.points.size();
    for (HalfEdge h = 0; h < 3 * patch.triangles.size(); ++h) {
        if (patch.on_border(h) || patch.across(h) < h) continue;
        const SideMask a = map.sides[patch.start(h)], b = map.sides[patch.end(h)];
        if (a == 0 || b == 0) continue;
        if ((a & b) != 0) map.uv.push_back(choice.uv[next]);
        ++next;
    }
    return map;
}

}  // namespace

std::vector<SideMask> side_masks(const Patch& patch, const Corners& corners) {
    const auto& loop = patch.loops[0];
    std::vector<SideMask> sides(patch.points.size(), 0);
    for (std::size_t side = 0; side < 4; ++side) {
        const std::size_t last = corners[(side + 1) % 4];
        for (std::size_t i = corners[side];; i = (i + 1) % loop.size()) {
            SideMask& mask = sides[patch.start(loop[i])];
            mask = static_cast<SideMask>(mask | (1u << side));
            if (i == last) break;
        }
    }
    return sides;
}

std::optional<RectangleMap> harmonic_map(const Patch& patch, const Corners& corners) {
    RectangleMap map;
    map.corners = corners;
    map.sides = side_masks(patch, corners);
    const StretchMeasure measure(patch);
    for (const EdgeWeights weights : {EdgeWeights::cotangent, EdgeWeights::uniform}) {
        std::vector<std::vector<Vec2d>> uv(1, std::vector<Vec2d>(patch.points.size()));
        place_border(patch, corners, uv[0]);
        const PatchLaplacian laplacian(weighted_edges(patch, weights), inner_vertices(patch));
        if (!laplacian.factored()) continue;
        laplacian.solve_harmonic(uv);
        map.stretch = measure(uv[0]);
        map.uv = std::move(uv[0]);
        if (map.stretch.finite()) return map;
    }
    return std::nullopt;
}

void relax(const Patch& patch, const WeightedEdges& cotangents, RectangleMap& map, int rounds) {
    const StretchMeasure measure(patch);
    WeightedEdges edges = cotangents;
    std::optional<PatchLaplacian> laplacian;
    std::vector<double> factor(patch.triangles.size(), 1.0);
    for (int round = 0; round < rounds; ++round) {
        const double aspect = map.stretch.best_aspect();
        // The square root of sqrt(XY) / A: with it the mean triangle's factor stays about 1.
        const double mean = std::sqrt(std::sqrt(map.stretch.x * map.stretch.y) / map.stretch.area);
        const std::vector<double> stretch = measure.of_triangles(map.uv, aspect);
        for (std::size_t t = 0; t < factor.size(); ++t) factor[t] *= mean / stretch[t];
        for (std::size_t e = 0; e < edges.edges.size(); ++e) {
            const auto& [t0, t1] = edges.edges[e].triangles;
            edges.edges[e].weight = cotangents.edges[e].weight * 0.5 * (factor[t0] + factor[t1]);
        }
        if (laplacian)
            laplacian->refactor(edges);
        else
            laplacian.emplace(edges, inner_vertices(patch));
        if (!laplacian->factored()) return;
        std::vector<std::vector<Vec2d>> uv(1, map.uv);
        laplacian->solve_harmonic(uv);
        const Stretch after = measure(uv[0]);
        if (!(after.distortion() < map.stretch.distortion())) return;
        map.uv = std::move(uv[0]);
        map.stretch = after;
    }
}

std::optional<RectangleMap> map_onto_rectangle(Patch& patch, const DescentOptions& options) {
    const double limit = hopeless * options.wanted;
    const auto choice = search_corners(patch, 4.0 * limit);
    if (!choice || choice->distortion > limit) return std::nullopt;
    std::optional<RectangleMap> map = map_of_choice(patch, *choice);
    Patch refined = patch;
    const std::uint32_t extra = split_chords(refined, map->sides);
    map->sides.resize(refined.points.size(), 0);
    map->stretch = StretchMeasure(refined)(map->uv);
    if (!map->stretch.finite()) map = harmonic_map(refined, choice->corners);
    if (!map) return std::nullopt;
    map->extra_vertices = extra;
    std::vector<std::uint32_t> order(extra);
    std::iota(order.begin(), order.end(), static_cast<std::uint32_t>(patch.points.size()));
    order.insert(order.end(), choice->order.begin(), choice->order.end());
    const WeightedEdges edges = weighted_edges(refined, EdgeWeights::cotangent, std::move(order));
    relax(refined, edges, *map);
    if (least_repair * (map->stretch.distortion() - 1.0) > options.wanted - 1.0)
        return std::nullopt;
    descend(refined, edges, *map, options);
    patch = std::move(refined);
    return map;
}

}  // namespace burl
