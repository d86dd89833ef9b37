#pragma once
// Placements of parts: as glTF's nodes take them (translation, rotation and scale, because the
// format forbids node matrices with shear), and what they do to normals where geometry is copied.
#include <array>
#include <optional>

#include "atlas/base/vec.h"

namespace burl {

struct NodeTransform {
    Vec3d translation{0.0};
    std::array<double, 4> rotation{0.0, 0.0, 0.0, 1.0};  ///< unit quaternion x, y, z, w
    Vec3d scale{1.0};                                    ///< a mirrored placement has one negative
};

/// The transform equal to `matrix` (to 1e-9 of its largest entry); nothing for a matrix that shears
/// or flattens, or is not finite.
std::optional<NodeTransform> decompose(const Mat4d& matrix);

/// The matrix that glTF defines for it: scale first, then rotation.
Mat4d matrix_of(const NodeTransform& transform);

/// Carries normals through a placement by its cofactors, which work for every matrix, those that
/// shear, mirror or flatten included.
class NormalTransform {
  public:
    explicit NormalTransform(const Mat4d& matrix);

    /// Unit normal of the placed surface; +Z where the placement leaves none.
    Vec3f operator()(const Vec3f& normal) const;

    /// Whether triangles have to be turned over to keep their outside.
    bool mirrors() const { return mirrors_; }

  private:
    Mat3d cofactors_;
    bool mirrors_;
};

}  // namespace burl
