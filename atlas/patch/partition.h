#pragma once
// Division of the mesh into connected regions that are good candidates for patches: by the dual
// graph's partition, or along creases alone (what a CAD model's own faces are). Borders are tidied,
// because a ragged border is stretched most, and fragments are given to the neighbour they share
// most border with. Regions need not be disks yet (patch_maps).
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/mesh/connectivity.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// Lists of mesh triangles, ascending; together every triangle exactly once.
using Regions = std::vector<std::vector<std::uint32_t>>;

struct PartitionOptions {
    std::uint32_t patches = 6;  ///< how many to ask for; fragments and shells change the number
    int seed = 1;
    /// Regions smaller than this share of (mesh area / patches) are merged into a neighbour.
    double least_share = 0.25;
};

/// Connected regions of about equal area. Pure and deterministic.
Regions partition_mesh(const Mesh& mesh, const Connectivity& connectivity,
                       const PartitionOptions& options = {});

/// Regions flooded over edges whose two faces meet at less than `degrees`, small ones merged.
Regions crease_regions(const Mesh& mesh, const Connectivity& connectivity, double degrees,
                       const PartitionOptions& options = {});

/// Connected regions of the labels, one per triangle: ears flipped, and of each label's pieces all
/// but the largest given to the neighbour they share most border with, if they have any.
Regions regions_of_labels(const Mesh& mesh, const Connectivity& connectivity,
                          std::vector<std::uint32_t> labels);

/// Divides one connected region in two (or more connected pieces): along the dual graph, or across
/// the longest extent where there are few triangles. Never returns `faces` undivided unless it is
/// a single triangle. `local` as in dual_graph.
Regions bisect_region(const Mesh& mesh, const Connectivity& connectivity,
                      std::span<const std::uint32_t> faces, std::vector<std::int32_t>& local);

}  // namespace burl
