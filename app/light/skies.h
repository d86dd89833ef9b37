#pragma once
// Built-in environments of the open air, as formulas of the direction: radiance up to a factor,
// linear Rec. 709. Directions are of length 1, y is up, and what stands at +z is behind the camera.
#include "atlas/base/vec.h"

namespace burl {

/// The standard overcast sky of the CIE (Moon and Spencer, "Illumination from a Non-Uniform Sky",
/// 1942), three times as bright above as at the horizon, with some clouds in it, over dull ground.
Vec3d overcast_light(const Vec3d& direction);

/// A clear sky with a low sun to the left of the camera. The sun is 2.4 degrees wide, not 0.5, so
/// that maps of 512 x 256 pixels hold it; it gives the light of a real one.
Vec3d sun_light(const Vec3d& direction);

/// A sky with the sun just below the horizon.
Vec3d dusk_light(const Vec3d& direction);

}  // namespace burl
