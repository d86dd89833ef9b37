#include "atlas/patch_atlas.h"

#include <algorithm>
#include <array>
#include <unordered_map>

#include <tbb/parallel_for.h>

namespace burl {
namespace {

struct Try {
    PartitionOptions partition;
    double most_distortion = 1.4;
};

/// Numbers of patches, seeds and limits that do well on different meshes.
constexpr std::array<Try, 6> tries{
    {{{6, 1}, 1.4}, {{4, 1}, 1.3}, {{8, 1}, 1.4}, {{6, 2}, 1.3}, {{8, 3}, 1.3}, {{12, 1}, 1.5}}};
constexpr std::array<double, 2> crease_degrees{30.0, 15.0};
constexpr int refit_iterations = 10;

struct Candidate {
    PatchMaps maps;
    PatchLayout layout;
    double cost = std::numeric_limits<double>::infinity();
};

PatchDemand demand_of(const MappedPatch& mapped) {
    PatchDemand demand;
    demand.stretch = mapped.stretch;
    for (std::size_t t = 0; t < mapped.patch.triangles.size(); ++t) {
        if (mapped.patch.faces[t] == not_in_mesh) continue;
        const double area = area_of(mapped.patch, t);
        demand.area += area;
        for (const std::uint32_t v : mapped.patch.triangles[t])
            demand.centre += area / 3.0 * mapped.patch.points[v];
    }
    if (demand.area > 0.0) demand.centre /= demand.area;
    return demand;
}

std::uint32_t wanted_gutter(std::uint32_t size) {
    return std::max(size / 128, 1u);
}

Candidate candidate_of(PatchMaps maps, std::uint32_t size) {
    Candidate candidate;
    std::vector<PatchDemand> demands;
    for (const MappedPatch& mapped : maps.patches) demands.push_back(demand_of(mapped));
    candidate.maps = std::move(maps);
    auto layout =
        layout_patches(demands, {.size = size, .gutter = wanted_gutter(size), .tries = 8});
    if (!layout) return candidate;
    candidate.cost = layout->predicted_stretch * (1.0 + 0.002 * double(demands.size())) *
                     (layout->gutter < wanted_gutter(size) ? 1.5 : 1.0);
    candidate.layout = std::move(*layout);
    return candidate;
}

/// Creases are worth a try where they divide the surface into some large parts.
bool divides_well(const Mesh& mesh, const Regions& regions) {
    double all = 0.0, largest = 0.0;
    std::vector<double> areas;
    for (const auto& region : regions) {
        double area = 0.0;
        for (const std::uint32_t face : region) area += triangle_area(mesh, face);
        areas.push_back(area);
        all += area;
        largest = std::max(largest, area);
    }
    return largest <= 0.6 * all &&
           std::count_if(areas.begin(), areas.end(), [&](double a) { return a > 0.02 * all; }) >= 4;
}

Candidate best_candidate(const Mesh& mesh, const Connectivity& connectivity,
                         const AtlasOptions& options, int& looked_at) {
    Candidate best;
    const auto consider = [&](const Regions& regions, const Try& attempt) {
        ++looked_at;
        Candidate next =
            candidate_of(map_regions(mesh, connectivity, regions,
                                     {attempt.partition.patches, attempt.most_distortion}),
                         options.size);
        if (next.cost < best.cost || looked_at == 1) best = std::move(next);
    };
    for (int i = 0; i < std::clamp(options.tries, 1, int(tries.size())); ++i) {
        const Try& attempt = tries[std::size_t(i)];
        consider(partition_mesh(mesh, connectivity, attempt.partition), attempt);
    }
    for (const double degrees : crease_degrees) {
        const Regions regions = crease_regions(mesh, connectivity, degrees, tries[0].partition);
        if (divides_well(mesh, regions)) consider(regions, tries[0]);
    }
    return best;
}

void refit(Candidate& candidate) {
    tbb::parallel_for(std::size_t(0), candidate.maps.patches.size(), [&](std::size_t i) {
        MappedPatch& mapped = candidate.maps.patches[i];
        if (!mapped.rectangle) return;
        descend(mapped.patch, *mapped.rectangle,
                {.iterations = refit_iterations, .aspect = candidate.layout.blocks[i].aspect()});
        mapped.uv = mapped.rectangle->uv;
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
    std::unordered_map<std::uint32_t, Vec2d> place_of_point;
    for (std::size_t t = 0; t < count; ++t) {
        const std::uint32_t p = refined.patch[t];
        if (p == not_in_mesh) continue;
        atlas.charts[t] = p;
        const MappedPatch& mapped = result.maps.patches[p];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex = mapped.patch.triangles[refined.in_patch[t]][k];
            atlas.corners[t][k] = result.layout.blocks[p].place(mapped.uv[vertex]);
            place_of_point.emplace(refined.mesh.triangles[t][k], atlas.corners[t][k]);
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
                                            const AtlasOptions& options) {
    PatchAtlas result;
    Candidate best = best_candidate(mesh, connectivity, options, result.candidates);
    if (!std::isfinite(best.cost)) return std::nullopt;
    refit(best);
    result.maps = std::move(best.maps);
    result.layout = std::move(best.layout);
    result.refined = refine_mesh(mesh, result.maps);
    result.atlas.options = options;
    result.atlas.notes.texels_total = std::uint64_t{options.size} * options.size;
    place_corners(result);
    return result;
}

}  // namespace burl
