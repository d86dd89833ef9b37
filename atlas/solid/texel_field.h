#pragma once
// A number at every texel of an atlas, such as a mask of the mesh's shape.
#include "atlas/base/image.h"
#include "atlas/base/vec.h"

namespace burl {

/// Values at the texels of an atlas, and their gradients with respect to the point in the
/// SolidAtlas's space. `slopes` is empty where nobody asked for them, or where all are 0.
struct TexelField {
    Image<float> values;
    Image<Vec3f> slopes{};

    Vec3d slope(std::size_t x, std::size_t y) const {
        return slopes.width() > 0 ? Vec3d(slopes(x, y)) : Vec3d(0.0);
    }
};

}  // namespace burl
