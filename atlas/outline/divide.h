#pragma once
// Division of a mesh into charts with nearly isometric maps: shells that lie flat are charts as
// they are, all others are partitioned into few regions, each flattened with a free outline, and
// halved where that distorts it too much or makes it overlap itself.
#include <cstdint>
#include <stop_token>
#include <vector>

#include "atlas/mesh/connectivity.h"
#include "atlas/mesh/mesh.h"
#include "atlas/outline/flat_chart.h"
#include "atlas/outline/free_map.h"
#include "atlas/patch/partition.h"

namespace burl {

/// Limits of distortion.
struct DivisionOptions {
    PartitionOptions partition{.patches = 8, .seed = 1, .least_share = 0.05};
    /// Largest energy of a chart (FreeMap::energy).
    double most_energy = 1.04;
    std::stop_token stop{};
};

/// The charts of a mesh.
struct FlatCharts {
    std::vector<FlatChart> charts;
    std::vector<std::uint32_t> unmapped;  ///< triangles without area or map, ascending
};

/// Flattens the mesh; every triangle is in one chart or unmapped. Charts are turned so that the box
/// round each has the least area, with its longer side along x. Parts are flattened in parallel;
/// the result does not depend on the number of threads. Once a stop is requested what is left is
/// unmapped.
FlatCharts divide_into_charts(const Mesh& mesh, const Connectivity& connectivity,
                              const DivisionOptions& options = {});

}  // namespace burl
