#pragma once
// Mean curvature at a scale, as an integral invariant: integrals bear the noise of facets, where
// differences of normals do not (Pottmann, Wallner, Huang, Yang, "Integral invariants for robust
// geometry processing", 2009). Of their invariants this takes the barycentre of the surface within
// a ball, which open meshes have, too, where the ball's volume inside the solid needs a closed one:
// it lies H r^2 / 4 below the surface, on a sphere exactly (Clarenz, Rumpf, Telea, "Robust feature
// detection and local classification for surfaces based on moment analysis", 2004).
#include <span>
#include <vector>

#include "atlas/shape/box_tree.h"
#include "atlas/shape/shape_scene.h"

namespace burl {

/// Moments of a set of triangles, and the ball that their normals lie in.
struct SurfaceMoments {
    double area = 0.0;
    Vec3d moment{0.0};    ///< the integral of position
    Vec3d facing{0.0};    ///< the integral of the normal
    Vec3d axis{0.0};      ///< the middle of all normals' box
    double spread = 0.0;  ///< greatest distance of a normal from `axis`
};

/// A scene's triangles in a hierarchy of moments, so that a ball with many triangles costs as much
/// as those on its border. It refers to the scene, which must outlive it.
class CurvatureTree {
  public:
    explicit CurvatureTree(const ShapeScene& shape);

    const ShapeScene& shape() const { return *shape_; }
    const ShapeBoxTree& tree() const { return tree_; }
    const SurfaceMoments& moments(std::size_t node) const { return moments_[node]; }

  private:
    const ShapeScene* shape_;
    ShapeBoxTree tree_;
    std::vector<SurfaceMoments> moments_;
};

/// Mean curvature times `radius` at each point, in [-1, 1]: positive where the surface is convex,
/// radius / R on a sphere of radius R, radius / (2R) + O(radius^3) on a cylinder, 0 on a
/// plane; 1.2, so 1, on the edge of a cube. It is 4 / (A radius) times the depth of the barycentre
/// of the surface within `radius` (mesh units, > 0), of area A, below the point, along that
/// surface's mean normal. Triangles turned away from the point's by more than 135 degrees do not
/// count: they are the other side of a thin wall or of a gap. 0 on triangles without area.
void curvature(const CurvatureTree& tree, std::span<const ShapePoint> points, double radius,
               std::span<float> values);

}  // namespace burl
