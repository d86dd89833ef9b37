#pragma once
// Bounding boxes under affine maps: the extent of the solid coordinates of a mesh whose bounding
// box is known.
#include <cmath>

#include "atlas/base/vec.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// The axis-aligned bounding box of the images of all eight corners, and so of the whole box.
inline Box3 mapped(const Affine3& map, const Box3& box) {
    Box3 seen{Vec3d(HUGE_VAL), Vec3d(-HUGE_VAL)};
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3d s =
            map({(corner & 1 ? box.high : box.low).x, (corner & 2 ? box.high : box.low).y,
                 (corner & 4 ? box.high : box.low).z});
        seen.low = glm::min(seen.low, s);
        seen.high = glm::max(seen.high, s);
    }
    return seen;
}

}  // namespace burl
