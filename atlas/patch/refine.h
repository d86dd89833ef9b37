#pragma once
// The mesh as a patch atlas exports it: a triangle at a split chord is replaced by its pieces, with
// positions, normals, colours, skin weights and texture coordinates interpolated half-way between
// the edge's ends. Only edges inside a patch are split, and both their triangles are, so no
// T-junction arises.
#include "atlas/patch/maps.h"

namespace burl {

/// A triangle of the mesh that was cut, and the number of its pieces.
struct CutFace {
    std::uint32_t face = 0, pieces = 0;
};

/// A mesh with middles of chords as additional points.
struct RefinedMesh {
    Mesh mesh;
    std::vector<CutFace> cut_faces;  ///< cut triangles, ascending
    /// Origins of the points beyond the mesh's own: the two mesh points half-way between which each
    /// lies.
    std::vector<VertexOrigin> extra_points;

    /// The origin of any point of `mesh`, of one of the mesh's own, too.
    VertexOrigin origin(std::uint32_t point) const {
        const std::size_t own = mesh.positions.size() - extra_points.size();
        return point < own ? VertexOrigin{point, point} : extra_points[point - own];
    }
};

/// The refined mesh and the origins of its triangles.
struct Refinement {
    RefinedMesh refined;
    /// The mapped patch of each triangle of the refined mesh, or not_in_mesh.
    std::vector<std::uint32_t> patch;
    /// Number of each refined triangle within its patch (0 for unmapped ones).
    std::vector<std::uint32_t> in_patch;
};

/// Refines the mesh by the patches' vertices. Triangles keep the order of the mesh's, pieces of one
/// triangle follow each other; additional points come last.
Refinement refine_mesh(const Mesh& mesh, const PatchMaps& maps);

}  // namespace burl
