// Weights of the uniform, area-weighted and length-weighted atlas (Carr & Hart 2001, section 4).
#include "atlas/weights.h"

#include <algorithm>
#include <cmath>

namespace burl {

namespace {

struct Shape {
    double area = 0.0, longest_squared = 0.0;
};

/// Power of two that brings the box's longest side near 1: squares neither overflow nor vanish.
double unit_scale(double longest_side) {
    if (!(longest_side > 0.0) || !std::isfinite(longest_side)) return 1.0;
    return std::ldexp(1.0, std::clamp(-std::ilogb(longest_side), -1000, 1000));
}

Shape shape(const Mesh& mesh, const Triangle& triangle, double scale) {
    const auto& p = mesh.positions;
    const Vec3d a = scale * (p[triangle[1]] - p[triangle[0]]);
    const Vec3d b = scale * (p[triangle[2]] - p[triangle[1]]);
    const Vec3d c = scale * (p[triangle[0]] - p[triangle[2]]);
    return {0.5 * glm::length(glm::cross(a, b)),
            std::max({glm::dot(a, a), glm::dot(b, b), glm::dot(c, c)})};
}

bool has_area(const Shape& s) {
    constexpr double least_height = 1e-14;
    return s.area > 0.5 * least_height * std::sqrt(s.longest_squared);
}

double wanted(const Shape& s, AtlasKind kind) {
    if (kind == AtlasKind::uniform) return 1.0;
    return kind == AtlasKind::area ? s.area : s.longest_squared;
}

}  // namespace

std::vector<float> triangle_weights(const Mesh& mesh, AtlasKind kind) {
    const double scale = unit_scale(bounding_box(mesh).longest_side());
    std::vector<double> weights;
    weights.reserve(mesh.triangles.size());
    double largest = 0.0;
    for (const Triangle& triangle : mesh.triangles) {
        const Shape s = shape(mesh, triangle, scale);
        weights.push_back(has_area(s) ? wanted(s, kind) : 0.0);
        largest = std::max(largest, weights.back());
    }
    std::vector<float> relative(weights.size(), 0.0f);
    for (std::size_t t = 0; t < weights.size(); ++t)
        if (weights[t] > 0.0) relative[t] = static_cast<float>(weights[t] / largest);
    return relative;
}

std::vector<bool> zero_area_triangles(const Mesh& mesh) {
    const double scale = unit_scale(bounding_box(mesh).longest_side());
    std::vector<bool> zero;
    zero.reserve(mesh.triangles.size());
    for (const Triangle& triangle : mesh.triangles)
        zero.push_back(!has_area(shape(mesh, triangle, scale)));
    return zero;
}

}  // namespace burl
