#include "app/light/brdf.h"

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

/// Light that the coat reflects, were its weight 1.
Vec3d coat_light(const ShadedPoint& point, const Vec3d& normal, const Vec3d& view,
                 const PrefilteredLight& light) {
    const Vec3d n = coat_normal_of(point, normal);
    const Vec3d table = reflectance(view_cosine(glm::dot(n, view)), point.clearcoat_roughness);
    return (coat_f0 * table.x + table.y) * lobe_light(light, n, view, point.clearcoat_roughness);
}

}  // namespace

Vec3d emitted(const ShadedPoint& point, const Vec3d& normal, const Vec3d& view) {
    return shares_of(point, normal, view).below_coat * point.emissive;
}

Vec3d ambient_shading(const ShadedPoint& point, const Vec3d& normal, const Vec3d& view,
                      const PrefilteredLight& light) {
    const Shares shares = shares_of(point, normal, view);
    const Vec3d around = shares.diffuse_open * diffuse_light(light, normal);
    Vec3d sum =
        (shares.glossy.more + shares.diffuse) * around +
        shares.glossy_open * shares.glossy.once * lobe_light(light, normal, view, point.roughness);
    if (point.transmission > 0.0)
        sum += shares.through * glossy_light(light, -view, point.roughness);
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
