#pragma once
// A triangle mesh with fewer triangles on nearly the same surface, and the way back: inner vertices
// are drawn into a neighbour, no two of them adjacent in one round (after Hoppe, "Progressive
// meshes", 1996; independent sets as in Hormann, Labsik & Greiner, "Remeshing triangulated surfaces
// with optimal parameterizations", 2001). Border vertices stay, and so do creases. Linear.
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/mesh/mesh.h"

namespace burl {

/// A vertex drawn into one of its neighbours. Its ring, counter-clockwise, is
/// ring[first] .. ring[first + count - 1], the neighbour the first of them.
struct Collapse {
    std::uint32_t vertex = 0, first = 0, count = 0;
};

struct CollapsedMesh {
    std::vector<Triangle> triangles;   ///< what is left, with the vertex numbers of before
    std::vector<std::uint32_t> which;  ///< per triangle left: its number before
    std::vector<std::uint32_t> heir;   ///< per triangle before: the number (before) of one that is
                                       ///< left, itself or near it
    std::vector<Collapse> collapses;   ///< in order
    std::vector<std::uint32_t> ring;
};

/// Collapses until no more than `most` triangles are left, or no vertex can go without turning a
/// triangle by more than about 25 degrees. Every vertex's triangles must be one fan or umbrella, as
/// those of a Patch are. Nothing is drawn into a vertex marked in `closed` (one entry per point, or
/// none at all).
CollapsedMesh collapse_edges(std::span<const Vec3d> points, std::span<const Triangle> triangles,
                             std::size_t most, std::vector<bool> closed = {});

}  // namespace burl
