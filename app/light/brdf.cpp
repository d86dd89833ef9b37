#include "app/light/brdf.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/light/microfacets.h"
#include "app/light/reflectance.h"

namespace burl {

namespace {

using std::numbers::pi;
constexpr double coat_f0 = 0.04;       ///< of a clearcoat, whose refractive index is 1.5
constexpr double least_cosine = 1e-4;  ///< of the view

double strongest(const Vec3d& v) {
    return std::max({v.x, v.y, v.z});
}

double clamped(double cosine) {
    return std::clamp(cosine, least_cosine, 1.0);
}

/// What glossy reflection at F0 and F90 does with white light: once, and more than once
/// (Fdez-Aguera 2019).
struct Scattered {
    Vec3d once{0.0}, more{0.0};
};

Scattered scattered(const Vec3d& f0, double f90, const Vec3d& table) {
    const Vec3d once = table.x * f0 + table.y * f90;
    const double lost = 1.0 - (table.x + table.y);
    const Vec3d mean = f0 + (f90 - f0) / 21.0;  // Schlick's Fresnel, averaged by cosine
    return {once, lost * once * mean / (1.0 - lost * mean)};
}

Scattered between(const Scattered& a, const Scattered& b, double share) {
    return {a.once + share * (b.once - a.once), a.more + share * (b.more - a.more)};
}

/// The shares of white light that leave a surface towards a view, by their ways.
struct Shares {
    double albedo;  ///< E of the glossy lobe, were F0 1
    Scattered glossy;
    Vec3d diffuse;            ///< reflected diffusely
    Vec3d through;            ///< let through
    double sheen_albedo;      ///< of sheen of colour 1
    double below_sheen;       ///< what sheen leaves of all other light
    double coat, below_coat;  ///< the coat's weight, and what it leaves of all that is below
};

/// F0 and F90 of the dielectric.
Vec2d dielectric(const ShadedPoint& point) {
    return {std::min(dielectric_f0(point.ior), 1.0) * point.specular, point.specular};
}

Vec3d coat_normal(const ShadedPoint& point, const Vec3d& normal) {
    return point.coat_normal == Vec3d(0.0) ? normal : point.coat_normal;
}

double below_coat(const ShadedPoint& point, const Vec3d& normal, const Vec3d& view) {
    const double cosine = clamped(glm::dot(coat_normal(point, normal), view));
    return 1.0 - point.clearcoat * (coat_f0 + (1.0 - coat_f0) * schlick(cosine));
}

Shares shares_of(const ShadedPoint& point, const Vec3d& normal, const Vec3d& view) {
    const double cosine = clamped(glm::dot(normal, view));
    const Vec3d table = reflectance(cosine, point.roughness);
    const Vec2d f = dielectric(point);
    const Scattered plain = scattered(Vec3d(f.x), f.y, table),
                    metal = scattered(point.base, 1.0, table);
    const Vec3d left = (1.0 - point.metallic) * (Vec3d(1.0) - plain.once - plain.more) * point.base;
    const double sheen = strongest(point.sheen);
    const double fibres = sheen > 0.0 ? reflectance(cosine, point.sheen_roughness).z : 0.0;
    return {table.x + table.y,
            between(plain, metal, point.metallic),
            (1.0 - point.transmission) * left,
            point.transmission * left,
            fibres,
            1.0 - sheen * fibres,
            point.clearcoat,
            below_coat(point, normal, view)};
}

/// The direction in which a rough surface's lobe is looked up: it leans towards the normal.
Vec3d lobe_direction(const Vec3d& normal, const Vec3d& view, double roughness) {
    const Vec3d mirrored = 2.0 * glm::dot(normal, view) * normal - view;
    const double r2 = roughness * roughness;
    return glm::normalize(mirrored + r2 * r2 * (normal - mirrored));
}

/// The share of a glossy lobe that occlusion leaves (Lagarde and de Rousiers, "Moving Frostbite to
/// Physically Based Rendering", 2014).
double glossy_occlusion(double cosine, double occlusion, double roughness) {
    const double power = std::exp2(-16.0 * roughness - 1.0);
    return std::clamp(std::pow(cosine + occlusion, power) - 1.0 + occlusion, 0.0, 1.0);
}

Vec3d coat_light(const ShadedPoint& point, const Vec3d& normal, const Vec3d& view,
                 const PrefilteredLight& light) {
    const Vec3d n = coat_normal(point, normal);
    const double cosine = clamped(glm::dot(n, view));
    const Vec3d table = reflectance(cosine, point.clearcoat_roughness);
    return glossy_occlusion(cosine, point.occlusion, point.clearcoat_roughness) *
           (coat_f0 * table.x + table.y) *
           glossy_light(light, lobe_direction(n, view, point.clearcoat_roughness),
                        point.clearcoat_roughness);
}

/// The unit vector half way between two directions; the normal where they are opposite.
Vec3d half_way(const Vec3d& light, const Vec3d& view, const Vec3d& normal) {
    const Vec3d sum = light + view;
    const double length = glm::length(sum);
    return length > 0.0 ? sum / length : normal;
}

/// A GGX lobe times n.l, with F0 and F90.
Vec3d glossy_lobe(const Vec3d& f0, double f90, double roughness, const Vec3d& normal,
                  const Vec3d& view, const Vec3d& light) {
    const double nl = glm::dot(normal, light), nv = clamped(glm::dot(normal, view));
    if (nl <= 0.0) return Vec3d(0.0);
    const double alpha = alpha_of(roughness);
    const Vec3d half = half_way(light, view, normal);
    const double lobe = ggx(glm::dot(normal, half), alpha) * visibility(nl, nv, alpha) * nl;
    return lobe * (f0 + (f90 - f0) * schlick(glm::dot(view, half)));
}

double sheen_lobe(double roughness, const Vec3d& normal, const Vec3d& view, const Vec3d& light) {
    const double nl = glm::dot(normal, light), nv = clamped(glm::dot(normal, view));
    const double alpha = sheen_alpha(roughness);
    const double half = glm::dot(normal, half_way(light, view, normal));
    return charlie(half, alpha) * charlie_visibility(nl, nv, alpha) * nl;
}

/// What comes from above the surface, without sheen and coat.
Vec3d base_lobes(const ShadedPoint& point, const Shares& shares, const Vec3d& normal,
                 const Vec3d& view, const Vec3d& light) {
    const Vec2d f = dielectric(point);
    const Vec3d f0 = Vec3d(f.x) + point.metallic * (point.base - Vec3d(f.x));
    const double f90 = f.y + point.metallic * (1.0 - f.y);
    return glossy_lobe(f0, f90, point.roughness, normal, view, light) +
           glm::dot(normal, light) / pi * (shares.glossy.more + shares.diffuse);
}

}  // namespace

double dielectric_f0(double ior) {
    const double ratio = (ior - 1.0) / (ior + 1.0);
    return ratio * ratio;
}

Vec3d emitted(const ShadedPoint& point, const Vec3d& normal, const Vec3d& view) {
    return below_coat(point, normal, view) * point.emissive;
}

Vec3d ambient_shading(const ShadedPoint& point, const Vec3d& normal, const Vec3d& view,
                      const PrefilteredLight& light) {
    const Shares shares = shares_of(point, normal, view);
    const double cosine = clamped(glm::dot(normal, view));
    const Vec3d around = point.occlusion * diffuse_light(light, normal);
    const double open = glossy_occlusion(cosine, point.occlusion, point.roughness);
    Vec3d sum = open * (shares.glossy.once *
                        glossy_light(light, lobe_direction(normal, view, point.roughness),
                                     point.roughness)) +
                shares.glossy.more * around + shares.diffuse * around;
    if (point.transmission > 0.0)
        sum += shares.through * glossy_light(light, -view, point.roughness);
    sum = shares.below_sheen * sum + shares.sheen_albedo * point.sheen * around;
    sum = shares.below_coat * (sum + point.emissive);
    if (shares.coat > 0.0) sum += shares.coat * coat_light(point, normal, view, light);
    return sum;
}

Vec3d reflected(const ShadedPoint& point, const Vec3d& normal, const Vec3d& view,
                const Vec3d& light) {
    const Shares shares = shares_of(point, normal, view);
    const double cosine = glm::dot(normal, light);
    if (cosine < 0.0) {
        if (!(point.transmission > 0.0)) return Vec3d(0.0);
        const Vec3d mirrored = light - 2.0 * cosine * normal;
        const Vec3d lobe = glossy_lobe(Vec3d(1.0), 1.0, point.roughness, normal, view, mirrored);
        return shares.below_coat * shares.below_sheen * shares.through * lobe / shares.albedo;
    }
    if (cosine == 0.0) return Vec3d(0.0);
    Vec3d sum = shares.below_sheen * base_lobes(point, shares, normal, view, light);
    if (shares.sheen_albedo > 0.0)
        sum += point.sheen * sheen_lobe(point.sheen_roughness, normal, view, light);
    sum *= shares.below_coat;
    if (shares.coat > 0.0)
        sum += shares.coat * glossy_lobe(Vec3d(coat_f0), 1.0, point.clearcoat_roughness,
                                         coat_normal(point, normal), view, light);
    return sum;
}

}  // namespace burl
