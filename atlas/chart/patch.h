#pragma once
// A patch of the patch atlas: some triangles of the mesh with vertices of their own, so that a
// patch can be cut open, closed over a hole and refined without touching the mesh. Vertices follow
// from which triangles meet across edges, never from which points they use: a point where only
// corners touch becomes several vertices, and the border is always a set of simple loops.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/mesh/connectivity.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// Number that marks triangles and vertices which close a hole and are no part of the mesh.
inline constexpr std::uint32_t not_in_mesh = 0xffffffffu;

/// Number of a half-edge: 3t+k runs from corner k of the patch's triangle t to corner (k+1)%3.
using HalfEdge = std::uint32_t;

/// Place of a patch vertex on the mesh: at mesh point a (then b == a), or half-way between the
/// points a and b, which are the ends of one edge.
struct VertexOrigin {
    std::uint32_t a = not_in_mesh, b = not_in_mesh;
    bool operator==(const VertexOrigin&) const = default;
};

/// Triangles of the mesh with their own vertices, connectivity and border loops.
struct Patch {
    std::vector<Vec3d> points;          ///< places of the vertices
    std::vector<VertexOrigin> origins;  ///< origins of the vertices
    std::vector<Triangle> triangles;    ///< vertices of each triangle, oriented as on the mesh
    std::vector<std::uint32_t> faces;   ///< mesh triangle that each patch triangle is or lies on
    /// neighbours[t][k] is the patch triangle across edge k of patch triangle t, or -1 on the
    /// border.
    std::vector<std::array<std::int32_t, 3>> neighbours;
    /// Border loops, each in order with the patch on its left; the longest loop (in length) comes
    /// first.
    std::vector<std::vector<HalfEdge>> loops;

    std::uint32_t start(HalfEdge h) const { return triangles[h / 3][h % 3]; }
    std::uint32_t end(HalfEdge h) const { return triangles[h / 3][(h % 3 + 1) % 3]; }
    /// The half-edge opposite h, in the triangle beyond the edge; h must not be on the border.
    HalfEdge across(HalfEdge h) const;
    bool on_border(HalfEdge h) const { return neighbours[h / 3][h % 3] < 0; }
};

/// Topology of a patch, which decides whether it can be mapped onto a rectangle.
struct PatchTopology {
    std::uint32_t components = 0, loops = 0;
    std::uint32_t handles = 0;  ///< sum of the components' genera
    std::int64_t euler_characteristic = 0;
    bool is_disk() const { return components == 1 && loops == 1 && handles == 0; }
};

/// The patch made of these mesh triangles (in this order), joined wherever the connectivity joins
/// two of them. Linear in their number; `local` is scratch memory of one entry per mesh triangle,
/// all -1 on entry and on return, so that extracting every patch of a mesh stays linear, too.
Patch extract_patch(const Mesh& mesh, const Connectivity& connectivity,
                    std::span<const std::uint32_t> faces, std::vector<std::int32_t>& local);

/// Renumbers vertices and orders loops after `neighbours` changed. New vertices take point and
/// origin from the vertices they were part of.
void rebuild_vertices(Patch& patch);

/// Components, border loops, handles and Euler characteristic of the patch.
PatchTopology topology_of(const Patch& patch);

/// Connected components of the patch as lists of its mesh triangles (those marked not_in_mesh left
/// out), ordered by their first triangle.
std::vector<std::vector<std::uint32_t>> component_faces(const Patch& patch);

/// Area of a triangle of the patch, in squared units of its points.
double area_of(const Patch& patch, std::size_t triangle);

/// Area of the patch's triangles that are in the mesh, in squared units of its points.
double area_of(const Patch& patch);

/// Sum of the edges' lengths on the surface, in units of the patch's points.
double length_of(const Patch& patch, std::span<const HalfEdge> edges);

}  // namespace burl
