// Judging of candidates: they share nothing but the mesh and are judged in parallel; the first of
// equally good ones wins.
#include "atlas/patch/candidates.h"

#include <algorithm>
#include <array>

#include <tbb/parallel_for.h>

#include "atlas/chart/coarse_mesh.h"

namespace burl {
namespace {

/// One partition to judge, with the limit of the distortion D beyond which its patches are slit or
/// halved (PatchMapOptions::most_distortion).
struct Try {
    PartitionOptions partition;
    double most_distortion = 1.4;
};

/// The partitions in the order in which `tries` takes them, as {{number of patches, seed of METIS},
/// limit of D}; docs/reference/patch-atlas.md has the cost of each on eight meshes.
constexpr std::array<Try, 6> tries_in_order{
    {{{6, 1}, 1.4}, {{5, 4}, 1.3}, {{6, 2}, 1.3}, {{4, 1}, 1.3}, {{8, 1}, 1.4}, {{4, 2}, 1.5}}};
/// Angles between normals, in degrees, at which the mesh is divided along its creases.
constexpr std::array<double, 2> crease_degrees{30.0, 15.0};

constexpr double judging_gain = 0.003;  ///< PatchMapOptions::least_gain while judging
/// Relative cost of each patch (0.5 %): the predicted stretch does not see the patches' borders,
/// which blur the upper MIP levels.
constexpr double per_patch = 0.005;
/// Number of trees that layout_patches() tries for a division when it is judged, and for each of
/// the finalists.
constexpr int judging_layouts = 16, last_layouts = 96;
/// Number of finalists: the divisions of least cost, which are laid out again with `last_layouts`
/// trees and, where they were judged on a coarse mesh, first carried over to the fine one and
/// mapped there.
constexpr std::size_t last_choices = 2;
/// Number of triangles above which a mesh is judged by a coarse copy of it, and the copy's number
/// of triangles.
constexpr std::size_t judged_as_it_is = 80000, judged_triangles = 24000;
/// Factors on the limit of D for a division that is carried over from the coarse mesh:
/// `carried_slack` always, as the fine mesh's detail costs some distortion, and `detail_tolerance`
/// (PatchMapOptions::tolerance) as well where the mesh has more than `much_detail` times the coarse
/// one's triangles. So much detail stretches a map whatever the division, and halving patches would
/// not help.
constexpr double carried_slack = 1.1, detail_tolerance = 1.25;
constexpr std::size_t much_detail = 16;  ///< ratio of fine to coarse triangles

/// A division to judge: a partition, or regions along creases.
struct Plan {
    Try attempt;
    Regions creases;  ///< regions along creases; empty for a partition
};

/// A judged division with the partition that it came from.
struct Judged {
    PatchCandidate candidate;
    Try attempt;
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

void lay_out(PatchCandidate& candidate, std::uint32_t size, int layouts) {
    std::vector<PatchDemand> demands;
    for (const MappedPatch& mapped : candidate.maps.patches) demands.push_back(demand_of(mapped));
    auto layout = layout_patches(demands, {.size = size, .tries = layouts});
    candidate.cost = std::numeric_limits<double>::infinity();
    if (!layout) return;
    candidate.cost = layout->cost() * (1.0 + per_patch * double(demands.size()));
    candidate.layout = std::move(*layout);
}

/// Whether regions along creases are worth judging: the largest has at most 60 % of the area, and
/// at least four have more than 2 % each.
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

PatchMapOptions judging_options(const Try& attempt, const std::stop_token& stop) {
    return {.patches = attempt.partition.patches,
            .most_distortion = attempt.most_distortion,
            .least_gain = judging_gain,
            .stop = stop};
}

/// The divisions to judge: the first `tries` partitions, then those along creases that divide the
/// mesh well and differ from one another.
std::vector<Plan> plans(const Mesh& mesh, const Connectivity& connectivity, int tries) {
    std::vector<Plan> result;
    for (int i = 0; i < std::clamp(tries, 1, int(tries_in_order.size())); ++i)
        result.push_back({tries_in_order[std::size_t(i)], {}});
    for (const double degrees : crease_degrees) {
        Regions creases = crease_regions(mesh, connectivity, degrees, tries_in_order[0].partition);
        if (divides_well(mesh, creases) && creases != result.back().creases)
            result.push_back({tries_in_order[0], std::move(creases)});
    }
    return result;
}

PatchCandidate judge(const Mesh& mesh, const Connectivity& connectivity, const Plan& plan,
                     std::uint32_t size, const std::stop_token& stop) {
    PatchCandidate candidate;
    if (stop.stop_requested()) return candidate;
    candidate.maps = map_regions(mesh, connectivity,
                                 plan.creases.empty()
                                     ? partition_mesh(mesh, connectivity, plan.attempt.partition)
                                     : plan.creases,
                                 judging_options(plan.attempt, stop));
    lay_out(candidate, size, judging_layouts);
    return candidate;
}

/// Up to `most` divisions of least cost, best first.
std::vector<Judged> best_of_all(const Mesh& mesh, const Connectivity& connectivity,
                                std::uint32_t size, int tries, std::size_t most,
                                const std::stop_token& stop) {
    const std::vector<Plan> all = plans(mesh, connectivity, tries);
    std::vector<Judged> judged(all.size());
    tbb::parallel_for(std::size_t(0), all.size(), [&](std::size_t i) {
        judged[i] = {judge(mesh, connectivity, all[i], size, stop), all[i].attempt};
        judged[i].candidate.looked_at = static_cast<int>(all.size());
    });
    std::stable_sort(judged.begin(), judged.end(), [](const Judged& a, const Judged& b) {
        return a.candidate.cost < b.candidate.cost;
    });
    judged.resize(std::min(judged.size(), most));
    return judged;
}

/// The fine mesh's maps for a division that was judged on the coarse one.
PatchMaps carry_over(const Mesh& mesh, const Connectivity& connectivity, const CoarseMesh& coarse,
                     const PatchCandidate& best, const Try& attempt, const std::stop_token& stop) {
    const auto& patches = best.maps.patches;
    std::vector<std::uint32_t> patch_of(coarse.mesh.triangles.size(),
                                        static_cast<std::uint32_t>(patches.size()));
    for (std::uint32_t p = 0; p < patches.size(); ++p)
        for (const std::uint32_t face : patches[p].patch.faces)
            if (face != not_in_mesh) patch_of[face] = p;
    std::vector<std::uint32_t> labels;
    for (const std::uint32_t face : coarse.nearest) labels.push_back(patch_of[face]);
    PatchMapOptions options = judging_options(attempt, stop);
    options.most_distortion *= carried_slack;
    if (mesh.triangles.size() > much_detail * coarse.mesh.triangles.size())
        options.tolerance = detail_tolerance;
    return map_regions(mesh, connectivity, regions_of_labels(mesh, connectivity, std::move(labels)),
                       options);
}

/// The finalists: the best divisions of the mesh itself, or those of a coarse mesh carried over.
std::vector<PatchCandidate> best_divisions(const Mesh& mesh, const Connectivity& connectivity,
                                           std::uint32_t size, int tries,
                                           const std::stop_token& stop) {
    const std::size_t most = std::min<std::size_t>(static_cast<std::size_t>(tries), last_choices);
    std::optional<CoarseMesh> coarse;
    if (mesh.triangles.size() > judged_as_it_is)
        coarse = coarsen(mesh, connectivity, judged_triangles);
    const bool judge_coarse = coarse && 2 * coarse->mesh.triangles.size() <= mesh.triangles.size();
    std::vector<Judged> best =
        judge_coarse ? best_of_all(coarse->mesh, coarse->connectivity, size, tries, most, stop)
                     : best_of_all(mesh, connectivity, size, tries, most, stop);
    std::vector<PatchCandidate> result(best.size());
    // Carried over one after the other, so that fewer patches are in memory at a time.
    for (std::size_t i = 0; i < best.size(); ++i) {
        result[i] = std::move(best[i].candidate);
        if (!judge_coarse || stop.stop_requested()) continue;
        PatchMaps maps = carry_over(mesh, connectivity, *coarse, result[i], best[i].attempt, stop);
        result[i].maps = std::move(maps);
    }
    return result;
}

}  // namespace

PatchCandidate best_candidate(const Mesh& mesh, const Connectivity& connectivity,
                              std::uint32_t size, int tries, const std::stop_token& stop) {
    std::vector<PatchCandidate> best =
        best_divisions(mesh, connectivity, size, std::max(tries, 1), stop);
    if (stop.stop_requested()) return {};
    tbb::parallel_for(std::size_t(0), best.size(),
                      [&](std::size_t i) { lay_out(best[i], size, last_layouts); });
    return std::move(*std::min_element(
        best.begin(), best.end(),
        [](const PatchCandidate& a, const PatchCandidate& b) { return a.cost < b.cost; }));
}

}  // namespace burl
