#pragma once
// The ground truth: the texture evaluated in float64 (or the recipe's precision) at the exact
// surface point of every picture sample, without an atlas or a texture
// (docs/reference/rendering.md). Pictures of baked textures are compared with it. No mesh extends
// to the horizon (Hart et al. 1999, figures 3 and 6), so every picture sample intersects a plane by
// a ray of its own, and the ray's differential gives the sample's footprint on the plane.
#include <functional>
#include <optional>
#include <span>

#include "app/direct/point_material.h"
#include "app/direct/traced_light.h"
#include "app/pipeline/texture_color.h"
#include "app/scene/camera.h"
#include "app/scene/shading.h"
#include "atlas/base/image.h"
#include "atlas/measure/surface_points.h"
#include "atlas/mesh/mesh.h"
#include "procedural/batch/texel_batch.h"

namespace burl {

/// The rays through the samples of a picture; `samples` is the number of samples per side of the
/// whole picture.
class SampleRays {
  public:
    SampleRays(const Camera& camera, const PictureSize& samples);

    const Vec3d& eye() const { return eye_; }
    /// The direction through the centre of sample (x, y), y down; its component along the view axis
    /// is 1.
    Vec3d direction(int x, int y) const;
    /// The difference of directions between neighbouring samples, to the right and downwards.
    const Footprint& steps() const { return steps_; }

  private:
    Vec3d eye_, first_;
    Footprint steps_;
};

/// The intersection of a ray with a plane.
struct PlaneHit {
    double depth = 0.0;  ///< the distance along the view axis, > 0
    Vec3d point{0.0};
    /// The displacement of the point between neighbouring samples, to first order.
    Footprint steps;
};

/// The intersection of the ray through sample (x, y) with the plane; no value where the ray is
/// parallel to it, points away from it or begins in it.
std::optional<PlaneHit> meet(const SampleRays& rays, int x, int y, const Plane& plane);

/// The linear-light colour of a point of a triangle. Called from several threads.
using PointColor = std::function<Vec3d(const SurfacePoint& point)>;

/// The linear-light colour of a sample, premultiplied by alpha: of a point of a triangle whose
/// footprint, its displacement between neighbouring samples, is `steps` (mesh coordinates). Called
/// from several threads.
using SampleColor = std::function<Vec4d(const SurfacePoint& point, const Footprint& steps)>;

/// The material of a sample of a triangle over its footprint in mesh coordinates. Called from
/// several threads.
using SampleMaterial = std::function<MaterialSample(const SurfacePoint& point, const Footprint&)>;

/// A plane to the horizon and its colours at points of the scene, premultiplied by alpha; the plane
/// is transparent where alpha is below 1.
struct PlaneLayer {
    Plane plane;
    FilteredColor color;
    PointMaterial material{};  ///< the whole material, for an environment's light
};

/// The light of a scene besides the headlight, and what lies behind and below it.
struct DirectSurroundings {
    const TracedLight* light = nullptr;      ///< null: the headlight, or none
    const Environment* backdrop = nullptr;   ///< null: the background is a colour, or none
    const Blockers* blockers = nullptr;      ///< what throws shadows and is seen through surfaces
    const TracedLight* on_ground = nullptr;  ///< null: there is no ground
};

/// A mesh with its shading, and planes.
struct DirectScene {
    const Mesh& mesh;                ///< may be without triangles
    std::span<const Vec3f> normals;  ///< one per triangle corner (3t+k), in mesh coordinates
    SampleColor color;
    SurfaceNormal bumped;  ///< the normals for shading from the interpolated ones; empty: those
    std::span<const PlaneLayer> planes;
    SampleMaterial material{};  ///< the whole material, for an environment's light
    DirectSurroundings around{};
};

/// Draws mesh and planes, nearer ones over farther ones as far as they are transparent: every
/// placement of every part of the mesh, all with the colours of the first. Bit-identical for every
/// thread count.
Image<Rgba8> render_samples(const DirectScene& scene, const Camera& camera,
                            const PictureOptions& options);

/// The colours of a picture, whatever their alpha.
Image<Rgb8> opaque(const Image<Rgba8>& picture);

/// Draws the mesh alone, with colours per triangle point, as render_samples() does.
Image<Rgb8> render_points(const Mesh& mesh, std::span<const Vec3f> normals, const PointColor& color,
                          const Camera& camera, const PictureOptions& options);

}  // namespace burl
