#pragma once
// Division of the mesh into connected regions that are good candidates for patches: by the dual
// graph's partition, or along creases alone (the faces of a CAD model). Borders are tidied, because
// a ragged border is stretched most, and each fragment is given to the neighbour with which it
// shares most border. Regions need not be disks yet (maps.h).
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/mesh/connectivity.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// Regions as ascending lists of mesh triangles; every triangle is in exactly one list.
using Regions = std::vector<std::vector<std::uint32_t>>;

/// Number of regions, seed and least size.
struct PartitionOptions {
    std::uint32_t patches = 6;  ///< number of regions asked for; fragments and shells change it
    int seed = 1;
    /// Smallest area of a region relative to (mesh area / patches); smaller ones are merged into a
    /// neighbour.
    double least_share = 0.25;
};

/// Connected regions of about equal area. Pure and deterministic.
Regions partition_mesh(const Mesh& mesh, const Connectivity& connectivity,
                       const PartitionOptions& options = {});

/// Regions flooded over edges whose two faces meet at less than `degrees`; small regions are
/// merged.
Regions crease_regions(const Mesh& mesh, const Connectivity& connectivity, double degrees,
                       const PartitionOptions& options = {});

/// Connected regions of the labels, one label per triangle: ears are flipped, and all components of
/// a label but the largest are given to the neighbour with which they share most border, if they
/// have any.
Regions regions_of_labels(const Mesh& mesh, const Connectivity& connectivity,
                          std::vector<std::uint32_t> labels);

/// Divides one connected region in two (or more components): along the dual graph, or across
/// the longest extent where there are few triangles. `faces` come back undivided only if they are a
/// single triangle. `local` is scratch memory of one entry per mesh triangle, -1 on entry and on
/// return.
Regions bisect_region(const Mesh& mesh, const Connectivity& connectivity,
                      std::span<const std::uint32_t> faces, std::vector<std::int32_t>& local);

}  // namespace burl
