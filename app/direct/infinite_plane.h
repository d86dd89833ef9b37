#pragma once
// Planes seen to the horizon (Hart et al. 1999, figures 3 and 6): no mesh reaches that far, so
// every picture sample meets the plane by its own ray, and the ray's differential says how much of
// the plane the sample covers.
#include <optional>
#include <string>

#include "app/scene/camera.h"
#include "procedural/batch/texel_place.h"

namespace burl {

/// The points p of the scene with normal . p = offset. The normal has any length but 0.
struct Plane {
    Vec3d normal{0.0, 1.0, 0.0};
    double offset = 0.0;
};

/// A plane and the recipe it shows; an empty name means the one of --recipe.
struct PlaneArgument {
    Plane plane;
    std::string recipe;
};

/// "RECIPE:NX,NY,NZ,D" or "NX,NY,NZ,D", for example "clouds:0,1,0,4". Throws Error(usage).
PlaneArgument parse_plane(const std::string& text);

/// The rays through a picture's samples, of which `samples` are in the whole picture.
class SampleRays {
  public:
    SampleRays(const Camera& camera, const PictureSize& samples);

    const Vec3d& eye() const { return eye_; }
    /// Through the centre of sample (x, y), y down; its component along the view axis is 1.
    Vec3d direction(int x, int y) const;
    /// By how much it changes from one sample to the next, to the right and downwards.
    const Footprint& steps() const { return steps_; }

  private:
    Vec3d eye_, first_;
    Footprint steps_;
};

/// Where a ray meets a plane.
struct PlaneHit {
    double depth = 0.0;  ///< along the view axis, > 0
    Vec3d point{0.0};
    Footprint steps;  ///< by how much the point moves from one sample to the next, to first order
};

/// Nothing where the ray does not come to the plane: parallel to it, away from it, or from within.
std::optional<PlaneHit> meet(const SampleRays& rays, int x, int y, const Plane& plane);

}  // namespace burl
