#pragma once
// Light of an environment that points of surfaces send to the eye, summed over directions drawn
// from both the environment and the surface (Veach and Guibas, "Optimally Combining Sampling
// Techniques for Monte Carlo Rendering", 1995), as far as nothing stands in their way. Light that
// other surfaces send on is left out: what is blocked is dark.
#include <cstdint>
#include <memory>
#include <optional>

#include "app/direct/blockers.h"
#include "app/light/brdf.h"
#include "app/light/light_sampler.h"

namespace burl {

/// Which directions a point takes: the points of one pixel share a seed and take different parts of
/// one sequence.
struct LightDraw {
    std::uint64_t seed = 0;
    int part = 0;
    int fewer = 1;  ///< divides the number of directions: one of so many points that are averaged
};

/// A point that light falls on, in scene coordinates.
struct LitPoint {
    Vec3d place{0.0};             ///< where rays begin, off the surface on the side that is seen
    Vec3d behind{0.0};            ///< the same on the other side, for what comes through
    Vec3d normal{0.0, 1.0, 0.0};  ///< unit, with bumps, on the side that is seen
    Vec3d smooth{0.0, 1.0, 0.0};  ///< unit, without bumps: no light is reflected from behind it
    Vec3d view{0.0, 1.0, 0.0};    ///< unit, towards the eye
};

/// The light of an environment at points of surfaces.
class TracedLight {
  public:
    /// Sums over `rays` directions per point, at least 1. Nothing blocks light where `blockers` is
    /// null, which must outlive this object.
    TracedLight(Environment environment, int rays, const Blockers* blockers);
    /// Shades by prefiltered light, without shadows, as OpenGL does.
    explicit TracedLight(std::shared_ptr<const PrefilteredLight> smooth);

    /// Light from the point to the eye, but for what surfaces behind it send through it.
    Vec3d operator()(const ShadedPoint& material, const LitPoint& at, const LightDraw& draw) const;

    /// The share of an upward plane's light that does not reach it at a point; 0 without rays.
    double shadow(const Vec3d& place, const LightDraw& draw) const;

    /// The environment's light from a direction of any length but 0; only where rays are summed.
    Vec3d sky(const Vec3d& direction) const { return light_from(light_->environment(), direction); }
    /// Whether light is summed over rays, and surfaces are seen through one another.
    bool sums() const { return light_.has_value(); }

  private:
    bool reaches(const LitPoint& at, const Vec3d& light) const;
    Vec3d summed(const ShadedPoint& material, const LitPoint& at, const LightDraw& draw) const;

    std::optional<LightSampler> light_;  ///< where directions are summed
    int rays_ = 0;
    const Blockers* blockers_ = nullptr;
    std::shared_ptr<const PrefilteredLight> smooth_;
};

}  // namespace burl
