#include "atlas/shape/shape_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burl {

namespace {

/// Twice the area below which a triangle of the unit space counts as a line: rounding leaves as
/// much.
constexpr double no_area = 0x1p-50;

/// Length of the box's diagonal, which neither overflows nor vanishes; 1 for a single point.
double diagonal_of(const Box3& box) {
    const double side = box.longest_side();
    return side > 0.0 ? side * glm::length(box.size() / side) : 1.0;
}

std::vector<Vec3d> unit_points(const Mesh& mesh, const Vec3d& centre, double diagonal) {
    std::vector<Vec3d> points(mesh.positions.size());
    std::ranges::transform(mesh.positions, points.begin(),
                           [&](const Vec3d& p) { return (p - centre) / diagonal; });
    return points;
}

}  // namespace

Vec3d onto_triangle(const Vec3d& weights) {
    const Vec3d inside = glm::max(weights, Vec3d(0.0));
    const double sum = inside.x + inside.y + inside.z;
    return sum > 0.0 && std::isfinite(sum) ? inside / sum : Vec3d(1.0 / 3.0);
}

ShapeScene::ShapeScene(const Mesh& mesh)
    : centre_(bounding_box(mesh).centre()),
      diagonal_(diagonal_of(bounding_box(mesh))),
      points_(unit_points(mesh, centre_, diagonal_)),
      triangles_(mesh.triangles),
      corner_normals_(mesh.corners.normals),
      rays_(points_, triangles_) {
    normals_.reserve(triangles_.size());
    areas_.reserve(triangles_.size());
    for (const auto& [a, b, c] : triangles_) {
        const Vec3d normal = glm::cross(points_[b] - points_[a], points_[c] - points_[a]);
        const double length = glm::length(normal);
        normals_.push_back(length > no_area ? normal / length : Vec3d(0.0));
        areas_.push_back(length > no_area ? 0.5 * length : 0.0);
    }
}

ShapeScene ShapeScene::with_normals(std::vector<Vec3f> corner_normals) const {
    ShapeScene shape(*this);
    shape.corner_normals_ = std::move(corner_normals);
    return shape;
}

Vec3d ShapeScene::weights_at(std::uint32_t triangle, const Vec3d& position) const {
    const auto& [a, b, c] = triangles_[triangle];
    if (areas_[triangle] == 0.0) return Vec3d(1.0 / 3.0);
    const Vec3d p = to_unit(position) - points_[a];
    const Vec3d ab = points_[b] - points_[a], ac = points_[c] - points_[a];
    const Vec3d& n = normals_[triangle];
    const double of_b = glm::dot(glm::cross(p, ac), n) / (2.0 * areas_[triangle]);
    const double of_c = glm::dot(glm::cross(ab, p), n) / (2.0 * areas_[triangle]);
    return {1.0 - of_b - of_c, of_b, of_c};
}

std::array<Vec3d, 3> ShapeScene::weight_slopes(std::uint32_t triangle) const {
    const auto& [a, b, c] = triangles_[triangle];
    if (areas_[triangle] == 0.0) return {Vec3d(0.0), Vec3d(0.0), Vec3d(0.0)};
    const Vec3d ab = points_[b] - points_[a], ac = points_[c] - points_[a];
    const double scale = 1.0 / (2.0 * areas_[triangle] * diagonal_);
    const Vec3d of_b = scale * glm::cross(ac, normals_[triangle]);
    const Vec3d of_c = scale * glm::cross(normals_[triangle], ab);
    return {-of_b - of_c, of_b, of_c};
}

Vec3d ShapeScene::inset(std::uint32_t triangle, const Vec3d& weights) const {
    Vec3d least(1.0 / 6.0);
    for (int k = 0; k < 3; ++k) {
        const auto& t = triangles_[triangle];
        const Vec3d side = points_[t[std::size_t(k + 2) % 3]] - points_[t[std::size_t(k + 1) % 3]];
        const double height = 2.0 * areas_[triangle] / glm::length(side);
        if (height > 24.0 * ray_offset) least[k] = 4.0 * ray_offset / height;
    }
    return least + (1.0 - least.x - least.y - least.z) * onto_triangle(weights);
}

Vec3d ShapeScene::shading_normal(std::uint32_t triangle, const Vec3d& weights) const {
    const Vec3d& normal = normals_[triangle];
    if (corner_normals_.empty()) return normal;
    Vec3d sum(0.0);
    for (int k = 0; k < 3; ++k)
        sum += weights[k] * Vec3d(corner_normals_[3 * std::size_t{triangle} + std::size_t(k)]);
    const double length = glm::length(sum);
    return length > 0.0 && glm::dot(sum, normal) > 0.0 ? sum / length : normal;
}

ShapePoint ShapeScene::surface_point(std::uint32_t triangle, const Vec3d& weights) const {
    const Vec3d inside = inset(triangle, weights);
    const auto& [a, b, c] = triangles_[triangle];
    const Vec3d p = inside.x * points_[a] + inside.y * points_[b] + inside.z * points_[c];
    return {centre_ + diagonal_ * p, normals_[triangle], shading_normal(triangle, inside),
            triangle};
}

}  // namespace burl
