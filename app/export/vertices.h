#pragma once
// A mesh with its atlas as the vertex arrays a graphics API draws: corners that agree in point,
// texture coordinate and normal become one vertex.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "app/surface/posed_corners.h"
#include "atlas/mesh/mesh.h"
#include "atlas/solid/atlas.h"

namespace burl {

/// What a pose adds to vertices, as a glTF's morph target has it.
struct VertexTarget {
    std::vector<Vec3f> positions, normals;
    std::vector<Vec3f> tangents;  ///< where the vertices have any
};

/// One Part. A point of the mesh is centre + scale * position; subtracting the box's centre in
/// double first keeps float32 positions exact to 2^-24 of the part's own size wherever it lies.
struct PartVertices {
    std::size_t part = 0;  ///< index into mesh.parts
    Vec3d centre{0.0};     ///< of the part's box, mesh units
    double scale = 1.0;    ///< a power of two; 1 unless the part's size is beyond 2^-60 .. 2^60
    std::vector<Vec3f> positions;
    std::vector<Vec3f> normals;   ///< unit length
    std::vector<Vec4f> tangents;  ///< of glTF's TANGENT (app/surface/tangents.h), or empty
    std::vector<std::array<float, 2>> uvs;  ///< corners / N, v = 0 at image row 0
    /// Of quad atlases: the block a vertex lies in, as texture coordinates low u, low v, high u,
    /// high v. A lookup of a MIP level that is clamped to it shows nothing of other blocks.
    std::vector<std::array<float, 4>> blocks;
    VertexTarget target{};               ///< empty: there is no pose
    std::vector<std::uint32_t> indices;  ///< three per triangle, in the mesh's order
};

/// One entry per part that has triangles. `normals` are per corner (app/surface/normals.h), as
/// `tangents`, which may be empty; corners share a vertex where w agrees, too, and where a pose
/// does not part them. `posed` is of the mesh and these normals; null: there is no pose.
std::vector<PartVertices> export_vertices(const Mesh& mesh, const Atlas& atlas,
                                          std::span<const Vec3f> normals,
                                          std::span<const Vec4f> tangents = {},
                                          const PosedCorners* posed = nullptr);

}  // namespace burl
