#include "app/direct/traced_sample.h"

#include <algorithm>

#include "app/light/reflection.h"
#include "atlas/base/random_unit.h"

namespace burl {

namespace {

constexpr int most_surfaces = 8;     ///< that are seen through one another
constexpr int rough_directions = 4;  ///< through a rough surface that is seen itself
constexpr double rough = 0.1;        ///< roughness from which they are needed

/// One of `count` looks from a point that is seen by this one.
Look deeper(const Look& look, const Vec3d& eye, int count) {
    const LightDraw& draw = look.draw;
    return {eye, {mix_bits(draw.seed + 3), draw.part, draw.fewer * count}, look.depth + 1};
}

/// The point of the triangle met that is at a place of the scene, without a footprint.
MeshSample sample_at(const DirectScene& scene, const Met& met, const Vec3d& place) {
    const Triangle& corners = scene.mesh.triangles[met.triangle];
    const auto corner = [&](std::size_t k) { return scene.mesh.positions[corners[k % 3]]; };
    MeshSample sample;
    sample.point = Vec3d(glm::inverse(*met.placement) * Vec4d(place, 1.0));
    const Vec3d normal = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
    const double square = std::max(glm::dot(normal, normal), 1e-300);
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3d from = corner(k + 1),
                    across = glm::cross(corner(k + 2) - from, sample.point - from);
        sample.weights[int(k)] = glm::dot(normal, across) / square;
        sample.normal +=
            sample.weights[int(k)] * Vec3d(scene.normals[3 * std::size_t{met.triangle} + k]);
    }
    return sample;
}

/// The light of the surface that a ray meets, premultiplied by alpha.
Vec4d light_of(const DirectScene& scene, const Met& met, const Vec3d& place, const Look& look) {
    if (!met.placement) return traced(scene, scene.planes[met.plane], place, {}, look);
    ScreenTriangle triangle{};
    triangle.triangle = met.triangle, triangle.placement = met.placement;
    return traced(scene, triangle, sample_at(scene, met, place), look);
}

/// Light that the surfaces along a ray send back along it; none where it meets none, since the
/// environment's has been summed then.
Vec3d light_along(const DirectScene& scene, Vec3d from, const Vec3d& direction, const Look& look) {
    const Blockers& blockers = *scene.around.blockers;
    Vec3d sum(0.0);
    double shows = 1.0;
    std::optional<Met> met = blockers.first(from, direction);
    for (int i = 0; met && i < most_surfaces; ++i) {
        const Vec3d place = from + met->distance * direction;
        const Vec4d color = light_of(scene, *met, place, look);
        sum += shows * Vec3d(color);
        shows *= 1.0 - color.w;
        if (shows <= 0.0) return sum;
        from = place + 2.0 * blockers.offset() * direction;
        met = blockers.first(from, direction);
        if (!met) sum += shows * scene.around.light->sky(direction);
    }
    return sum;
}

/// Light of surfaces behind the point that comes through it.
Vec3d light_behind(const DirectScene& scene, const ShadedPoint& point, const LitPoint& at,
                   const Look& look) {
    const Reflection reflection(point, at.normal, at.view);
    const int count = look.depth == 0 && point.roughness > rough ? rough_directions : 1;
    const std::uint64_t seed = mix_bits(look.draw.seed + 5);
    const Vec2d shift(random_unit(seed, 0), random_unit(seed, 1));
    Vec3d sum(0.0);
    for (int i = 0; i < count; ++i) {
        const double number = look.draw.part * count + i;
        const auto [direction, share] = reflection.through_at(
            glm::fract(shift + number * Vec2d(0.7548776662466927, 0.5698402909980532)));
        if (share == Vec3d(0.0) || glm::dot(at.smooth, direction) >= 0.0) continue;
        sum += share * light_along(scene, at.behind, direction, deeper(look, at.behind, count));
    }
    return sum / double(count);
}

/// The light of a material, premultiplied by alpha.
Vec4d shaded(const DirectScene& scene, const MaterialSample& material, const LitPoint& at,
             const Look& look) {
    const TracedLight& light = *scene.around.light;
    Vec3d sum = light(material.point, at, look.draw);
    const bool through = material.point.transmission > 0.0 && light.sums() && scene.around.blockers;
    if (through && look.depth < most_surfaces) sum += light_behind(scene, material.point, at, look);
    return {material.alpha * sum, material.alpha};
}

}  // namespace

Vec4d traced(const DirectScene& scene, const ScreenTriangle& t, const MeshSample& sample,
             const Look& look) {
    MaterialSample material = scene.material({t.triangle, sample.weights}, sample.covered);
    if (material.alpha <= 0.0) return Vec4d(0.0);
    const LitPoint at = lit_point(scene, t, sample, look.eye);
    material.point.coat_normal = at.smooth;
    return shaded(scene, material, at, look);
}

Vec4d traced(const DirectScene& scene, const PlaneLayer& layer, const Vec3d& point,
             const Footprint& covered, const Look& look) {
    const MaterialSample material = layer.material(point, covered);
    if (material.alpha <= 0.0) return Vec4d(0.0);
    return shaded(scene, material, lit_point(layer.plane.normal, point, look.eye, scene.around),
                  look);
}

}  // namespace burl
