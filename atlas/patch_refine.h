#pragma once
// The mesh as a patch atlas exports it: where a chord was split, its triangle is replaced by the
// pieces, with positions, normals, colours, skin weights and texture coordinates interpolated half-
// way between the edge's ends. Only edges inside a patch are split, and both their triangles are,
// so no T-junction arises.
#include "atlas/patch_maps.h"

namespace burl {

struct RefinedMesh {
    Mesh mesh;
    /// Per triangle of `mesh`: the mapped patch it belongs to, or not_in_mesh for unmapped ones.
    std::vector<std::uint32_t> patch;
    /// Per triangle: its number within that patch (0 for unmapped ones).
    std::vector<std::uint32_t> in_patch;
    std::uint32_t extra_points = 0;
};

/// Triangles keep the order of the mesh's, pieces of one follow each other; extra points come last.
RefinedMesh refine_mesh(const Mesh& mesh, const PatchMaps& maps);

}  // namespace burl
