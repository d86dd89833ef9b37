#pragma once
// The mesh as a patch atlas exports it: where a chord was split, its triangle is replaced by the
// pieces, with positions, normals, colours, skin weights and texture coordinates interpolated half-
// way between the edge's ends. Only edges inside a patch are split, and both their triangles are,
// so no T-junction arises.
#include "atlas/patch/maps.h"

namespace burl {

/// A triangle of the mesh that was cut, and into how many.
struct CutFace {
    std::uint32_t face = 0, pieces = 0;
};

struct RefinedMesh {
    Mesh mesh;
    std::vector<CutFace> cut_faces;  ///< ascending
    /// Of the points beyond the mesh's own: which two of those they lie half-way between.
    std::vector<VertexOrigin> extra_points;
};

/// The refined mesh and where its triangles come from.
struct Refinement {
    RefinedMesh refined;
    /// Per triangle of the refined mesh: the mapped patch it belongs to, or not_in_mesh.
    std::vector<std::uint32_t> patch;
    /// Per triangle: its number within that patch (0 for unmapped ones).
    std::vector<std::uint32_t> in_patch;
};

/// Triangles keep the order of the mesh's, pieces of one follow each other; extra points come last.
Refinement refine_mesh(const Mesh& mesh, const PatchMaps& maps);

}  // namespace burl
