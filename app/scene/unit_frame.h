#pragma once
// Where a surface's positions are for OpenGL: in [-1,1], so that float32 suffices wherever they
// lie.
#include "app/scene/scene.h"

namespace burl {

/// Takes [-1,1] to the sphere round the box of the surface's positions, of radius 1 where they are
/// one point.
Mat4d unit_frame(const Surface& surface);

/// Of every surface of the scene.
std::vector<Mat4d> unit_frames(const Scene& scene);

}  // namespace burl
