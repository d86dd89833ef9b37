#include "app/light/shares.h"

#include <algorithm>
#include <cmath>

#include "app/light/microfacets.h"
#include "app/light/reflectance.h"

namespace burl {

namespace {

double strongest(const Vec3d& v) {
    return std::max({v.x, v.y, v.z});
}

Scattered scattered(const Fresnel& fresnel, const Vec3d& table) {
    const Vec3d once = table.x * fresnel.f0 + table.y * fresnel.f90;
    const double lost = 1.0 - (table.x + table.y);
    // Schlick's Fresnel, averaged by cosine.
    const Vec3d mean = fresnel.f0 + (fresnel.f90 - fresnel.f0) / 21.0;
    return {once, lost * once * mean / (1.0 - lost * mean)};
}

Scattered between(const Scattered& a, const Scattered& b, double share) {
    return {a.once + share * (b.once - a.once), a.more + share * (b.more - a.more)};
}

Fresnel dielectric_of(const ShadedPoint& point) {
    return {Vec3d(dielectric_f0(point.ior) * point.specular), point.specular};
}

/// The share of a glossy lobe that occlusion leaves (Lagarde and de Rousiers, "Moving Frostbite to
/// Physically Based Rendering", 2014).
double glossy_occlusion(double cosine, double occlusion, double roughness) {
    const double power = std::exp2(-16.0 * roughness - 1.0);
    return std::clamp(std::pow(cosine + occlusion, power) - 1.0 + occlusion, 0.0, 1.0);
}

void add_coat(const ShadedPoint& point, const Vec3d& normal, const Vec3d& view, Shares& shares) {
    const double cosine = view_cosine(glm::dot(coat_normal_of(point, normal), view));
    shares.coat = point.clearcoat;
    shares.below_coat = 1.0 - point.clearcoat * (coat_f0 + (1.0 - coat_f0) * schlick(cosine));
    shares.coat_open = glossy_occlusion(cosine, point.occlusion, point.clearcoat_roughness);
}

}  // namespace

double dielectric_f0(double ior) {
    const double ratio = (ior - 1.0) / (ior + 1.0);
    return ratio * ratio;
}

double view_cosine(double cosine) {
    return std::clamp(cosine, 1e-4, 1.0);
}

Vec3d lifted(const Vec3d& view, const Vec3d& normal) {
    const double cosine = glm::dot(normal, view), least = view_cosine(0.0);
    return cosine >= least ? view : glm::normalize(view + (least - cosine) * normal);
}

Vec3d coat_normal_of(const ShadedPoint& point, const Vec3d& normal) {
    return point.coat_normal == Vec3d(0.0) ? normal : point.coat_normal;
}

Shares shares_of(const ShadedPoint& point, const Vec3d& normal, const Vec3d& view) {
    const double cosine = view_cosine(glm::dot(normal, view)), metal = point.metallic;
    const Vec3d table = reflectance(cosine, point.roughness);
    const Fresnel plain = dielectric_of(point);
    const Scattered of_plain = scattered(plain, table);
    Shares shares;
    shares.albedo = table.x + table.y;
    shares.fresnel = {plain.f0 + metal * (point.base - plain.f0),
                      plain.f90 + metal * (1.0 - plain.f90)};
    shares.glossy = between(of_plain, scattered({point.base, 1.0}, table), metal);
    const Vec3d left = (1.0 - metal) * (Vec3d(1.0) - of_plain.once - of_plain.more) * point.base;
    shares.diffuse = (1.0 - point.transmission) * left;
    shares.through = point.transmission * left;
    if (const double sheen = strongest(point.sheen); sheen > 0.0) {
        shares.sheen_albedo = reflectance(cosine, point.sheen_roughness).z;
        shares.below_sheen = 1.0 - sheen * shares.sheen_albedo;
    }
    shares.diffuse_open = point.occlusion;
    shares.glossy_open = glossy_occlusion(cosine, point.occlusion, point.roughness);
    if (point.clearcoat > 0.0) add_coat(point, normal, view, shares);
    return shares;
}

}  // namespace burl
