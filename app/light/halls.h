#pragma once
// Built-in environments within walls, as formulas of the direction: radiance up to a factor, linear
// Rec. 709. Directions are of length 1, y is up; pictures look along -z from a little to the right
// (app/scene/camera.h), so that what stands at +z is behind the camera.
#include "atlas/base/vec.h"

namespace burl {

/// A dark room with a large soft box to the left of the camera, a strip to its right, one overhead
/// and a low one behind the object.
Vec3d studio_light(const Vec3d& direction);

/// A long hall of concrete: skylights along the roof, windows along one side, an open gate.
Vec3d warehouse_light(const Vec3d& direction);

/// A white room, a little brighter above, with three broad brighter spots.
Vec3d neutral_light(const Vec3d& direction);

}  // namespace burl
