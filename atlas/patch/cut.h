#pragma once
// Cuts that make a disk of a patch that is none, or a better one of a disk that maps badly, without
// dividing it: a tube cut open along a shortest path between its two ends is a natural rectangle, a
// sock cut from its rim to its tip nearly one, and small holes of the mesh are closed by a fan that
// takes part in the map but shows nothing. Paths are Dijkstra's over the patch's edges.
#include <optional>
#include <vector>

#include "atlas/chart/patch.h"

namespace burl {

/// Cuts along the shortest edge path, through inner vertices only, from the longest border loop to
/// another one, until one loop is left. Stops after `most_cuts` or where there is no such path.
/// Returns the number of cuts.
std::uint32_t slit_tube(Patch& patch, std::uint32_t most_cuts = 10);

/// Cuts a patch from its rim to the inner vertex farthest from it (measured along edges). False,
/// and nothing changed, when the patch has no inner vertex that the rim reaches.
bool slit_sock(Patch& patch);

/// Closes border loops that are holes of the mesh by a fan round their centroid: loops other than
/// the longest whose edges are all borders of the mesh, too, and whose length is at most `most`
/// times the longest loop's. The fan's triangles and its centre are marked `not_in_mesh`. Returns
/// the number of holes closed. To be called before any triangle is split.
std::uint32_t fan_holes(Patch& patch, const Connectivity& connectivity, double most = 0.3);

/// The cuts that made a disk of a patch.
struct DiskCuts {
    std::uint32_t holes_closed = 0, tubes_slit = 0;
};

/// Closes small holes and slits tubes (fan_holes(), slit_tube()); nothing where the patch is no
/// disk even then.
std::optional<DiskCuts> cut_to_disk(Patch& patch, const Connectivity& connectivity);

}  // namespace burl
