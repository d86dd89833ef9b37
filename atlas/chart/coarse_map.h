#pragma once
// Maps of large patches. Factoring and solving grow faster than the patch, so a patch with many
// triangles is mapped with a quarter of them (repeatedly); the removed vertices then come back one
// by one, each to where its ring sees it, and are smoothed (after Hormann, Labsik & Greiner,
// "Remeshing triangulated surfaces with optimal parameterizations", 2001). The border keeps all its
// vertices, so both maps have the same outline.
#include <optional>

#include "atlas/chart/edge_collapse.h"
#include "atlas/chart/rectangle_map.h"

namespace burl {

/// A patch with fewer triangles and the same border, in the same order.
struct CoarsePatch {
    Patch patch;
    std::vector<std::uint32_t> fine_vertex;  ///< fine vertex of each coarse one
    CollapsedMesh collapsed;                 ///< collapses and their rings alone, for the way back
};

/// A coarse patch and its map.
struct CoarseMap {
    CoarsePatch level;
    RectangleMap map;  ///< map of level.patch
};

/// The patch with about `triangles` triangles, or as many more as collapse_edges() leaves. No inner
/// edge of `fine` may join two border vertices; then no inner edge of the result does.
CoarsePatch coarsen_patch(const Patch& fine, std::size_t triangles);

/// Places of the fine patch's vertices when the coarse one's lie at `coarse_uv`, without a flip;
/// nothing where rounding does not allow that. Linear.
std::optional<std::vector<Vec2d>> carry_to_fine(const Patch& fine, const CoarsePatch& coarse,
                                                std::span<const Vec2d> coarse_uv);

/// Number of triangles above which a patch is mapped coarsely.
inline constexpr std::size_t largest_patch = 30000;

/// map_onto_rectangle() for a patch of any size. A patch with more than `largest_patch` triangles
/// is mapped by its coarse patch: all its inner edges between two border vertices are split then,
/// and the map keeps the coarse one.
std::optional<RectangleMap> map_patch(Patch& patch, const DescentOptions& options);

/// Descends on a map made by map_patch(), mostly to fit it to a given aspect. A map that has a
/// coarse one is carried over from it anew.
void fit_map(const Patch& patch, RectangleMap& map, const DescentOptions& options);

}  // namespace burl
