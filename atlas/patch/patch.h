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

/// Marks triangles and vertices that close a hole and are no part of the mesh.
inline constexpr std::uint32_t not_in_mesh = 0xffffffffu;

/// Half-edge 3t+k runs from corner k of the patch's triangle t to corner (k+1)%3.
using HalfEdge = std::uint32_t;

/// Where a patch vertex lies on the mesh: at mesh point a (then b == a), or half-way between the
/// points a and b, which are the ends of one edge.
struct VertexOrigin {
    std::uint32_t a = not_in_mesh, b = not_in_mesh;
    bool operator==(const VertexOrigin&) const = default;
};

struct Patch {
    std::vector<Vec3d> points;          ///< per vertex
    std::vector<VertexOrigin> origins;  ///< per vertex
    std::vector<Triangle> triangles;    ///< vertex numbers, oriented as on the mesh
    std::vector<std::uint32_t> faces;   ///< per triangle: the mesh triangle it is or lies on
    /// Per triangle and edge k the patch triangle on the other side, or -1 on the border.
    std::vector<std::array<std::int32_t, 3>> neighbours;
    /// Border loops, each in order with the patch on its left; the longest (in length) first.
    std::vector<std::vector<HalfEdge>> loops;

    std::uint32_t start(HalfEdge h) const { return triangles[h / 3][h % 3]; }
    std::uint32_t end(HalfEdge h) const { return triangles[h / 3][(h % 3 + 1) % 3]; }
    /// The half-edge on the other side; h must not be on the border.
    HalfEdge across(HalfEdge h) const;
    bool on_border(HalfEdge h) const { return neighbours[h / 3][h % 3] < 0; }
};

/// What decides whether a patch can be mapped onto a rectangle.
struct PatchTopology {
    std::uint32_t components = 0, loops = 0;
    std::uint32_t handles = 0;  ///< genus, summed over the components
    std::int64_t euler_characteristic = 0;
    bool is_disk() const { return components == 1 && loops == 1 && handles == 0; }
};

/// The patch made of these mesh triangles (in this order), joined wherever the connectivity joins
/// two of them. Linear in their number; `local` is scratch of one entry per mesh triangle, all -1
/// on entry and on return, so that extracting every patch of a mesh stays linear too.
Patch extract_patch(const Mesh& mesh, const Connectivity& connectivity,
                    std::span<const std::uint32_t> faces, std::vector<std::int32_t>& local);

/// Numbers vertices and orders loops anew after `neighbours` changed. New vertices take point and
/// origin from the ones they were part of.
void rebuild_vertices(Patch& patch);

PatchTopology topology_of(const Patch& patch);

/// Components of the patch as lists of its mesh triangles (those that are not in the mesh left
/// out), ordered by their first triangle.
std::vector<std::vector<std::uint32_t>> component_faces(const Patch& patch);

double area_of(const Patch& patch, std::size_t triangle);

/// Sum over the triangles that are in the mesh.
double area_of(const Patch& patch);

double length_of(const Patch& patch, std::span<const HalfEdge> edges);

}  // namespace burl
