#include "atlas/patch_atlas.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <tbb/parallel_for.h>

#include "atlas/coarse_map.h"
#include "atlas/patch_candidates.h"
#include "atlas/patch_frame.h"

namespace burl {
namespace {

constexpr int refit_iterations = 20;
constexpr double refit_gain = 1e-4;  ///< relative, per iteration: less is not worth another

/// Descends on for the proportions that the blocks really got.
void refit(PatchCandidate& candidate, const std::stop_token& stop) {
    tbb::parallel_for(std::size_t(0), candidate.maps.patches.size(), [&](std::size_t i) {
        MappedPatch& mapped = candidate.maps.patches[i];
        if (!mapped.rectangle || stop.stop_requested()) return;
        fit_map(mapped.patch, *mapped.rectangle,
                {.iterations = refit_iterations,
                 .aspect = candidate.layout.blocks[i].aspect(),
                 .least_gain = refit_gain});
        mapped.rectangle->coarse.reset();
        mapped.uv = std::move(mapped.rectangle->uv);
        mapped.stretch = mapped.rectangle->stretch;
    });
}

/// Places the refined triangles' corners; those without a patch on a point that has a place.
void place_corners(PatchAtlas& result) {
    const RefinedMesh& refined = result.refined;
    const std::size_t count = refined.mesh.triangles.size();
    Atlas& atlas = result.atlas;
    atlas.corners.assign(count, {Vec2d(0.5), Vec2d(0.5), Vec2d(0.5)});
    atlas.charts.assign(count, 0);
    atlas.chart_count = static_cast<std::uint32_t>(result.maps.patches.size());
    const auto lost = std::size_t(std::ranges::count(refined.patch, not_in_mesh));
    std::unordered_map<std::uint32_t, Vec2d> place_of_point;
    for (std::size_t t = 0; t < count; ++t) {
        const std::uint32_t p = refined.patch[t];
        if (p == not_in_mesh) continue;
        atlas.charts[t] = p;
        const MappedPatch& mapped = result.maps.patches[p];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex = mapped.patch.triangles[refined.in_patch[t]][k];
            atlas.corners[t][k] = result.layout.blocks[p].place(mapped.uv[vertex]);
            if (lost > 0) place_of_point.emplace(refined.mesh.triangles[t][k], atlas.corners[t][k]);
        }
    }
    for (std::size_t t = 0; t < count; ++t) {
        if (refined.patch[t] != not_in_mesh) continue;
        atlas.charts[t] = atlas.chart_count++;
        const auto place = place_of_point.find(refined.mesh.triangles[t][0]);
        if (place != place_of_point.end()) atlas.corners[t].fill(place->second);
    }
}

}  // namespace

std::optional<PatchAtlas> build_patch_atlas(const Mesh& mesh, const Connectivity& connectivity,
                                            const AtlasOptions& options,
                                            const std::stop_token& stop) {
    PatchAtlas result;
    PatchCandidate best =
        best_candidate(in_unit_frame(mesh), connectivity, options.size, options.tries, stop);
    if (stop.stop_requested() || !std::isfinite(best.cost)) return std::nullopt;
    result.candidates = best.looked_at;
    refit(best, stop);
    if (stop.stop_requested()) return std::nullopt;
    to_mesh_frame(best.maps, mesh);
    result.maps = std::move(best.maps);
    result.layout = std::move(best.layout);
    result.refined = refine_mesh(mesh, result.maps);
    result.atlas.options = options;
    result.atlas.notes.texels_total = std::uint64_t{options.size} * options.size;
    place_corners(result);
    return result;
}

}  // namespace burl
