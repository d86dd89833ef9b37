#include "app/direct/blockers.h"

#include <limits>
#include <vector>

namespace burl {

namespace {

/// Every placement's points in scene coordinates, and its triangles.
void place_all(const Mesh& mesh, std::vector<Vec3d>& points, std::vector<Triangle>& triangles) {
    for (const Part& part : mesh.parts)
        for (const Mat4d& placement : part.instances) {
            const auto first = std::uint32_t(points.size());
            for (std::uint32_t t = 0; t < part.triangle_count; ++t) {
                const auto corner = first + 3 * t;
                for (const std::uint32_t p : mesh.triangles[part.first_triangle + t])
                    points.emplace_back(placement * Vec4d(mesh.positions[p], 1.0));
                triangles.push_back({corner, corner + 1, corner + 2});
            }
        }
}

}  // namespace

Blockers::Blockers(const Mesh& mesh) {
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

bool Blockers::blocked(const Vec3d& from, const Vec3d& direction) const {
    if (!tree_) return false;
    return tree_->blocked({Vec3f((from - centre_) / scale_), Vec3f(direction)},
                          std::numeric_limits<float>::infinity());
}

}  // namespace burl
