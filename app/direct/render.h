#pragma once
// The ground truth: the texture evaluated in float64 (or the recipe's precision) at the exact
// surface point of every picture sample, without an atlas or a texture
// (docs/reference/rendering.md). Pictures of baked textures are compared with it.
#include <functional>
#include <span>

#include "app/direct/infinite_plane.h"
#include "app/pipeline/texture_color.h"
#include "app/scene/camera.h"
#include "app/scene/shading.h"
#include "atlas/base/image.h"
#include "atlas/measure/surface_points.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// The linear-light colour of a point of the mesh, in mesh coordinates. Called from several
/// threads.
using SurfaceColor = std::function<Vec3d(const Vec3d& mesh_point)>;

/// The linear-light colour of a point of a triangle. Called from several threads.
using PointColor = std::function<Vec3d(const SurfacePoint& point)>;

/// Draws every placement of every part; all placements show the colours of the first. `normals`
/// holds one normal per triangle corner (3t+k), in mesh coordinates. Bit-identical for every thread
/// count.
Image<Rgb8> render_surface(const Mesh& mesh, std::span<const Vec3f> normals,
                           const SurfaceColor& color, const Camera& camera,
                           const PictureOptions& options);

/// Draws as render_surface() does, with colours per triangle point. `bumped` maps the interpolated
/// normals to those for shading; empty: they are used as they are.
Image<Rgb8> render_points(const Mesh& mesh, std::span<const Vec3f> normals, const PointColor& color,
                          const Camera& camera, const PictureOptions& options,
                          const SurfaceNormal& bumped = {});

/// The linear-light colour of a sample: of a point of a triangle whose footprint, its displacement
/// between neighbouring samples, is `steps` (mesh coordinates). Called from several threads.
using SampleColor = std::function<Vec3d(const SurfacePoint& point, const Footprint& steps)>;

/// A plane to the horizon and its colours at points of the scene, premultiplied by alpha; the plane
/// is transparent where alpha is below 1.
struct PlaneLayer {
    Plane plane;
    FilteredColor color;
};

/// A mesh with its shading, and planes.
struct DirectScene {
    const Mesh& mesh;  ///< may be without triangles
    std::span<const Vec3f> normals;
    SampleColor color;
    SurfaceNormal bumped;  ///< the normals for shading from the interpolated ones; empty: those
    std::span<const PlaneLayer> planes;
};

/// Draws mesh and planes, nearer ones over farther ones. Bit-identical for every thread count.
Image<Rgb8> render_samples(const DirectScene& scene, const Camera& camera,
                           const PictureOptions& options);

/// Draws the mesh with the recipe's texture and bumps. Normals are the mesh's own, else those of an
/// export (angle-weighted, creases above `crease_degrees`). Bit-identical for every thread count.
Image<Rgb8> render_direct(const Mesh& mesh, const Recipe& recipe, const Camera& camera,
                          const PictureOptions& options, double crease_degrees = 40.0);

}  // namespace burl
