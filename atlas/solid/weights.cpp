// Weights of the uniform, area-weighted and length-weighted atlas (Carr & Hart 2001, section 4).
#include "atlas/solid/weights.h"

#include <algorithm>
#include <cmath>

namespace burl {

namespace {

/// A triangle's area and the square of its longest edge.
struct Shape {
    double area = 0.0, longest_squared = 0.0;
};

/// Shape of a triangle scaled by `scale`; its area is 0 when the triangle is lower than its
/// coordinates can tell.
Shape shape(const Mesh& mesh, const Triangle& triangle, double scale) {
    constexpr double least_height = 1e-15;
    const auto& p = mesh.positions;
    const Vec3d a = scale * p[triangle[1]] - scale * p[triangle[0]];
    const Vec3d b = scale * p[triangle[2]] - scale * p[triangle[1]];
    const Vec3d c = scale * p[triangle[0]] - scale * p[triangle[2]];
    Shape s{0.5 * glm::length(glm::cross(a, b)),
            std::max({glm::dot(a, a), glm::dot(b, b), glm::dot(c, c)})};
    if (!(s.area > 0.5 * least_height * std::sqrt(s.longest_squared))) s.area = 0.0;
    return s;
}

double wanted(const Shape& s, AtlasKind kind) {
    if (kind == AtlasKind::uniform) return 1.0;
    return kind == AtlasKind::area ? s.area : s.longest_squared;
}

}  // namespace

double unit_scale(const Mesh& mesh) {
    const Box3 box = bounding_box(mesh);
    const Vec3d reach = glm::max(glm::abs(box.low), glm::abs(box.high));
    const double largest = std::max({reach.x, reach.y, reach.z});
    if (!(largest > 0.0) || !std::isfinite(largest)) return 1.0;
    return std::ldexp(1.0, std::clamp(-std::ilogb(largest), -1000, 1000));
}

std::vector<float> triangle_weights(const Mesh& mesh, AtlasKind kind) {
    const double scale = unit_scale(mesh);
    std::vector<double> weights;
    weights.reserve(mesh.triangles.size());
    double largest = 0.0;
    for (const Triangle& triangle : mesh.triangles) {
        const Shape s = shape(mesh, triangle, scale);
        weights.push_back(s.area > 0.0 ? wanted(s, kind) : 0.0);
        largest = std::max(largest, weights.back());
    }
    std::vector<float> relative(weights.size(), 0.0f);
    for (std::size_t t = 0; t < weights.size(); ++t)
        if (weights[t] > 0.0) relative[t] = static_cast<float>(weights[t] / largest);
    return relative;
}

TriangleAreas triangle_areas(const Mesh& mesh) {
    const double scale = unit_scale(mesh);
    TriangleAreas result{{}, 1.0 / scale};
    result.areas.reserve(mesh.triangles.size());
    for (const Triangle& triangle : mesh.triangles)
        result.areas.push_back(shape(mesh, triangle, scale).area);
    return result;
}

}  // namespace burl
