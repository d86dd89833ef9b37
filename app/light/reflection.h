#pragma once
// What a point of a surface sends to one view, as a function of where light comes from, and
// directions drawn about as often as they matter.
#include <array>

#include "app/light/shares.h"

namespace burl {

/// The function reflected() of app/light/brdf.h for one point and view.
class Reflection {
  public:
    /// `normal` and `view` are unit vectors; a view below the normal's horizon is lifted to it.
    Reflection(const ShadedPoint& point, const Vec3d& normal, const Vec3d& view);

    /// The fraction of light from the unit direction, times |normal . light|.
    Vec3d operator()(const Vec3d& light) const;

    /// A direction: `which`, in [0,1), chooses a lobe, `at`, in (0,1)^2, the place in it. It may
    /// lie below the surface although nothing comes from there.
    Vec3d sample(double which, const Vec2d& at) const;
    /// How many directions of sample() there are per solid angle about a direction.
    double density(const Vec3d& light) const;

    /// A direction from which light comes through the surface, and the share of it that reaches the
    /// view where directions for even `at` are averaged.
    struct Through {
        Vec3d direction{0.0}, share{0.0};
    };
    Through through_at(const Vec2d& at) const;

  private:
    enum Lobe : std::size_t { diffuse, glossy, coat, through };

    void weigh();
    Vec3d base_light(const Vec3d& light, double cosine) const;
    Vec3d below_light(const Vec3d& mirrored) const;

    ShadedPoint point_;
    Vec3d normal_, coat_normal_, view_;
    Shares shares_;
    double alpha_, coat_alpha_;
    std::array<double, 4> chances_{};  ///< of the lobes, sum 1
};

}  // namespace burl
