#pragma once
// Planes up to the horizon (Hart et al. 1999, figures 3 and 6). No mesh extends that far, so every
// picture sample intersects the plane by a ray of its own, and the ray's differential gives the
// sample's footprint on the plane.
#include <optional>
#include <string>

#include "app/scene/camera.h"
#include "procedural/batch/texel_batch.h"

namespace burl {

/// The points p of the scene with normal . p = offset. The normal has any length but 0.
struct Plane {
    Vec3d normal{0.0, 1.0, 0.0};
    double offset = 0.0;
};

/// A plane and the recipe it shows; an empty name means the recipe of --recipe.
struct PlaneArgument {
    Plane plane;
    std::string recipe;
};

/// Parses "RECIPE:NX,NY,NZ,D" or "NX,NY,NZ,D", for example "clouds:0,1,0,4"; the plane's normal has
/// length 1. Throws Error(usage).
PlaneArgument parse_plane(const std::string& text);

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

}  // namespace burl
