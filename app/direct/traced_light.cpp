#include "app/direct/traced_light.h"

#include <algorithm>
#include <utility>

#include "app/light/reflection.h"
#include "atlas/base/random_unit.h"

namespace burl {

namespace {

/// Points that cover a cube evenly, from whichever of them on and in whichever two of its sides,
/// shifted by a random amount (Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences",
/// 2018; Cranley and Patterson, "Randomization of Number Theoretic Methods for Multiple
/// Integration", 1976).
class EvenPoints {
  public:
    /// `count` points of the part of a sequence that belongs to the draw.
    EvenPoints(const LightDraw& draw, std::uint64_t use, int count)
        : first_(double(draw.part) * count) {
        const std::uint64_t seed = mix_bits(draw.seed + use);
        for (std::uint64_t k = 0; k < 3; ++k) shift_[int(k)] = random_unit(seed, k);
    }
    Vec3d operator()(int i) const {
        const Vec3d at = shift_ + (first_ + i) * Vec3d(0.8191725133961644, 0.6710436067037893,
                                                       0.5497004779019703);
        return glm::fract(at);
    }

  private:
    double first_;
    Vec3d shift_{0.0};
};

}  // namespace

TracedLight::TracedLight(Environment environment, int rays, const Blockers* blockers)
    : light_(std::move(environment)), rays_(rays), blockers_(blockers) {}

TracedLight::TracedLight(std::shared_ptr<const PrefilteredLight> smooth)
    : smooth_(std::move(smooth)) {}

Vec3d TracedLight::operator()(const ShadedPoint& material, const LitPoint& at,
                              const LightDraw& draw) const {
    if (smooth_) return ambient_shading(material, at.normal, at.view, *smooth_);
    return emitted(material, at.normal, at.view) + summed(material, at, draw);
}

/// Light from below is what comes through the surface.
bool TracedLight::reaches(const LitPoint& at, const Vec3d& light) const {
    const bool above = glm::dot(at.normal, light) >= 0.0;
    if (above != (glm::dot(at.smooth, light) >= 0.0)) return false;
    if (!blockers_) return true;
    return above ? !blockers_->blocked(at.place, light) : !blockers_->first(at.behind, light);
}

Vec3d TracedLight::summed(const ShadedPoint& material, const LitPoint& at,
                          const LightDraw& draw) const {
    const Reflection reflection(material, at.normal, at.view);
    const int rays = std::max(rays_ / draw.fewer, 1), own = (rays + 1) / 2, theirs = rays - own;
    Vec3d sum(0.0);
    const auto add = [&](const Vec3d& light) {
        const Vec3d share = reflection(light);
        if (share == Vec3d(0.0)) return;
        const LightSampler::Seen seen = (*light_)(light);
        const double density = own * reflection.density(light) + theirs * seen.density;
        if (density > 0.0 && seen.light != Vec3d(0.0) && reaches(at, light))
            sum += share * seen.light / density;
    };
    const EvenPoints lobes(draw, 0, own), sky(draw, 1, theirs);
    for (int i = 0; i < own; ++i) {
        const Vec3d point = lobes(i);
        add(reflection.sample(point.z, Vec2d(point)));
    }
    for (int i = 0; i < theirs; ++i) add(light_->sample(Vec2d(sky(i))));
    return sum;
}

double TracedLight::shadow(const Vec3d& place, const LightDraw& draw) const {
    if (!blockers_) return 0.0;
    const EvenPoints sky(draw, 2, rays_);
    double whole = 0.0, blocked = 0.0;
    for (int i = 0; i < rays_; ++i) {
        const Vec3d direction = light_->sample(Vec2d(sky(i)));
        const LightSampler::Seen seen = (*light_)(direction);
        if (direction.y <= 0.0 || !(seen.density > 0.0)) continue;
        const double light =
            direction.y * glm::dot(seen.light, Vec3d(0.2126, 0.7152, 0.0722)) / seen.density;
        whole += light;
        if (blockers_->blocked(place, direction)) blocked += light;
    }
    return whole > 0.0 ? blocked / whole : 0.0;
}

}  // namespace burl
