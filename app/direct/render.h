#pragma once
// The ground truth: the texture evaluated in float64 (or as the recipe says) at the exact surface
// point of every picture sample, with no atlas and no texture between
// (docs/reference/rendering.md). Baked pictures are measured against it.
#include <functional>
#include <span>

#include "app/direct/infinite_plane.h"
#include "app/pipeline/filtered_color.h"
#include "app/pipeline/texture_color.h"
#include "app/scene/camera.h"
#include "app/scene/shading.h"
#include "atlas/base/image.h"
#include "atlas/measure/surface_points.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// Linear-light colour of a point of the mesh, in mesh coordinates. Called from several threads.
using SurfaceColor = std::function<Vec3d(const Vec3d& mesh_point)>;

/// Linear-light colour of a point of a triangle. Called from several threads.
using PointColor = std::function<Vec3d(const SurfacePoint& point)>;

/// Draws every placement of every part; a placement shows the colours of the first one.
/// `normals`: per triangle corner, 3 * triangle count entries, in mesh coordinates.
/// Bit-identical for every thread count.
Image<Rgb8> render_surface(const Mesh& mesh, std::span<const Vec3f> normals,
                           const SurfaceColor& color, const Camera& camera,
                           const PictureOptions& options);

/// `bumped` gives the normals to shade with from the interpolated ones; empty: those themselves.
Image<Rgb8> render_points(const Mesh& mesh, std::span<const Vec3f> normals, const PointColor& color,
                          const Camera& camera, const PictureOptions& options,
                          const SurfaceNormal& bumped = {});

/// Linear-light colour of what a sample covers: a point of a triangle, which moves by `steps` (mesh
/// coordinates) from one sample to the next. Called from several threads.
using SampleColor = std::function<Vec3d(const SurfacePoint& point, const Footprint& steps)>;

/// A plane to the horizon and its colours at points of the scene; where their alpha is below 1 one
/// sees what lies behind.
struct PlaneLayer {
    Plane plane;
    FilteredColor color;
};

struct DirectScene {
    const Mesh& mesh;  ///< may be without triangles
    std::span<const Vec3f> normals;
    SampleColor color;
    SurfaceNormal bumped;  ///< normals to shade with from the interpolated ones; empty: those
    std::span<const PlaneLayer> planes;
};

/// Mesh and planes, nearer ones over farther ones. Bit-identical for every thread count.
Image<Rgb8> render_samples(const DirectScene& scene, const Camera& camera,
                           const PictureOptions& options);

/// The mesh with the recipe's texture and bumps; normals are the mesh's own, else those an export
/// would have (angle-weighted, creases above `crease_degrees`).
Image<Rgb8> render_direct(const Mesh& mesh, const Recipe& recipe, const Camera& camera,
                          const PictureOptions& options, double crease_degrees = 40.0);

}  // namespace burl
