#pragma once
// Distance to the nearest crease or border of a mesh, along a straight line.
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "atlas/shape/box_tree.h"
#include "atlas/shape/shape_scene.h"

namespace burl {

/// A straight piece of an edge, in the unit space of a ShapeScene.
using Segment = std::array<Vec3d, 2>;

/// A mesh's creases, to be asked how far off they are.
class CreaseEdges {
  public:
    /// Collects the edges at which the normals of two triangles differ by more than `angle`
    /// (radians, in [0, pi]), that have one triangle only, or more than two. Triangles with a
    /// repeated point are left out; an edge of any other triangle without area counts as none, for
    /// nobody can say which way it faces.
    CreaseEdges(const ShapeScene& shape, double angle);

    std::size_t count() const { return segments_.size(); }
    const ShapeBoxTree& tree() const { return tree_; }
    std::span<const Segment> segments() const { return segments_; }

  private:
    std::vector<Segment> segments_;
    ShapeBoxTree tree_;
};

/// The Euclidean distance from each point to the nearest of the edges, in mesh units: at most
/// `farthest`, and at most the diagonal of the bounding box, which it is where there are no edges.
/// Rounded to float once. `edges` must be of the same scene.
void edge_distance(const ShapeScene& shape, const CreaseEdges& edges,
                   std::span<const ShapePoint> points, double farthest, std::span<float> values);

/// The gradients of edge_distance(): away from the nearest place on an edge, of length 1; 0 on an
/// edge itself and where the distance is cut to `farthest`.
void edge_distance_slopes(const ShapeScene& shape, const CreaseEdges& edges,
                          std::span<const ShapePoint> points, double farthest,
                          std::span<Vec3d> slopes);

}  // namespace burl
