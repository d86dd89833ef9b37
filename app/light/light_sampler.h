#pragma once
// Directions from which an environment's light comes, as often as there is light (Pharr, Jakob,
// Humphreys, "Physically Based Rendering", section 12.5).
#include <vector>

#include "app/light/environment.h"

namespace burl {

/// An environment with the sums that directions are drawn by.
class LightSampler {
  public:
    explicit LightSampler(Environment environment);

    /// Light from a direction, and the directions of sample() per solid angle about it.
    struct Seen {
        Vec3d light{0.0};
        double density = 0.0;
    };
    /// The radiance seen in a direction of any length but 0.
    Seen operator()(const Vec3d& direction) const;

    /// A unit direction for a place in [0,1)^2.
    Vec3d sample(const Vec2d& at) const;

    const Environment& environment() const { return environment_; }

  private:
    double density_at(const Vec2d& uv) const;

    Environment environment_;
    std::size_t columns_, rows_;    ///< of cells, each of which is one or more pixels
    std::vector<double> row_sums_;  ///< of all rows up to each, over the whole
    std::vector<double> sums_;      ///< within its row, of all cells up to each, over the row's
};

}  // namespace burl
