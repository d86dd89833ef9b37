#pragma once
// The shadow that a scene throws on a plane below it: what part of an environment's light does not
// reach the plane, by rays (Debevec, "Rendering Synthetic Objects into Real Scenes", 1998).
#include "app/light/environment.h"
#include "app/scene/scene.h"
#include "atlas/base/image.h"

namespace burl {

/// A square on the plane y = corner.y, in scene coordinates, and its shadow.
struct Ground {
    Vec3d corner{0.0};  ///< the corner of least x and z
    double side = 0.0;
    /// The share of the light from above that does not reach the plane, 0 to 1, fading to 0 at the
    /// rim. Row 0 is at least z, column 0 at least x.
    Image<float> shadow;
};

/// The ground under the scene's lowest point. Surfaces that blend let light through as if they were
/// not there. The same for every number of threads. Throws Error(runtime) where memory for the
/// rays' hierarchy runs out.
Ground ground_under(const Scene& scene, const Environment& environment);

/// An environment of the same white light from everywhere: the light of a ground under the
/// headlight.
Environment white_environment();

}  // namespace burl
