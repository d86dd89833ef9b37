#pragma once
// The gutters of a patch atlas's blocks.
#include "atlas/gutter/gutters.h"
#include "atlas/patch/atlas.h"

namespace burl {

/// The filled gutter of a rectangle's block: all its texels outside the rectangle. `triangles` are
/// the patch's.
Gutter rectangle_gutter(const ChartedMesh& mesh, const EdgeNeighbours& neighbours,
                        std::span<const std::uint32_t> triangles, const PatchBlock& block);

/// The filled texels of a planar patch's block, around whatever outline the patch has, where the
/// surface leaves the plane; all others belong to the plane's own map.
Gutter plane_gutter(const ChartedMesh& mesh, const EdgeNeighbours& neighbours,
                    std::span<const std::uint32_t> triangles, const PatchBlock& block,
                    const TexelMap& plane);

}  // namespace burl
