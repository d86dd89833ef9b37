#pragma once
// Mapping of the mesh's regions: flat regions are projected, disks are mapped onto a rectangle,
// tubes and socks are slit and holes closed first, and a region that still stretches too much is
// halved and tried again. Triangles for which no map is found are listed, never forced: an unmapped
// patch with a guessed stretch would spoil the texel budget of all others.
#include <optional>
#include <stop_token>

#include "atlas/chart/patch.h"
#include "atlas/chart/planar_map.h"
#include "atlas/chart/rectangle_map.h"
#include "atlas/patch/partition.h"

namespace burl {

/// A patch and its map from the unit square.
struct MappedPatch {
    Patch patch;            ///< patch; its neighbours are dropped if it was mapped coarsely
    std::vector<Vec2d> uv;  ///< place of each vertex in the unit square
    Stretch stretch;
    /// The origin of uv: exactly one of the two is set (the places of `rectangle` are moved to uv).
    std::optional<RectangleMap> rectangle;
    std::optional<PlanarMap> planar;
};

/// Limits of distortion and effort of mapping.
struct PatchMapOptions {
    std::uint32_t patches = 6;     ///< number asked of the partition; defines a small patch
    double most_distortion = 1.4;  ///< limit of D, above which a patch is slit or halved
    /// Factor on most_distortion up to which D is accepted where a slit does not help either.
    double tolerance = 1.0;
    /// Relative gain of D in an iteration below which descents stop: 0.003 suffices for judging a
    /// partition, whose maps are fitted to their blocks later anyway.
    double least_gain = 1e-4;
    /// Once a stop is requested, regions that are not mapped yet are left unmapped.
    std::stop_token stop{};
};

/// Counts of cuts, closed holes, halvings, projections and added vertices; printed where they are
/// not zero.
struct PatchMapNotes {
    std::uint32_t tubes_slit = 0, socks_slit = 0, holes_closed = 0, regions_halved = 0;
    std::uint32_t planar_patches = 0, extra_vertices = 0;
};

/// The mapped patches of all regions.
struct PatchMaps {
    std::vector<MappedPatch> patches;     ///< patches in the order of the regions, halves in place
    std::vector<std::uint32_t> unmapped;  ///< triangles for which no map was found, ascending
    PatchMapNotes notes;
};

/// The maps of all regions; every triangle is in one patch or unmapped. Regions and the pieces they
/// are halved into are mapped in parallel; the result does not depend on the number of threads.
PatchMaps map_regions(const Mesh& mesh, const Connectivity& connectivity, const Regions& regions,
                      const PatchMapOptions& options = {});

}  // namespace burl
