#pragma once
// Thickness of a solid below its surface, by rays inwards (Shapira, Shamir, Cohen-Or, "Consistent
// mesh partitioning and skeletonisation using the shape diameter function", 2008, with the cosine
// as weight in place of a cone).
#include <limits>
#include <span>

#include "atlas/shape/shape_scene.h"

namespace burl {

struct ThicknessOptions {
    int rays = 64;  ///< per point
    /// Cap in mesh units: longer rays, and those that leave an open mesh, count as this long. The
    /// diagonal of the bounding box at most.
    double distance = std::numeric_limits<double>::infinity();
};

/// The mean length, in mesh units, of cosine-weighted rays from each point into the solid up to
/// where they meet the surface again. A slab of thickness h has 2h - h^2 / cap, a ball of radius R
/// has 4R / 3. `values` is as long as `points`. 0 on triangles without area.
void thickness(const ShapeScene& shape, std::span<const ShapePoint> points,
               const ThicknessOptions& options, std::span<float> values);

}  // namespace burl
