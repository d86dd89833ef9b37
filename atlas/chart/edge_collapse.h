#pragma once
// Mesh simplification by half-edge collapses that can be undone: inner vertices are collapsed into
// a neighbour, no two adjacent ones in the same round (after Hoppe, "Progressive meshes", 1996;
// independent sets as in Hormann, Labsik & Greiner, "Remeshing triangulated surfaces with optimal
// parameterizations", 2001). Border vertices stay, and so do creases. Linear.
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/mesh/mesh.h"

namespace burl {

/// The collapse of a vertex into one of its neighbours. The vertex's ring, counter-clockwise, is
/// ring[first] .. ring[first + count - 1]; the neighbour is the first of them.
struct Collapse {
    std::uint32_t vertex = 0, first = 0, count = 0;
};

/// A simplified mesh, and the way back.
struct CollapsedMesh {
    std::vector<Triangle> triangles;   ///< triangles left, with the original vertex numbers
    std::vector<std::uint32_t> which;  ///< original number of each triangle left
    /// The original number of a triangle left that stands for each original triangle: itself, or
    /// one near it.
    std::vector<std::uint32_t> heir;
    std::vector<Collapse> collapses;  ///< collapses in order of execution
    std::vector<std::uint32_t> ring;  ///< rings of all collapses
};

/// Collapses until no more than `most` triangles are left, or no vertex can be removed without
/// turning a triangle by more than about 25 degrees. Every vertex's triangles must form one fan or
/// umbrella, as those of a Patch do. No vertex is collapsed into one that is marked in `closed`
/// (one entry per point, or none at all).
CollapsedMesh collapse_edges(std::span<const Vec3d> points, std::span<const Triangle> triangles,
                             std::size_t most, std::vector<bool> closed = {});

}  // namespace burl
