#pragma once
// Strokes of a brush in solid space: what a person paints over the procedural texture, as data of
// the recipe. After Carr & Hart's meshed atlases, where any point of the surface has texels of its
// own and painting needs no unwrapping.
#include <vector>

#include "atlas/base/image.h"
#include "atlas/base/vec.h"

namespace burl {

enum class PaintMode {
    paint,  ///< lays colour over what is there
    erase   ///< takes paint away, down to the texture
};

/// A ball moved along a line of points; it covers what it touches of the surface.
struct PaintStroke {
    std::vector<Vec3d> points{};  ///< in solid space, before scale and rotation
    double radius = 0.05;         ///< in solid units, above 0
    double hardness = 0.5;        ///< share of the radius that is covered evenly, 0 to 1
    double opacity = 1.0;         ///< 0 to 1
    Rgb8 color{0, 0, 0};          ///< sRGB
    PaintMode mode = PaintMode::paint;
    bool operator==(const PaintStroke&) const = default;
};

}  // namespace burl
