#pragma once
// The points of a mesh's surface nearest to given points.
#include <span>
#include <vector>

#include "atlas/shape/box_tree.h"
#include "atlas/shape/texel_mask.h"

namespace burl {

/// A scene's triangles, to be asked which is nearest. It refers to the scene, which must outlive
/// it.
class NearestSurface {
  public:
    explicit NearestSurface(const ShapeScene& shape);

    /// The surface's point nearest to `position`, in mesh units; of triangles as near that with the
    /// lowest number. Triangles without area count as far.
    ShapePoint operator()(const Vec3d& position) const;

  private:
    const ShapeScene* shape_;
    ShapeBoxTree tree_;
};

/// The gradients of a mask at points of the surface, in mesh units: its own where they have a
/// closed form, else central differences between the points of the surface nearest to those that
/// lie `step` (mesh units, > 0) off along two directions of the triangle's plane; one-sided where
/// one of these faces more than 60 degrees away.
void mask_slopes(const NearestSurface& nearest, const ShapeMask& mask,
                 std::span<const ShapePoint> points, double step, std::span<Vec3d> slopes);

}  // namespace burl
