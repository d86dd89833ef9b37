// Mapping in parallel: a region is a task, and so is every piece it is halved into. Tasks share
// nothing but the mesh.
#include "atlas/patch/maps.h"

#include <algorithm>
#include <limits>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "atlas/chart/coarse_map.h"
#include "atlas/patch/cut.h"

namespace burl {
namespace {

constexpr double planar_at_most = 1.6;     ///< D up to which a projection may be kept
constexpr double planar_at_once = 1.05;    ///< D up to which a projection is kept untried
constexpr double rectangle_better = 0.97;  ///< ratio to the planar D below which a map is preferred
constexpr double sock_better = 0.97;       ///< ratio to the uncut D below which a slit is preferred

void add(PatchMapNotes& sum, const PatchMapNotes& n) {
    sum.tubes_slit += n.tubes_slit;
    sum.socks_slit += n.socks_slit;
    sum.holes_closed += n.holes_closed;
    sum.regions_halved += n.regions_halved;
    sum.planar_patches += n.planar_patches;
    sum.extra_vertices += n.extra_vertices;
}

/// Maps regions, halving those that stretch too much.
class RegionMapper {
  public:
    RegionMapper(const Mesh& mesh, const Connectivity& connectivity, double mean_area,
                 const PatchMapOptions& options)
        : mesh_(mesh),
          connectivity_(connectivity),
          mean_area_(mean_area),
          options_(options),
          local_([&mesh] { return std::vector<std::int32_t>(mesh.triangles.size(), -1); }) {}

    PatchMaps map_all(const Regions& regions) {
        std::vector<PatchMaps> by_region(regions.size());
        tbb::parallel_for(std::size_t(0), regions.size(),
                          [&](std::size_t i) { by_region[i] = map_region(regions[i]); });
        PatchMaps result;
        for (PatchMaps& maps : by_region) {
            std::move(maps.patches.begin(), maps.patches.end(), std::back_inserter(result.patches));
            result.unmapped.insert(result.unmapped.end(), maps.unmapped.begin(),
                                   maps.unmapped.end());
            add(result.notes, maps.notes);
        }
        return result;
    }

  private:
    PatchMaps map_region(const std::vector<std::uint32_t>& faces) {
        PatchMaps result;
        if (options_.stop.stop_requested()) {
            result.unmapped = faces;
            return result;
        }
        const Regions pieces = map_or_divide(faces, result);
        if (pieces.empty()) return result;
        PatchMaps of_pieces = map_all(pieces);
        add(of_pieces.notes, result.notes);
        return of_pieces;
    }

    /// Maps the faces into `result`, or returns the pieces to map instead.
    Regions map_or_divide(const std::vector<std::uint32_t>& faces, PatchMaps& result) {
        std::vector<std::int32_t>& local = local_.local();
        Patch patch = extract_patch(mesh_, connectivity_, faces, local);
        Regions components = component_faces(patch);
        if (components.size() > 1) return components;
        const double limit = most_distortion(area_of(patch), faces.size());
        auto planar = map_planar(patch);
        const double planar_d = planar ? planar->stretch.distortion() : 1e300;
        if (planar_d <= planar_at_once) return keep(std::move(patch), std::move(*planar), result);
        std::optional<RectangleMap> map;
        Patch mapped = planar ? patch : std::move(patch);
        PatchMapNotes notes;
        if (const auto cuts = cut_to_disk(mapped, connectivity_)) {
            notes.holes_closed = cuts->holes_closed;
            notes.tubes_slit = cuts->tubes_slit;
            map = map_disk(mapped, faces, limit, notes);
        }
        const double d = map ? map->stretch.distortion() : 1e300;
        if (planar_d <= planar_at_most && !(d < rectangle_better * planar_d))
            return keep(std::move(patch), std::move(*planar), result);
        if (map && d <= options_.tolerance * limit) {
            add(result.notes, notes);
            return keep(std::move(mapped), std::move(*map), result);
        }
        if (faces.size() > 1) {
            ++result.notes.regions_halved;
            return bisect_region(mesh_, connectivity_, faces, local);
        }
        if (planar) return keep(std::move(patch), std::move(*planar), result);
        result.unmapped.insert(result.unmapped.end(), faces.begin(), faces.end());
        return {};
    }

    std::optional<RectangleMap> map_wanted(Patch& patch, double limit) const {
        return map_patch(patch, {.least_gain = options_.least_gain, .wanted = limit});
    }

    /// The map of a disk. Where it stretches too much and nothing was closed or slit, `patch` is
    /// extracted from the faces again and slit like a sock, and kept so if that lowers the
    /// distortion.
    std::optional<RectangleMap> map_disk(Patch& patch, const std::vector<std::uint32_t>& faces,
                                         double limit, PatchMapNotes& notes) {
        auto map = map_wanted(patch, options_.tolerance * limit);
        if (map) notes.extra_vertices = map->extra_vertices;
        const double d = map ? map->stretch.distortion() : 1e300;
        if (d <= limit || notes.holes_closed + notes.tubes_slit > 0) return map;
        Patch slit = extract_patch(mesh_, connectivity_, faces, local_.local());
        if (!slit_sock(slit)) return map;
        const double wanted = std::min(options_.tolerance * limit, sock_better * d);
        auto slit_map = map_wanted(slit, wanted);
        if (!slit_map || slit_map->stretch.distortion() > wanted) return map;
        notes.socks_slit = 1;
        notes.extra_vertices = slit_map->extra_vertices;
        patch = std::move(slit);
        return slit_map;
    }

    /// The limit of D for a patch: small patches are not worth halving unless they stretch so much
    /// that they waste the share of a whole one.
    double most_distortion(double area, std::size_t faces) const {
        if (faces <= 2) return std::numeric_limits<double>::infinity();
        if (!(area < 0.25 * mean_area_)) return options_.most_distortion;
        return std::max(options_.most_distortion, mean_area_ / area);
    }

    static Regions keep(Patch patch, PlanarMap map, PatchMaps& result) {
        ++result.notes.planar_patches;
        MappedPatch& mapped = result.patches.emplace_back();
        mapped.patch = std::move(patch);
        mapped.uv = map.uv;
        mapped.stretch = map.stretch;
        mapped.planar = std::move(map);
        return {};
    }

    static Regions keep(Patch patch, RectangleMap map, PatchMaps& result) {
        MappedPatch& mapped = result.patches.emplace_back();
        mapped.patch = std::move(patch);
        if (map.coarse) mapped.patch.neighbours = {};
        mapped.uv = std::move(map.uv);
        mapped.stretch = map.stretch;
        mapped.rectangle = std::move(map);
        return {};
    }

    const Mesh& mesh_;
    const Connectivity& connectivity_;
    double mean_area_;
    PatchMapOptions options_;
    tbb::enumerable_thread_specific<std::vector<std::int32_t>> local_;
};

}  // namespace

PatchMaps map_regions(const Mesh& mesh, const Connectivity& connectivity, const Regions& regions,
                      const PatchMapOptions& options) {
    double area = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) area += triangle_area(mesh, t);
    PatchMaps result =
        RegionMapper(mesh, connectivity, area / options.patches, options).map_all(regions);
    std::sort(result.unmapped.begin(), result.unmapped.end());
    return result;
}

}  // namespace burl
