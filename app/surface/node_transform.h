#pragma once
// Placements of parts: translation, rotation and scale as glTF's nodes take them (the format
// forbids matrices with shear), and the transformation of normals for exporters that copy geometry.
#include <array>
#include <optional>

#include "atlas/base/vec.h"

namespace burl {

struct NodeTransform {
    Vec3d translation{0.0};
    std::array<double, 4> rotation{0.0, 0.0, 0.0, 1.0};  ///< unit quaternion x, y, z, w
    Vec3d scale{1.0};  ///< a mirroring placement has one negative component
};

/// The transform equal to `matrix` (to 1e-9 of its largest entry); no value for a matrix that
/// shears or flattens, or is not finite.
std::optional<NodeTransform> decompose(const Mat4d& matrix);

/// The matrix that glTF defines for the transform: scale, then rotation, then translation.
Mat4d matrix_of(const NodeTransform& transform);

/// Transforms normals by the matrix's cofactors, which are defined for every matrix, those that
/// shear, mirror or flatten included.
class NormalTransform {
  public:
    explicit NormalTransform(const Mat4d& matrix);

    /// The unit normal of the placed surface; +Z where the placement leaves none.
    Vec3f operator()(const Vec3f& normal) const;

    /// Whether the placement mirrors, so that triangles must be reversed to keep their outside.
    bool mirrors() const { return mirrors_; }

  private:
    Mat3d cofactors_;
    bool mirrors_;
};

}  // namespace burl
