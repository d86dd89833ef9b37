// A region is mapped by one task from start to end; its pieces, when it is halved, are mapped by
// the same task. Tasks share nothing but the mesh.
#include "atlas/patch_maps.h"

#include <algorithm>
#include <numeric>

#include <tbb/parallel_for.h>

#include "atlas/patch_cut.h"

namespace burl {
namespace {

constexpr double planar_at_most = 1.6;     ///< D up to which a projection is considered
constexpr double planar_at_once = 1.05;    ///< D up to which nothing else is tried
constexpr double rectangle_better = 0.97;  ///< what the other map must reach of the planar D
constexpr double sock_better = 0.97;       ///< what a slit must reach of the uncut D

void add(PatchMapNotes& sum, const PatchMapNotes& n) {
    sum.tubes_slit += n.tubes_slit;
    sum.socks_slit += n.socks_slit;
    sum.holes_closed += n.holes_closed;
    sum.regions_halved += n.regions_halved;
    sum.planar_patches += n.planar_patches;
    sum.extra_vertices += n.extra_vertices;
}

class RegionMapper {
  public:
    RegionMapper(const Mesh& mesh, const Connectivity& connectivity, double mean_area,
                 double most_distortion)
        : mesh_(mesh),
          connectivity_(connectivity),
          mean_area_(mean_area),
          most_distortion_(most_distortion),
          local_(mesh.triangles.size(), -1) {}

    PatchMaps run(const std::vector<std::uint32_t>& region) {
        std::vector<std::vector<std::uint32_t>> open{region};
        while (!open.empty()) {
            const auto faces = std::move(open.back());
            open.pop_back();
            Regions pieces = map_or_divide(faces);
            std::reverse(pieces.begin(), pieces.end());
            for (auto& piece : pieces) open.push_back(std::move(piece));
        }
        return std::move(result_);
    }

  private:
    /// Maps the faces, or returns the pieces to map instead.
    Regions map_or_divide(const std::vector<std::uint32_t>& faces) {
        Patch patch = extract_patch(mesh_, connectivity_, faces, local_);
        Regions components = component_faces(patch);
        if (components.size() > 1) return components;
        const double area = area_of(patch);
        auto planar = map_planar(patch);
        const double planar_d = planar ? planar->stretch.distortion() : 1e300;
        if (planar_d <= planar_at_once) return keep(std::move(patch), std::move(*planar));
        std::optional<RectangleMap> map;
        Patch mapped = patch;
        PatchMapNotes notes;
        if (make_disk(mapped, notes)) map = map_disk(mapped, area, notes);
        const double d = map ? map->stretch.distortion() : 1e300;
        if (planar_d <= planar_at_most && !(d < rectangle_better * planar_d))
            return keep(std::move(patch), std::move(*planar));
        if (map && acceptable(d, area, faces.size())) {
            add(result_.notes, notes);
            return keep(std::move(mapped), std::move(*map));
        }
        if (faces.size() > 1) {
            ++result_.notes.regions_halved;
            return bisect_region(mesh_, connectivity_, faces, local_);
        }
        if (planar) return keep(std::move(patch), std::move(*planar));
        result_.unmapped.insert(result_.unmapped.end(), faces.begin(), faces.end());
        return {};
    }

    /// Closes small holes and slits tubes; false if that does not make a disk.
    bool make_disk(Patch& patch, PatchMapNotes& notes) const {
        const PatchTopology topology = topology_of(patch);
        if (topology.handles > 0 || topology.loops == 0) return false;
        notes.holes_closed = fan_holes(patch, connectivity_);
        notes.tubes_slit = slit_tube(patch);
        return topology_of(patch).is_disk();
    }

    /// The map of a disk; where it stretches too much and the patch is still whole, with a slit.
    std::optional<RectangleMap> map_disk(Patch& patch, double area, PatchMapNotes& notes) const {
        const Patch whole = patch;
        auto map = map_onto_rectangle(patch);
        if (map) notes.extra_vertices = map->extra_vertices;
        const double d = map ? map->stretch.distortion() : 1e300;
        if (map && acceptable(d, area, whole.triangles.size())) return map;
        if (notes.holes_closed + notes.tubes_slit > 0) return map;
        Patch slit = whole;
        if (!slit_sock(slit)) return map;
        auto slit_map = map_onto_rectangle(slit);
        if (!slit_map) return map;
        const double slit_d = slit_map->stretch.distortion();
        if (slit_d > sock_better * d || !acceptable(slit_d, area, whole.triangles.size()))
            return map;
        notes.socks_slit = 1;
        notes.extra_vertices = slit_map->extra_vertices;
        patch = std::move(slit);
        return slit_map;
    }

    /// Small patches are not worth halving unless they stretch so much that they waste the share
    /// of a whole one.
    bool acceptable(double distortion, double area, std::size_t faces) const {
        return distortion <= most_distortion_ || faces <= 2 ||
               (area < 0.25 * mean_area_ && area * distortion < mean_area_);
    }

    Regions keep(Patch patch, PlanarMap map) {
        ++result_.notes.planar_patches;
        MappedPatch& kept = result_.patches.emplace_back();
        kept.patch = std::move(patch);
        kept.uv = map.uv;
        kept.stretch = map.stretch;
        kept.planar = std::move(map);
        return {};
    }

    Regions keep(Patch patch, RectangleMap map) {
        MappedPatch& kept = result_.patches.emplace_back();
        kept.patch = std::move(patch);
        kept.uv = map.uv;
        kept.stretch = map.stretch;
        kept.rectangle = std::move(map);
        return {};
    }

    const Mesh& mesh_;
    const Connectivity& connectivity_;
    double mean_area_, most_distortion_;
    std::vector<std::int32_t> local_;
    PatchMaps result_;
};

}  // namespace

PatchMaps map_regions(const Mesh& mesh, const Connectivity& connectivity, const Regions& regions,
                      const PatchMapOptions& options) {
    double area = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) area += triangle_area(mesh, t);
    std::vector<PatchMaps> by_region(regions.size());
    tbb::parallel_for(std::size_t(0), regions.size(), [&](std::size_t i) {
        by_region[i] =
            RegionMapper(mesh, connectivity, area / options.patches, options.most_distortion)
                .run(regions[i]);
    });
    PatchMaps result;
    for (PatchMaps& maps : by_region) {
        std::move(maps.patches.begin(), maps.patches.end(), std::back_inserter(result.patches));
        result.unmapped.insert(result.unmapped.end(), maps.unmapped.begin(), maps.unmapped.end());
        add(result.notes, maps.notes);
    }
    std::sort(result.unmapped.begin(), result.unmapped.end());
    return result;
}

}  // namespace burl
