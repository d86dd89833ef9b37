#include "app/light/brdf.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/light/microfacets.h"
#include "app/light/reflectance.h"
#include "app/light/reflection.h"
#include "app/light/shares.h"

namespace burl {

namespace {

/// The direction in which a rough surface's lobe is looked up: it leans towards the normal.
Vec3d lobe_direction(const Vec3d& normal, const Vec3d& view, double roughness) {
    const Vec3d mirrored = 2.0 * glm::dot(normal, view) * normal - view;
    const double r2 = roughness * roughness;
    return glm::normalize(mirrored + r2 * r2 * (normal - mirrored));
}

Vec3d lobe_light(const PrefilteredLight& light, const Vec3d& normal, const Vec3d& view,
                 double roughness) {
    return glossy_light(light, lobe_direction(normal, view, roughness), roughness);
}

/// The share of a sun that is above a surface, 0 to 1, for the cosine of its height.
double share_above(const Sun& sun, double cosine) {
    return sun.shines() ? std::clamp(0.5 + 0.5 * cosine / double(sun.radius), 0.0, 1.0) : 0.0;
}

/// The sun's irradiance / pi.
Vec3d sun_diffuse(const Sun& sun, const Vec3d& normal) {
    if (!sun.shines()) return Vec3d(0.0);
    const double cosine = glm::dot(normal, Vec3d(sun.direction)), edge = double(sun.radius);
    // The mean of what is above the horizon, were the sun a bar.
    const double mean =
        cosine > edge ? cosine : std::pow(std::max(cosine + edge, 0.0), 2.0) / (4.0 * edge);
    return mean / std::numbers::pi * Vec3d(sun.light);
}

/// The sun's light from unit direction `light` that a GGX lobe sends to the view.
Vec3d sun_glossy(const Sun& sun, const Fresnel& fresnel, double roughness, const Vec3d& normal,
                 const Vec3d& view, const Vec3d& light) {
    const double nl = glm::dot(normal, light);
    if (!sun.shines() || nl <= 0.0) return Vec3d(0.0);
    const Vec3d seen = lifted(view, normal), half = glm::normalize(light + seen);
    const double alpha = alpha_of(roughness), nv = glm::dot(normal, seen);
    const double vh = std::max(glm::dot(seen, half), 1e-3);
    const double lobe = ggx_over_disc(glm::dot(normal, half), vh, alpha, double(sun.radius)) *
                        visibility(nl, nv, alpha) * nl;
    return lobe * (fresnel.f0 + (fresnel.f90 - fresnel.f0) * schlick(vh)) * Vec3d(sun.light);
}

/// Light that the coat reflects, were its weight 1.
Vec3d coat_light(const ShadedPoint& point, const Vec3d& normal, const Vec3d& view,
                 const PrefilteredLight& light) {
    const Vec3d n = coat_normal_of(point, normal);
    const double roughness = point.clearcoat_roughness;
    const Vec3d table = reflectance(view_cosine(glm::dot(n, view)), roughness);
    return (coat_f0 * table.x + table.y) * lobe_light(light, n, view, roughness) +
           sun_glossy(light.sun, {Vec3d(coat_f0), 1.0}, roughness, n, view,
                      Vec3d(light.sun.direction));
}

/// Light from behind that comes through, were its share 1: the lobe mirrored at the surface.
Vec3d through_light(const ShadedPoint& point, const Vec3d& normal, const Vec3d& view,
                    const Shares& shares, const PrefilteredLight& light) {
    const Vec3d sun(light.sun.direction);
    const Vec3d mirrored = sun - 2.0 * glm::dot(normal, sun) * normal;
    return glossy_light(light, -view, point.roughness) +
           sun_glossy(light.sun, {Vec3d(1.0), 1.0}, point.roughness, normal, view, mirrored) /
               shares.albedo;
}

}  // namespace

Vec3d emitted(const ShadedPoint& point, const Vec3d& normal, const Vec3d& view) {
    return shares_of(point, normal, view).below_coat * point.emissive;
}

Vec3d ambient_shading(const ShadedPoint& point, const Vec3d& normal, const Vec3d& view,
                      const PrefilteredLight& light) {
    const Shares shares = shares_of(point, normal, view);
    const Vec3d sun(light.sun.direction);
    const double above = share_above(light.sun, glm::dot(coat_normal_of(point, normal), sun));
    const Vec3d around = shares.diffuse_open *
                         (diffuse_light(light, normal) + above * sun_diffuse(light.sun, normal));
    const Vec3d mirrored =
        shares.glossy.once * lobe_light(light, normal, view, point.roughness) +
        above * sun_glossy(light.sun, shares.fresnel, point.roughness, normal, view, sun);
    Vec3d sum = (shares.glossy.more + shares.diffuse) * around + shares.glossy_open * mirrored;
    if (point.transmission > 0.0)
        sum += shares.through * through_light(point, normal, view, shares, light);
    sum = shares.below_sheen * sum + shares.sheen_albedo * point.sheen * around;
    sum = shares.below_coat * (sum + point.emissive);
    if (shares.coat > 0.0)
        sum += shares.coat * shares.coat_open * coat_light(point, normal, view, light);
    return sum;
}

Vec3d reflected(const ShadedPoint& point, const Vec3d& normal, const Vec3d& view,
                const Vec3d& light) {
    return Reflection(point, normal, view)(light);
}

}  // namespace burl
