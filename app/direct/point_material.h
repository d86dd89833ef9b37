#pragma once
// A recipe's whole material as a function of a point: what a picture in an environment shades. All
// channels of the graph are evaluated at once.
#include <functional>

#include "app/light/brdf.h"
#include "app/pipeline/texture_color.h"

namespace burl {

/// A material at a point, and the share of what lies behind that it hides.
struct MaterialSample {
    ShadedPoint point;
    double alpha = 1.0;
};

/// Function that gives the material at texture coordinates s; the footprint is the change of s to
/// the neighbouring samples. May be called from several threads at once.
using PointMaterial = std::function<MaterialSample(const Vec3d& s, const Footprint& footprint)>;

/// The recipe's material, filtered by `kind`. Its base colour is `color` where the graph has no
/// other channel, or where `shows_color` asks for it. Throws Error(unsupported) where a channel
/// reads a mask of the mesh's shape.
PointMaterial point_material(const Recipe& recipe, FilterKind kind, FilteredColor color,
                             bool shows_color);

}  // namespace burl
