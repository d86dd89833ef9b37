#include "atlas/mesh/mesh.h"

#include <algorithm>

namespace burl {

double Box3::longest_side() const {
    const Vec3d s = size();
    return std::max({s.x, s.y, s.z});
}

Box3 bounding_box(const Mesh& mesh) {
    if (mesh.positions.empty()) return {};
    Box3 box{mesh.positions.front(), mesh.positions.front()};
    for (const Vec3d& p : mesh.positions) {
        box.low = glm::min(box.low, p);
        box.high = glm::max(box.high, p);
    }
    return box;
}

double triangle_area(const Mesh& mesh, std::size_t t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const auto& p = mesh.positions;
    return 0.5 * glm::length(glm::cross(p[b] - p[a], p[c] - p[a]));
}

double longest_edge(const Mesh& mesh, std::size_t t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const auto& p = mesh.positions;
    return std::max(
        {glm::distance(p[a], p[b]), glm::distance(p[b], p[c]), glm::distance(p[c], p[a])});
}

}  // namespace burl
