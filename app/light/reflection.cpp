#include "app/light/reflection.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/light/formulas.h"
#include "app/light/microfacets.h"

namespace burl {

namespace {

using std::numbers::pi;

/// The unit vector half way between two directions; the normal where they are opposite.
Vec3d half_way(const Vec3d& light, const Vec3d& view, const Vec3d& normal) {
    const Vec3d sum = light + view;
    const double length = glm::length(sum);
    return length > 0.0 ? sum / length : normal;
}

/// A GGX lobe times n.l.
Vec3d glossy_lobe(const Fresnel& fresnel, double alpha, const Vec3d& normal, const Vec3d& view,
                  const Vec3d& light) {
    const double nl = glm::dot(normal, light), nv = view_cosine(glm::dot(normal, view));
    if (nl <= 0.0) return Vec3d(0.0);
    const Vec3d half = half_way(light, view, normal);
    const double lobe = ggx(glm::dot(normal, half), alpha) * visibility(nl, nv, alpha) * nl;
    return lobe * (fresnel.f0 + (fresnel.f90 - fresnel.f0) * schlick(glm::dot(view, half)));
}

double sheen_lobe(double roughness, const Vec3d& normal, const Vec3d& view, const Vec3d& light) {
    const double nl = glm::dot(normal, light), nv = view_cosine(glm::dot(normal, view));
    const double alpha = sheen_alpha(roughness);
    const double half = glm::dot(normal, half_way(light, view, normal));
    return charlie(half, alpha) * charlie_visibility(nl, nv, alpha) * nl;
}

/// The density of glossy_sample(), below the surface, too.
double glossy_density(double alpha, const Vec3d& normal, const Vec3d& view, const Vec3d& light) {
    const Vec3d half = half_way(light, view, normal);
    const double nh = glm::dot(normal, half), nv = view_cosine(glm::dot(normal, view));
    return nh > 0.0 ? masking(nv, alpha) * ggx(nh, alpha) / (4.0 * nv) : 0.0;
}

/// The mirrored view at a microfacet that the view sees.
Vec3d glossy_sample(double alpha, const Vec3d& normal, const Vec3d& view, const Vec2d& at) {
    const Mat3d frame = frame_about(normal);
    Vec3d local = view * frame;
    local.z = view_cosine(local.z);
    const Vec3d half = frame * visible_normal(local, alpha, at);
    return 2.0 * glm::dot(view, half) * half - view;
}

Vec3d mirrored_at(const Vec3d& direction, const Vec3d& normal) {
    return direction - 2.0 * glm::dot(direction, normal) * normal;
}

}  // namespace

Reflection::Reflection(const ShadedPoint& point, const Vec3d& normal, const Vec3d& view)
    : point_(point),
      normal_(normal),
      coat_normal_(coat_normal_of(point, normal)),
      view_(lifted(view, normal)),
      shares_(shares_of(point, normal, view_)),
      alpha_(alpha_of(point.roughness)),
      coat_alpha_(alpha_of(point.clearcoat_roughness)) {
    weigh();
}

/// Chances follow the shares of light; glossy lobes, in which bright light counts most, are never
/// rare.
void Reflection::weigh() {
    const double below = shares_.below_coat * shares_.below_sheen;
    chances_[diffuse] = below * luminance(shares_.glossy.more + shares_.diffuse) +
                        shares_.sheen_albedo * luminance(point_.sheen);
    chances_[through] = below * luminance(shares_.through);
    const double rest = chances_[diffuse] + chances_[through];
    chances_[glossy] = std::max(below * luminance(shares_.glossy.once), 0.2 * rest + 1e-3);
    chances_[coat] = shares_.coat > 0.0 ? std::max(1.0 - shares_.below_coat, 0.2 * rest) : 0.0;
    double sum = 0.0;
    for (const double chance : chances_) sum += chance;
    for (double& chance : chances_) chance /= sum;
}

Vec3d Reflection::base_light(const Vec3d& light, double cosine) const {
    return shares_.glossy_open * glossy_lobe(shares_.fresnel, alpha_, normal_, view_, light) +
           shares_.diffuse_open * cosine / pi * (shares_.glossy.more + shares_.diffuse);
}

Vec3d Reflection::below_light(const Vec3d& mirrored) const {
    const Vec3d lobe = glossy_lobe({Vec3d(1.0), 1.0}, alpha_, normal_, view_, mirrored);
    return shares_.below_coat * shares_.below_sheen / shares_.albedo * shares_.through * lobe;
}

Vec3d Reflection::operator()(const Vec3d& light) const {
    const double cosine = glm::dot(normal_, light);
    if (cosine < 0.0)
        return point_.transmission > 0.0 ? below_light(mirrored_at(light, normal_)) : Vec3d(0.0);
    if (cosine == 0.0) return Vec3d(0.0);
    Vec3d sum = shares_.below_sheen * base_light(light, cosine);
    if (shares_.sheen_albedo > 0.0)
        sum += shares_.diffuse_open * point_.sheen *
               sheen_lobe(point_.sheen_roughness, normal_, view_, light);
    sum *= shares_.below_coat;
    if (shares_.coat > 0.0)
        sum += shares_.coat * shares_.coat_open *
               glossy_lobe({Vec3d(coat_f0), 1.0}, coat_alpha_, coat_normal_, view_, light);
    return sum;
}

Vec3d Reflection::sample(double which, const Vec2d& at) const {
    std::size_t lobe = 0;
    while (lobe < through && which >= chances_[lobe]) which -= chances_[lobe++];
    while (lobe > 0 && chances_[lobe] == 0.0) --lobe;
    if (lobe == diffuse) {
        const double turn = 2.0 * pi * at.x, out = std::sqrt(at.y);
        return frame_about(normal_) *
               Vec3d(out * std::cos(turn), out * std::sin(turn), std::sqrt(1.0 - at.y));
    }
    if (lobe == coat) return glossy_sample(coat_alpha_, coat_normal_, view_, at);
    const Vec3d light = glossy_sample(alpha_, normal_, view_, at);
    return lobe == through ? mirrored_at(light, normal_) : light;
}

Reflection::Through Reflection::through_at(const Vec2d& at) const {
    const Vec3d mirrored = glossy_sample(alpha_, normal_, view_, at);
    if (glm::dot(normal_, mirrored) <= 0.0) return {};
    return {mirrored_at(mirrored, normal_),
            below_light(mirrored) / glossy_density(alpha_, normal_, view_, mirrored)};
}

double Reflection::density(const Vec3d& light) const {
    double sum = chances_[diffuse] * std::max(glm::dot(normal_, light), 0.0) / pi +
                 chances_[glossy] * glossy_density(alpha_, normal_, view_, light);
    if (chances_[coat] > 0.0)
        sum += chances_[coat] * glossy_density(coat_alpha_, coat_normal_, view_, light);
    if (chances_[through] > 0.0)
        sum +=
            chances_[through] * glossy_density(alpha_, normal_, view_, mirrored_at(light, normal_));
    return sum;
}

}  // namespace burl
