#include "app/direct/blockers.h"

#include <limits>
#include <utility>

namespace burl {

/// Makes every placement's points in scene coordinates, and its triangles.
void Blockers::place_all(const Mesh& mesh, std::vector<Vec3d>& points,
                         std::vector<Triangle>& triangles) {
    for (const Part& part : mesh.parts)
        for (const Mat4d& placement : part.instances) {
            const auto first = std::uint32_t(points.size());
            for (std::uint32_t t = 0; t < part.triangle_count; ++t) {
                const auto corner = first + 3 * t;
                for (const std::uint32_t p : mesh.triangles[part.first_triangle + t])
                    points.emplace_back(placement * Vec4d(mesh.positions[p], 1.0));
                triangles.push_back({corner, corner + 1, corner + 2});
                placed_.push_back({part.first_triangle + t, &placement});
            }
        }
}

Blockers::Blockers(const Mesh& mesh, std::vector<Plane> planes)
    : mesh_(mesh), planes_(std::move(planes)) {
    std::vector<Vec3d> points;
    std::vector<Triangle> triangles;
    place_all(mesh, points, triangles);
    if (triangles.empty()) return;
    Box3 box{points[0], points[0]};
    for (const Vec3d& p : points) box.low = glm::min(box.low, p), box.high = glm::max(box.high, p);
    centre_ = box.centre();
    if (const double side = box.longest_side(); side > 0.0) scale_ = 0.5 * side;
    lowest_ = box.low.y;
    for (Vec3d& p : points) p = (p - centre_) / scale_;
    tree_.emplace(points, triangles);
}

ShapeRay Blockers::ray(const Vec3d& from, const Vec3d& direction) const {
    return {Vec3f((from - centre_) / scale_), Vec3f(direction)};
}

bool Blockers::blocked(const Vec3d& from, const Vec3d& direction) const {
    return tree_ && tree_->blocked(ray(from, direction), std::numeric_limits<float>::infinity());
}

/// The distance at which a ray meets the triangle's plane.
double Blockers::distance(const Placed& placed, const Vec3d& from, const Vec3d& direction) const {
    const auto corner = [&](std::size_t k) {
        const std::uint32_t point = mesh_.triangles[placed.triangle][k];
        return Vec3d(*placed.placement * Vec4d(mesh_.positions[point], 1.0));
    };
    const Vec3d a = corner(0), normal = glm::cross(corner(1) - a, corner(2) - a);
    const double approach = glm::dot(normal, direction);
    return approach != 0.0 ? glm::dot(normal, a - from) / approach : glm::length(a - from);
}

std::optional<Met> Blockers::first(const Vec3d& from, const Vec3d& direction) const {
    std::optional<Met> met;
    if (tree_) {
        const std::uint32_t triangle =
            tree_->nearest(ray(from, direction), std::numeric_limits<float>::infinity());
        if (triangle != nothing_met) {
            const Placed& placed = placed_[triangle];
            met = Met{distance(placed, from, direction), placed.triangle, placed.placement};
        }
    }
    for (std::size_t i = 0; i < planes_.size(); ++i) {
        const double approach = glm::dot(planes_[i].normal, direction);
        const double at = (planes_[i].offset - glm::dot(planes_[i].normal, from)) / approach;
        if (approach != 0.0 && at > offset() && (!met || at < met->distance))
            met = Met{at, 0, nullptr, i};
    }
    return met;
}

}  // namespace burl
