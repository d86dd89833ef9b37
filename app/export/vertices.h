#pragma once
// The vertex arrays of a mesh with its atlas, for graphics APIs: corners that agree in point,
// texture coordinate and normal become one vertex.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "app/surface/node_transform.h"
#include "app/surface/posed_corners.h"
#include "atlas/mesh/mesh.h"
#include "atlas/solid/atlas.h"

namespace burl {

/// The changes that a pose adds to vertices, as a glTF morph target stores them.
struct VertexTarget {
    std::vector<Vec3f> positions, normals;
    std::vector<Vec3f> tangents;  ///< empty where the vertices have no tangents
};

/// The vertex arrays of one Part. A point of the mesh is centre + scale * position: subtracting the
/// box's centre in double first keeps float32 positions exact to 2^-24 of the part's own size
/// wherever it lies.
struct PartVertices {
    std::size_t part = 0;  ///< an index into mesh.parts
    Vec3d centre{0.0};     ///< the centre of the part's box, in mesh units
    double scale = 1.0;    ///< a power of two; 1 unless the part's size is beyond 2^-60 .. 2^60
    std::vector<Vec3f> positions;
    std::vector<Vec3f> normals;   ///< unit length
    std::vector<Vec4f> tangents;  ///< glTF's TANGENT (app/surface/tangents.h), or empty
    /// Corners divided by N; v = 0 at image row 0. Empty without an atlas.
    std::vector<std::array<float, 2>> uvs;
    std::vector<Vec4f> colors{};  ///< glTF's COLOR_0, in linear light; filled by the exporter
    std::vector<std::uint32_t> points{};  ///< the mesh's point of each vertex
    /// The rectangle of each vertex's block, in quad atlases only, as texture coordinates low u,
    /// low v, high u, high v. Lookups of MIP levels that are clamped to it do not show other
    /// blocks.
    std::vector<std::array<float, 4>> blocks;
    VertexTarget target{};               ///< empty without a pose
    std::vector<std::uint32_t> indices;  ///< three per triangle, in the mesh's order
};

/// One entry per part that has triangles. `normals` (app/surface/normals.h) and `tangents`, which
/// may be empty, are per corner. Corners share a vertex where the tangent's w agrees, too, and
/// where a pose does not separate them. `posed` belongs to the mesh and these normals; null: no
/// pose.
std::vector<PartVertices> export_vertices(const Mesh& mesh, const Atlas& atlas,
                                          std::span<const Vec3f> normals,
                                          std::span<const Vec4f> tangents = {},
                                          const PosedCorners* posed = nullptr);

/// Per triangle the index of its block; empty unless the atlas is of the kind quad.
std::vector<std::uint32_t> blocks_of_triangles(const Atlas& atlas);

/// The rectangle of a block as in PartVertices::blocks.
std::array<float, 4> rectangle_of(const Atlas& atlas, const Block& block);

/// The placement of a glTF node for the arrays, whose positions are relative to their centre and
/// scale. A node translates, rotates and scales; any other placement must be applied to the
/// vertices (placed).
Mat4d centred(const Mat4d& placement, const PartVertices& vertices);

/// The part's arrays transformed by a placement that no node can express (shear, flattening):
/// positions relative to the placed centre; triangles reversed where the placement mirrors.
PartVertices placed(const PartVertices& vertices, const Mat4d& placement);

/// The translation and scale of a node for arrays that placed() has made.
NodeTransform node_of_placed(const PartVertices& vertices);

}  // namespace burl
