// The steps of the patch atlas, in order, with their files; docs/reference/patch-atlas.md tells
// why.
// 1. in_unit_frame(): the mesh is moved into a unit box, so that its scale and place change
//    nothing; after step 5 to_mesh_frame() gives the maps the mesh's own positions.
// 2. candidates: several divisions are judged in parallel, for a large mesh on a coarse copy
//    (coarse_mesh, edge_collapse). Each division is a partition or follows creases (partition).
// 3. maps: every region becomes a patch with a map from the unit square. Flat ones are projected
//    (planar_map), others are cut to disks (cut) and mapped (rectangle_map: corner_search,
//    chord_split, laplacian, stretch, rectangle_descent), large ones by way of a coarse patch
//    (coarse_map, stretch_sweeps). A region that stretches too much is halved and mapped again.
// 4. layout: the patches get texels (budget) and rectangles in the texture (tree, a treemap); the
//    division of least cost is kept.
// 5. refit() below: the maps descend on for the proportions that their blocks really got.
// 6. refine: split chords are carried to the mesh that is exported; place_corners() below sets its
//    corners and charts in the texture. fit_patches() is steps 1 to 5, place_patches() step 6.
// 7. raster: every texel gets its solid point, by spans of affine maps, and gutters are filled.
#include "atlas/patch/atlas.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <tbb/parallel_for.h>

#include "atlas/chart/coarse_map.h"
#include "atlas/mesh/unit_frame.h"
#include "atlas/patch/candidates.h"

namespace burl {

namespace {

/// Sets the patch's points from their origins: mesh points, middles of two of them, and the
/// centroids of closed holes.
void place_vertices(Patch& patch, const Mesh& mesh) {
    const auto is_hub = [&](std::size_t v) { return patch.origins[v] == VertexOrigin{}; };
    for (std::size_t v = 0; v < patch.points.size(); ++v) {
        const VertexOrigin& origin = patch.origins[v];
        if (is_hub(v))
            patch.points[v] = Vec3d(0.0);
        else if (origin.a == origin.b)
            patch.points[v] = mesh.positions[origin.a];
        else
            patch.points[v] = 0.5 * mesh.positions[origin.a] + 0.5 * mesh.positions[origin.b];
    }
    std::vector<double> rim(patch.points.size(), 0.0);
    for (std::size_t t = 0; t < patch.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const Triangle& c = patch.triangles[t];
            if (!is_hub(c[k])) continue;
            patch.points[c[k]] += patch.points[c[(k + 1) % 3]] + patch.points[c[(k + 2) % 3]];
            rim[c[k]] += 2.0;
        }
    for (std::size_t v = 0; v < rim.size(); ++v)
        if (rim[v] > 0.0) patch.points[v] /= rim[v];
}

/// Projects a planar patch again into the rectangle round it along the map's directions. Where that
/// has no height, as for a triangle without area that only the unit frame's rounding gave some, the
/// map's places stay.
void project_anew(MappedPatch& mapped) {
    PlanarMap& plane = *mapped.planar;
    const Vec3d u = glm::normalize(plane.along_u), v = glm::normalize(plane.along_v);
    const Vec3d& first = mapped.patch.points[0];
    Vec2d low(0.0), high(0.0);
    std::vector<Vec2d> flat;
    for (const Vec3d& point : mapped.patch.points) {
        flat.emplace_back(glm::dot(point - first, u), glm::dot(point - first, v));
        low = glm::min(low, flat.back());
        high = glm::max(high, flat.back());
    }
    const Vec2d size = high - low;
    for (int axis = 0; axis < 2; ++axis) {
        if (!(size[axis] > 0.0)) continue;
        for (std::size_t i = 0; i < flat.size(); ++i)
            plane.uv[i][axis] = (flat[i][axis] - low[axis]) / size[axis];
    }
    plane.origin = first + low.x * u + low.y * v;
    plane.along_u = size.x * u;
    plane.along_v = size.y * v;
    mapped.uv = plane.uv;
}

void scale(Stretch& stretch, double side) {
    const double square = side * side;
    stretch.area *= square;
    stretch.x *= square * square;
    stretch.y *= square * square;
}

constexpr int refit_iterations = 20;
constexpr double refit_gain = 1e-4;  ///< relative gain per iteration, below which a descent ends
/// Weight of anisotropy beside stretch: samplers choose a level by the longer axis of a texel
/// (docs/lab/patch-atlas.md has other weights and energies).
constexpr double refit_anisotropy = 0.5;

/// Descends on every rectangle map of the candidate for the proportions that its block really got.
void refit(PatchCandidate& candidate, const std::stop_token& stop) {
    tbb::parallel_for(std::size_t(0), candidate.maps.patches.size(), [&](std::size_t i) {
        MappedPatch& mapped = candidate.maps.patches[i];
        if (!mapped.rectangle || stop.stop_requested()) return;
        mapped.rectangle->uv = std::move(mapped.uv);
        fit_map(mapped.patch, *mapped.rectangle,
                {.iterations = refit_iterations,
                 .aspect = candidate.layout.blocks[i].aspect(),
                 .least_gain = refit_gain,
                 .anisotropy = refit_anisotropy});
        mapped.rectangle->coarse.reset();
        mapped.uv = std::move(mapped.rectangle->uv);
        mapped.stretch = mapped.rectangle->stretch;
    });
}

/// Numbers of the patches' vertices as points of the refined mesh; hubs get the numbers behind the
/// points.
class PointNumbers {
  public:
    PointNumbers(const PatchMaps& maps, const Refinement& refinement) {
        for (const MappedPatch& mapped : maps.patches)
            points_.emplace_back(mapped.patch.points.size(), not_in_mesh);
        const std::vector<Triangle>& triangles = refinement.refined.mesh.triangles;
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            const std::uint32_t p = refinement.patch[t];
            if (p == not_in_mesh) continue;
            const Triangle& local = maps.patches[p].patch.triangles[refinement.in_patch[t]];
            for (std::size_t k = 0; k < 3; ++k) points_[p][local[k]] = triangles[t][k];
        }
        first_hub_ = next_ = std::uint32_t(refinement.refined.mesh.positions.size());
    }

    std::uint32_t of(const MappedPatch& mapped, std::size_t p, std::uint32_t vertex) {
        std::uint32_t& point = points_[p][vertex];
        if (point == not_in_mesh) point = mapped.patch.origins[vertex].a;
        if (point == not_in_mesh) point = next_++;
        return point;
    }
    std::uint32_t hubs() const { return next_ - first_hub_; }

  private:
    std::vector<std::vector<std::uint32_t>> points_;  ///< number of each patch's vertices
    std::uint32_t first_hub_ = 0, next_ = 0;
};

/// Three vertices of a planar patch that are far apart.
Triangle wide_triangle(const std::vector<Vec2d>& uv) {
    const auto farthest = [&](auto distance) {
        std::uint32_t best = 0;
        for (std::uint32_t v = 1; v < uv.size(); ++v)
            if (distance(uv[v]) > distance(uv[best])) best = v;
        return best;
    };
    const auto a = farthest([](const Vec2d& q) { return -q.x - q.y; });
    const auto b = farthest([&](const Vec2d& q) { return glm::distance(q, uv[a]); });
    const Vec2d line = uv[b] - uv[a];
    const auto c = farthest([&](const Vec2d& q) {
        const Vec2d to = q - uv[a];
        return std::abs(line.x * to.y - line.y * to.x);
    });
    return {a, b, c};
}

PlacedTriangle placed(const MappedPatch& mapped, std::size_t p, const PatchBlock& block,
                      const Triangle& vertices, PointNumbers& numbers) {
    PlacedTriangle triangle;
    for (std::size_t k = 0; k < 3; ++k) {
        triangle.points[k] = numbers.of(mapped, p, vertices[k]);
        triangle.places[k] = block.place(mapped.uv[vertices[k]]);
    }
    return triangle;
}

/// Sets the atlas's patches and its number of hubs.
void describe_patches(const PatchMaps& maps, const Refinement& refinement, PatchAtlas& result) {
    PointNumbers numbers(maps, refinement);
    result.patches.resize(maps.patches.size());
    for (std::size_t p = 0; p < maps.patches.size(); ++p) {
        const MappedPatch& mapped = maps.patches[p];
        const PatchBlock& block = result.layout.blocks[p];
        PlacedPatch& patch = result.patches[p];
        if (mapped.planar)
            patch.plane = placed(mapped, p, block, wide_triangle(mapped.uv), numbers);
        for (std::size_t t = 0; t < mapped.patch.triangles.size(); ++t)
            if (mapped.patch.faces[t] == not_in_mesh)
                patch.fans.push_back(placed(mapped, p, block, mapped.patch.triangles[t], numbers));
    }
    result.hubs = numbers.hubs();
    std::vector<std::uint32_t> first(maps.patches.size(), not_in_mesh);  // lowest in_patch so far
    for (std::uint32_t t = 0; t < refinement.patch.size(); ++t) {
        const std::uint32_t p = refinement.patch[t];
        if (p == not_in_mesh || refinement.in_patch[t] >= first[p]) continue;
        first[p] = refinement.in_patch[t];
        result.patches[p].triangle = t;
    }
}

/// Sets corners and charts of the refined triangles; a triangle without a patch lies at its first
/// point's place.
void place_corners(const PatchMaps& maps, const Refinement& refinement, PatchAtlas& result) {
    const std::vector<Triangle>& triangles = refinement.refined.mesh.triangles;
    const std::size_t count = triangles.size();
    Atlas& atlas = result.atlas;
    atlas.corners.assign(count, {Vec2d(0.5), Vec2d(0.5), Vec2d(0.5)});
    atlas.charts.assign(count, 0);
    atlas.chart_count = static_cast<std::uint32_t>(maps.patches.size());
    const auto lost = std::size_t(std::ranges::count(refinement.patch, not_in_mesh));
    std::unordered_map<std::uint32_t, Vec2d> place_of_point;
    for (std::size_t t = 0; t < count; ++t) {
        const std::uint32_t p = refinement.patch[t];
        if (p == not_in_mesh) continue;
        atlas.charts[t] = p;
        const MappedPatch& mapped = maps.patches[p];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex = mapped.patch.triangles[refinement.in_patch[t]][k];
            atlas.corners[t][k] = result.layout.blocks[p].place(mapped.uv[vertex]);
            if (lost > 0) place_of_point.emplace(triangles[t][k], atlas.corners[t][k]);
        }
    }
    for (std::size_t t = 0; t < count; ++t) {
        if (refinement.patch[t] != not_in_mesh) continue;
        atlas.charts[t] = atlas.chart_count++;
        const auto place = place_of_point.find(triangles[t][0]);
        if (place != place_of_point.end()) atlas.corners[t].fill(place->second);
    }
}

}  // namespace

std::optional<PatchCandidate> fit_patches(const Mesh& mesh, const Connectivity& connectivity,
                                          const AtlasOptions& options,
                                          const std::stop_token& stop) {
    PatchCandidate best =
        best_candidate(in_unit_frame(mesh), connectivity, options.size, options.tries, stop);
    if (stop.stop_requested() || !std::isfinite(best.cost)) return std::nullopt;
    refit(best, stop);
    if (stop.stop_requested()) return std::nullopt;
    to_mesh_frame(best.maps, mesh);
    return best;
}

PatchAtlas place_patches(const Mesh& mesh, const PatchCandidate& fitted,
                         const AtlasOptions& options) {
    PatchAtlas result;
    result.candidates = fitted.looked_at;
    result.notes = fitted.maps.notes;
    result.unmapped = fitted.maps.unmapped.size();
    result.layout = fitted.layout;
    Refinement refinement = refine_mesh(mesh, fitted.maps);
    result.atlas.options = options;
    result.atlas.notes.texels_total = std::uint64_t{options.size} * options.size;
    describe_patches(fitted.maps, refinement, result);
    place_corners(fitted.maps, refinement, result);
    result.refined = std::move(refinement.refined);
    return result;
}

std::optional<PatchAtlas> build_patch_atlas(const Mesh& mesh, const Connectivity& connectivity,
                                            const AtlasOptions& options,
                                            const std::stop_token& stop) {
    const std::optional<PatchCandidate> fitted = fit_patches(mesh, connectivity, options, stop);
    if (!fitted) return std::nullopt;
    return place_patches(mesh, *fitted, options);
}

void to_mesh_frame(PatchMaps& maps, const Mesh& mesh) {
    double side = bounding_box(mesh).longest_side();
    if (!(side > 0.0)) side = 1.0;
    for (MappedPatch& mapped : maps.patches) {
        place_vertices(mapped.patch, mesh);
        if (mapped.planar) {
            project_anew(mapped);
            scale(mapped.planar->stretch, side);
        }
        if (mapped.rectangle) scale(mapped.rectangle->stretch, side);
        scale(mapped.stretch, side);
    }
}

}  // namespace burl
