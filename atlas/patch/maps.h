#pragma once
// From regions of the mesh to mapped patches: what is flat is projected, what is a disk is mapped
// onto a rectangle, tubes and socks are slit and holes closed first, and what still stretches too
// much is halved and tried again. What no map is found for is listed, never forced: an unmapped
// patch with a guessed stretch would spoil the texel budget of all others.
#include <optional>
#include <stop_token>

#include "atlas/patch/partition.h"
#include "atlas/patch/patch.h"
#include "atlas/patch/planar_map.h"
#include "atlas/patch/rectangle_map.h"

namespace burl {

struct MappedPatch {
    Patch patch;            ///< where it was mapped coarsely, of many triangles: no neighbours
    std::vector<Vec2d> uv;  ///< per vertex, in the unit square
    Stretch stretch;
    /// One of the two: how uv came about (the rectangle's own are moved there).
    std::optional<RectangleMap> rectangle;
    std::optional<PlanarMap> planar;
};

struct PatchMapOptions {
    std::uint32_t patches = 6;     ///< as asked of the partition: sets what counts as small
    double most_distortion = 1.4;  ///< D above this is slit or halved
    /// D up to this times that is accepted where a slit does not help either.
    double tolerance = 1.0;
    /// Descents stop where they gain less than this share of D in an iteration: 0.003 does for
    /// judging a partition, whose maps are fitted to their blocks later anyway.
    double least_gain = 1e-4;
    /// Once it is asked for, what is not mapped yet is left unmapped.
    std::stop_token stop{};
};

/// What mapping did; counts are printed where they are not zero.
struct PatchMapNotes {
    std::uint32_t tubes_slit = 0, socks_slit = 0, holes_closed = 0, regions_halved = 0;
    std::uint32_t planar_patches = 0, extra_vertices = 0;
};

struct PatchMaps {
    std::vector<MappedPatch> patches;     ///< in order of the regions, halves in place
    std::vector<std::uint32_t> unmapped;  ///< triangles no map was found for, ascending
    PatchMapNotes notes;
};

/// Every triangle of the regions is in one patch or unmapped. Regions and the pieces they are
/// halved into are mapped in parallel; the result does not depend on the number of threads.
PatchMaps map_regions(const Mesh& mesh, const Connectivity& connectivity, const Regions& regions,
                      const PatchMapOptions& options = {});

}  // namespace burl
