#pragma once
// Maps of large patches: factoring and solving grow faster than the patch, so a patch with many
// triangles is mapped with a quarter of them, or a quarter of that, and its own vertices then come
// back one by one, each to where its ring sees it, and are smoothed (after Hormann, Labsik &
// Greiner, "Remeshing triangulated surfaces with optimal parameterizations", 2001). The border
// keeps all its vertices, so both maps have the same outline.
#include <optional>

#include "atlas/patch/edge_collapse.h"
#include "atlas/patch/rectangle_map.h"

namespace burl {

/// A patch with fewer triangles and the same border, in the same order.
struct CoarsePatch {
    Patch patch;
    std::vector<std::uint32_t> fine_vertex;  ///< per coarse vertex
    CollapsedMesh collapsed;                 ///< the way back: its collapses and their rings alone
};

struct CoarseMap {
    CoarsePatch level;
    RectangleMap map;  ///< of level.patch
};

/// No inner edge of `fine` may join two border vertices; then none of the result does.
CoarsePatch coarsen_patch(const Patch& fine, std::size_t triangles);

/// Where the fine patch's vertices lie when the coarse one's lie at `coarse_uv`, without a flip;
/// nothing where rounding does not allow that. Linear.
std::optional<std::vector<Vec2d>> carry_to_fine(const Patch& fine, const CoarsePatch& coarse,
                                                std::span<const Vec2d> coarse_uv);

/// Patches with more triangles are mapped coarsely.
inline constexpr std::size_t largest_patch = 30000;

/// map_onto_rectangle, on the coarse patch for a large one: its inner edges between two border
/// vertices are all split then, and the map keeps the coarse one.
std::optional<RectangleMap> map_patch(Patch& patch, const DescentOptions& options);

/// Descends on a map of map_patch, for a given aspect most of all; one that has a coarse map is
/// carried over from there anew.
void fit_map(const Patch& patch, RectangleMap& map, const DescentOptions& options);

}  // namespace burl
