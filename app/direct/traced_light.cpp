#include "app/direct/traced_light.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/light/reflection.h"
#include "atlas/base/random_unit.h"

namespace burl {

namespace {

constexpr int shadow_rays = 64;  ///< of the ground's shadow where surfaces take none

double fraction(double x) {
    return x - std::floor(x);
}

/// Numbers that cover a cube evenly from whichever of them on, shifted by a random amount
/// (Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018; Cranley and
/// Patterson, "Randomization of Number Theoretic Methods for Multiple Integration", 1976).
class EvenNumbers {
  public:
    EvenNumbers(std::uint64_t seed, int count) : count_(count) {
        for (std::uint64_t k = 0; k < 3; ++k) shift_[int(k)] = random_unit(seed, k);
    }
    /// One in each of `count` equal parts of [0,1).
    double along(int i) const { return (i + shift_.z) / count_; }
    Vec2d on_square(int i) const {
        return {fraction(shift_.x + 0.7548776662466927 * i),
                fraction(shift_.y + 0.5698402909980532 * i)};
    }

  private:
    int count_;
    Vec3d shift_{0.0};
};

}  // namespace

TracedLight::TracedLight(Environment environment, int rays, const Blockers* blockers)
    : light_(std::move(environment)), rays_(rays), blockers_(blockers) {
    if (rays_ == 0) prefiltered_ = prefilter(light_.environment());
}

Vec3d TracedLight::operator()(const ShadedPoint& material, const LitPoint& at,
                              std::uint64_t seed) const {
    if (prefiltered_) return ambient_shading(material, at.normal, at.view, *prefiltered_);
    return emitted(material, at.normal, at.view) + summed(material, at, seed);
}

/// Light from below is what comes through the surface, which stands in its own way.
bool TracedLight::reaches(const LitPoint& at, const Vec3d& light) const {
    const bool above = glm::dot(at.normal, light) >= 0.0;
    if (above != (glm::dot(at.smooth, light) >= 0.0)) return false;
    return !above || !blockers_ || !blockers_->blocked(at.place, light);
}

Vec3d TracedLight::summed(const ShadedPoint& material, const LitPoint& at,
                          std::uint64_t seed) const {
    const Reflection reflection(material, at.normal, at.view);
    const int own = (rays_ + 1) / 2, theirs = rays_ - own;
    Vec3d sum(0.0);
    const auto add = [&](const Vec3d& light) {
        const Vec3d share = reflection(light);
        if (share == Vec3d(0.0)) return;
        const LightSampler::Seen seen = light_(light);
        const double density = own * reflection.density(light) + theirs * seen.density;
        if (density > 0.0 && seen.light != Vec3d(0.0) && reaches(at, light))
            sum += share * seen.light / density;
    };
    const EvenNumbers lobes(seed, own), sky(seed + 1, theirs);
    for (int i = 0; i < own; ++i) add(reflection.sample(lobes.along(i), lobes.on_square(i)));
    for (int i = 0; i < theirs; ++i) add(light_.sample(sky.on_square(i)));
    return sum;
}

double TracedLight::shadow(const Vec3d& place, std::uint64_t seed) const {
    if (!blockers_) return 0.0;
    const int count = rays_ > 0 ? rays_ : shadow_rays;
    const EvenNumbers sky(seed, count);
    double whole = 0.0, blocked = 0.0;
    for (int i = 0; i < count; ++i) {
        const Vec3d direction = light_.sample(sky.on_square(i));
        const LightSampler::Seen seen = light_(direction);
        if (direction.y <= 0.0 || !(seen.density > 0.0)) continue;
        const double light =
            direction.y * glm::dot(seen.light, Vec3d(0.2126, 0.7152, 0.0722)) / seen.density;
        whole += light;
        if (blockers_->blocked(place, direction)) blocked += light;
    }
    return whole > 0.0 ? blocked / whole : 0.0;
}

}  // namespace burl
