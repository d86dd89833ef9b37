#pragma once
// Normalised positions for OpenGL: within [-1,1], so that float32 is precise wherever a surface
// lies.
#include "app/scene/scene.h"

namespace burl {

/// The map from [-1,1] to the bounding sphere of the surface's positions, of radius 1 where they
/// are one point.
Mat4d unit_frame(const Surface& surface);

/// The unit_frame of every surface of the scene.
std::vector<Mat4d> unit_frames(const Scene& scene);

}  // namespace burl
