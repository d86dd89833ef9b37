#pragma once
// Rays against a mesh's triangles, by Embree (Wald, Woop, Benthin, Johnson, Ernst, "Embree: A
// Kernel Framework for Efficient CPU Ray Tracing", 2014).
#include <cstdint>
#include <memory>
#include <span>

#include "atlas/base/vec.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// The result of RayTree::nearest() for a ray that meets nothing.
inline constexpr std::uint32_t nothing_met = 0xffffffff;

/// A ray; both vectors are relative to the tree's points, and the direction has length 1.
struct ShapeRay {
    Vec3f origin{0.0f}, direction{0.0f};
};

/// A bounding volume hierarchy of triangles, which are met from both sides. It works in float32
/// with watertight tests (Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", 2013), so
/// that which triangles a ray meets does not depend on how the hierarchy was built, hence on
/// threads, and in vectors of one width on every processor.
class RayTree {
  public:
    /// Builds the hierarchy; all coordinates must be within [-1, 1]. Throws Error (runtime) where
    /// Embree has no memory for it.
    RayTree(std::span<const Vec3d> points, std::span<const Triangle> triangles);

    /// Whether the ray meets a triangle within `reach`, which may be infinite.
    bool blocked(const ShapeRay& ray, float reach) const;
    /// The first triangle that the ray meets within `reach`, or nothing_met.
    std::uint32_t nearest(const ShapeRay& ray, float reach) const;

  private:
    struct Scene;
    std::shared_ptr<const Scene> scene_;
};

}  // namespace burl
