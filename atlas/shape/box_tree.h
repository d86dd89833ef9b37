#pragma once
// A bounding volume hierarchy over boxes in double precision (Rubin & Whitted, "A 3-dimensional
// representation for fast rendering of complex scenes", 1980): each node is halved at the median
// along the longest side of its boxes' centres.
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/mesh/mesh.h"

namespace burl {

/// A node, which stands before all nodes below it: its first child comes right after it.
struct BoxNode {
    Box3 box;                          ///< bounds all items below
    std::uint32_t begin = 0, end = 0;  ///< the range of ShapeBoxTree::items below
    std::uint32_t second = 0;          ///< number of the second child, 0 for a leaf
};

/// The hierarchy; node 0 is the root. Without boxes there are no nodes.
struct ShapeBoxTree {
    std::vector<BoxNode> nodes;
    std::vector<std::uint32_t> items;  ///< numbers of the boxes, leaf by leaf
};

/// Builds the hierarchy over boxes, at most `leaf` (>= 1) to a leaf; ties go by number.
ShapeBoxTree build_box_tree(std::span<const Box3> boxes, std::size_t leaf = 4);

/// The smallest box of a triangle or segment's corners.
Box3 box_of(std::span<const Vec3d> corners);

/// Squared distance from `p` to the nearest point of the box; 0 inside.
double square_distance(const Box3& box, const Vec3d& p);
/// Squared distance from `p` to the farthest point of the box.
double farthest_square(const Box3& box, const Vec3d& p);

}  // namespace burl
