#pragma once
// All triangles of a scene in one list, in double precision, for formats without placements.
#include <vector>

#include "app/export/formats.h"

namespace burl {

/// Vertices that differ in point, texture coordinate or normal, by first use, and the triangles of
/// all placements. Each list but that of triangles has an entry per vertex or none at all.
struct PlacedTriangles {
    std::vector<Vec3d> points;   ///< in the pose, if there is one
    std::vector<Vec3f> normals;  ///< unit length
    std::vector<Vec2d> uvs;      ///< v = 1 at image row 0; empty without an atlas
    std::vector<Vec4f> colors;   ///< ExportOptions::vertex_colors
    std::vector<Triangle> triangles;
};

/// The scene's triangles in the mesh's order; further placements of a part follow, each with
/// vertices of its own.
PlacedTriangles placed_triangles(const SceneContent& content);

/// The scene's mesh as formats without morph targets show it: in its pose as far as the weight
/// says, with a normal for each triangle corner.
struct ShownMesh {
    Mesh mesh;
    std::vector<Vec3f> normals;
};
ShownMesh shown_mesh(const SceneContent& content);

}  // namespace burl
