#pragma once
// The point of a mesh or plane that a picture's sample shows, ready to be shaded.
#include "app/direct/render.h"
#include "app/scene/visibility.h"

namespace burl {

/// The point of a triangle that a sample shows, in mesh coordinates.
struct MeshSample {
    Vec3d weights{0.0}, point{0.0};
    Vec3d normal{0.0};  ///< interpolated, of any length
    Footprint covered;
};

/// The point of a triangle that covers sample (x, y).
MeshSample mesh_sample(const DirectScene& scene, const ScreenTriangle& t, int x, int y);

/// The cofactors of `m`, which transform normals up to a factor: the inverse transposed times the
/// determinant.
Mat3d cofactors(const Mat3d& m);

/// The point as light falls on it. Normals are on the side that the triangle itself shows to the
/// eye; rays begin on the smooth surface that normals describe, so that facets throw no shadow on
/// their own edges (Hanika, "Hacking the Shadow Terminator", 2021).
LitPoint lit_point(const DirectScene& scene, const ScreenTriangle& t, const MeshSample& sample,
                   const Vec3d& eye);

/// A point of a plane as light falls on it.
LitPoint lit_point(const Vec3d& plane_normal, const Vec3d& point, const Vec3d& eye,
                   const DirectSurroundings& around);

}  // namespace burl
