#include "app/direct/mesh_sample.h"

#include <algorithm>

namespace burl {

namespace {

Vec3d unit_or(const Vec3d& v, const Vec3d& otherwise) {
    const double length = glm::length(v);
    return length > 0.0 ? v / length : otherwise;
}

/// The normal of the triangle, of any length.
Vec3d facet_normal(const Mesh& mesh, std::uint32_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
}

/// The point moved outwards to the tangent planes of the corners, each by its weight. `side` is 1
/// or -1: where out is.
Vec3d on_smooth_surface(const DirectScene& scene, std::uint32_t triangle, const MeshSample& sample,
                        double side) {
    Vec3d moved = sample.point;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3d normal = side * Vec3d(scene.normals[3 * std::size_t{triangle} + k]);
        const Vec3d& corner = scene.mesh.positions[scene.mesh.triangles[triangle][k]];
        const double below = std::min(glm::dot(sample.point - corner, normal), 0.0);
        moved -= sample.weights[int(k)] * below * normal;
    }
    return moved;
}

double offset_of(const DirectSurroundings& around) {
    return around.blockers ? around.blockers->offset() : 0.0;
}

}  // namespace

Mat3d cofactors(const Mat3d& m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

MeshSample mesh_sample(const DirectScene& scene, const ScreenTriangle& t, int x, int y) {
    MeshSample sample;
    sample.weights = barycentrics(t, x, y);
    const auto steps = barycentric_steps(t, x, y, sample.weights);
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3d& corner = scene.mesh.positions[scene.mesh.triangles[t.triangle][k]];
        sample.point += sample.weights[int(k)] * corner;
        sample.covered.u += steps[0][int(k)] * corner;
        sample.covered.v += steps[1][int(k)] * corner;
        sample.normal +=
            sample.weights[int(k)] * Vec3d(scene.normals[3 * std::size_t(t.triangle) + k]);
    }
    return sample;
}

LitPoint lit_point(const DirectScene& scene, const ScreenTriangle& t, const MeshSample& sample,
                   const Vec3d& eye) {
    const Mat4d& placement = *t.placement;
    const Mat3d to_scene = cofactors(Mat3d(placement));
    const Vec3d facet = facet_normal(scene.mesh, t.triangle);
    const Vec3d normal = unit_or(sample.normal, facet);
    const Vec3d view = unit_or(eye - Vec3d(placement * Vec4d(sample.point, 1.0)), {0.0, 1.0, 0.0});
    const Vec3d facing = unit_or(to_scene * facet, view);
    const double seen = glm::dot(facing, view) < 0.0 ? -1.0 : 1.0;
    const double side = glm::dot(facet, normal) < 0.0 ? -seen : seen;
    const Vec3d bumped = scene.bumped ? scene.bumped(sample.point, normal) : normal;
    const Vec3d place = on_smooth_surface(scene, t.triangle, sample, side);
    const Vec3d off = offset_of(scene.around) * seen * facing;
    return {Vec3d(placement * Vec4d(place, 1.0)) + off,
            Vec3d(placement * Vec4d(sample.point, 1.0)) - off,
            side * unit_or(to_scene * bumped, facing), side * unit_or(to_scene * normal, facing),
            view};
}

LitPoint lit_point(const Vec3d& plane_normal, const Vec3d& point, const Vec3d& eye,
                   const DirectSurroundings& around) {
    const Vec3d view = unit_or(eye - point, plane_normal);
    const Vec3d normal =
        glm::normalize(glm::dot(plane_normal, view) < 0.0 ? -plane_normal : plane_normal);
    const Vec3d off = offset_of(around) * normal;
    return {point + off, point - off, normal, normal, view};
}

}  // namespace burl
