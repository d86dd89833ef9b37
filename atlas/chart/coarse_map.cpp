// Undoing collapses: vertices come back in the reverse order of their collapse. A ring lies round
// the place of the neighbour into which its vertex was collapsed and sees it, so close enough to
// that place there is always a point that the whole ring sees, too; the mean value coordinates of
// the surface (Floater, "Mean value coordinates", 2003) are taken where the ring sees their point.
#include "atlas/chart/coarse_map.h"

#include <algorithm>
#include <limits>

#include "atlas/chart/coarse_mesh.h"
#include "atlas/chart/stretch_sweeps.h"

namespace burl {
namespace {

/// A coarse patch has a step_down-th of the triangles, but no fewer than least_triangles.
constexpr std::size_t least_triangles = 8000, step_down = 4;
/// Factor on the wanted D that the coarse map may have: detail costs a map some distortion, and
/// smoothing gains some.
constexpr double carried_over = 1.1;
constexpr int relaxation_sweeps = 40, most_halvings = 40;

/// The ring of a vertex that comes back, with the places of the ring's vertices in the map.
struct Ring {
    std::span<const std::uint32_t> vertices;
    std::span<const Vec2d> uv;

    Vec2d at(std::size_t i) const { return uv[vertices[i % vertices.size()]]; }
    /// Whether q lies strictly to the left of every edge of the ring.
    bool sees(const Vec2d& q) const {
        for (std::size_t i = 0; i < vertices.size(); ++i)
            if (!(cross(at(i) - q, at(i + 1) - q) > 0.0)) return false;
        return true;
    }
};

/// The point that has in the map the mean value coordinates which the vertex has in its ring on the
/// surface.
Vec2d mean_value(const Patch& patch, std::uint32_t vertex, const Ring& ring) {
    const std::size_t n = ring.vertices.size();
    const auto spoke = [&](std::size_t i) {
        return patch.points[ring.vertices[i % n]] - patch.points[vertex];
    };
    const auto half_tangent = [&](std::size_t i) {
        const Vec3d a = spoke(i), b = spoke(i + 1);
        const double twice = glm::length(glm::cross(a, b));
        return (glm::length(a) * glm::length(b) - glm::dot(a, b)) / twice;
    };
    Vec2d sum(0.0);
    double all = 0.0, before = half_tangent(n - 1);
    for (std::size_t i = 0; i < n; ++i) {
        const double after = half_tangent(i), weight = (before + after) / glm::length(spoke(i));
        sum += weight * ring.at(i);
        all += weight;
        before = after;
    }
    return sum / all;
}

/// A point near the ring's first vertex that the whole ring sees: the ring sees that vertex, and so
/// it sees points close to it to the left of both edges there. Nothing where rounding leaves none.
std::optional<Vec2d> near_first(const Ring& ring) {
    const Vec2d here = ring.at(0);
    const Vec2d out = ring.at(1) - here, in = here - ring.at(ring.vertices.size() - 1);
    const double shorter = std::min(glm::length(out), glm::length(in));
    const Vec2d along = glm::normalize(out) + glm::normalize(in);
    Vec2d aside = 0.5 * shorter * Vec2d(-along.y, along.x);
    for (int i = 0; i < most_halvings; ++i, aside *= 0.5)
        if (const Vec2d q = here + aside; ring.sees(q)) return q;
    return std::nullopt;
}

/// Sets the fine map from the coarse one, smoothed; false, and no change, where the fine map flips.
bool carry_map(const Patch& patch, const CoarseMap& coarse, RectangleMap& map) {
    auto uv = carry_to_fine(patch, coarse.level, coarse.map.uv);
    if (!uv) return false;
    sweep_stretch(patch, *uv, coarse.map.stretch.best_aspect(), relaxation_sweeps);
    const Stretch stretch = StretchMeasure(patch)(*uv);
    if (!stretch.finite()) return false;
    map.uv = std::move(*uv);
    map.stretch = stretch;
    return true;
}

std::optional<RectangleMap> map_coarsely(Patch& patch, const DescentOptions& options) {
    Patch fine = patch;
    RectangleMap map;
    map.extra_vertices = split_border_chords(fine);
    auto coarse = std::make_shared<CoarseMap>();
    coarse->level =
        coarsen_patch(fine, std::max(least_triangles, fine.triangles.size() / step_down));
    if (2 * coarse->level.patch.triangles.size() > fine.triangles.size())
        return map_onto_rectangle(patch, options);
    // In a coarse patch with few inner and many border triangles the harmonic map says little about
    // the final one, so it must not end the search.
    DescentOptions patient = options;
    patient.wanted = std::numeric_limits<double>::infinity();
    auto of_coarse = map_patch(coarse->level.patch, patient);
    if (!of_coarse || of_coarse->stretch.distortion() > carried_over * options.wanted)
        return std::nullopt;
    coarse->map = std::move(*of_coarse);
    map.corners = coarse->map.corners;
    map.sides = side_masks(fine, map.corners);
    if (!carry_map(fine, *coarse, map)) return std::nullopt;
    map.coarse = std::move(coarse);
    patch = std::move(fine);
    return map;
}

}  // namespace

CoarsePatch coarsen_patch(const Patch& fine, std::size_t triangles) {
    std::vector<bool> border = inner_vertices(fine);
    border.flip();
    CoarsePatch result;
    result.collapsed = collapse_edges(fine.points, fine.triangles, triangles, std::move(border));
    Patch& patch = result.patch;
    std::vector<std::uint32_t> number(fine.points.size(), not_in_mesh);
    for (Triangle t : result.collapsed.triangles) {
        for (std::uint32_t& v : t) {
            if (number[v] == not_in_mesh) {
                number[v] = static_cast<std::uint32_t>(patch.points.size());
                patch.points.push_back(fine.points[v]);
                patch.origins.push_back(fine.origins[v]);
                result.fine_vertex.push_back(v);
            }
            v = number[v];
        }
        patch.triangles.push_back(t);
    }
    for (const std::uint32_t t : result.collapsed.which) patch.faces.push_back(fine.faces[t]);
    patch.neighbours = connect_by_vertices(patch.triangles).neighbours;
    std::vector<HalfEdge> border_from(patch.points.size(), 0);
    for (HalfEdge h = 0; h < 3 * patch.triangles.size(); ++h)
        if (patch.on_border(h)) border_from[patch.start(h)] = h;
    auto& loop = patch.loops.emplace_back();
    for (const HalfEdge h : fine.loops[0]) loop.push_back(border_from[number[fine.start(h)]]);
    CollapsedMesh& way_back = result.collapsed;
    way_back.triangles = {};
    way_back.which = {};
    way_back.heir = {};
    way_back.collapses.shrink_to_fit();
    way_back.ring.shrink_to_fit();
    return result;
}

std::optional<std::vector<Vec2d>> carry_to_fine(const Patch& fine, const CoarsePatch& coarse,
                                                std::span<const Vec2d> coarse_uv) {
    std::vector<Vec2d> uv(fine.points.size());
    for (std::size_t v = 0; v < coarse.fine_vertex.size(); ++v)
        uv[coarse.fine_vertex[v]] = coarse_uv[v];
    const auto& collapses = coarse.collapsed.collapses;
    for (auto collapse = collapses.rbegin(); collapse != collapses.rend(); ++collapse) {
        const Ring ring{std::span(coarse.collapsed.ring).subspan(collapse->first, collapse->count),
                        uv};
        Vec2d q = mean_value(fine, collapse->vertex, ring);
        if (!ring.sees(q)) {
            const auto other = near_first(ring);
            if (!other) return std::nullopt;
            q = *other;
        }
        uv[collapse->vertex] = q;
    }
    return uv;
}

std::optional<RectangleMap> map_patch(Patch& patch, const DescentOptions& options) {
    return patch.triangles.size() > largest_patch ? map_coarsely(patch, options)
                                                  : map_onto_rectangle(patch, options);
}

void fit_map(const Patch& patch, RectangleMap& map, const DescentOptions& options) {
    if (!map.coarse) {
        descend(patch, map, options);
        return;
    }
    CoarseMap coarse = *map.coarse;
    fit_map(coarse.level.patch, coarse.map, options);
    carry_map(patch, coarse, map);
}

}  // namespace burl
