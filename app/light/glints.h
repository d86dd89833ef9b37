#pragma once
// The brightest texels of a cube map, a sun's for example, which samples of a lobe would hit by
// chance: their part in a lobe is summed one by one instead.
#include <vector>

#include "app/light/prefilter.h"

namespace burl {

/// A small bright spot: the unit direction, and its radiance times its solid angle.
struct Glint {
    Vec3f direction, light;
};

/// A cube map as its brightest spots and the rest.
struct Glinting {
    std::vector<Glint> glints;
    CubeFaces rest;
};

/// Takes from the texels what exceeds 16 times the mean luminance, in blocks of 4 x 4: the 64 of
/// most power.
Glinting without_glints(const CubeFaces& faces);

/// The part of the spots in the mean over a GGX lobe about a unit direction, seen along it.
class GlintLobe {
  public:
    GlintLobe(const std::vector<Glint>& glints, double alpha);
    Vec3f operator()(const Vec3f& direction) const;

  private:
    const std::vector<Glint>& glints_;
    float square_, share_;
};

}  // namespace burl
