// With the corners of a triangle at a and b from its first one, the columns of its map's matrix are
// J1 = a / x1 and J2 = (b - x2 J1) / y2; its energy is |J|^2 (1 + 1 / det J^2) / 4.
#include <algorithm>
#include <cmath>

#include "atlas/chart/stretch.h"
#include "atlas/outline/free_map.h"

namespace burl {
namespace {

/// Smallest weight of a triangle relative to the mean triangle's.
constexpr double least_weight = 1e-6;
/// Height over longest side below which a triangle is a sliver: it counts as one of that height.
constexpr double least_height = 1e-3;

}  // namespace

IsometryEnergy::IsometryEnergy(const Patch& patch) {
    triangles_.reserve(patch.triangles.size());
    double sum = 0.0;
    for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
        const Triangle& v = patch.triangles[t];
        const Vec3d e1 = patch.points[v[1]] - patch.points[v[0]];
        const Vec3d e2 = patch.points[v[2]] - patch.points[v[0]];
        const double longest =
            std::sqrt(std::max({glm::dot(e1, e1), glm::dot(e2, e2), glm::dot(e2 - e1, e2 - e1)}));
        const double least = std::max(least_height * longest, 1e-150);
        const double x1 = std::max(glm::length(e1), least);
        const double twice = glm::length(glm::cross(e1, e2));
        const double weight = twice * (patch.faces[t] == not_in_mesh ? fan_weight : 1.0);
        triangles_.push_back({v, x1, glm::dot(e1, e2) / x1, std::max(twice / x1, least), weight});
        sum += weight;
    }
    const double floor = least_weight * sum / double(triangles_.size());
    double all = 0.0;
    for (Flat& f : triangles_) all += f.weight = std::max(f.weight, floor);
    for (Flat& f : triangles_) f.weight /= all;
}

double IsometryEnergy::operator()(std::span<const Vec2d> places, std::span<Vec2d> gradient) const {
    std::fill(gradient.begin(), gradient.end(), Vec2d(0.0));
    double sum = 0.0;
    for (const Flat& f : triangles_) {
        const Vec2d& first = places[f.vertices[0]];
        const Vec2d a = places[f.vertices[1]] - first, b = places[f.vertices[2]] - first;
        const double det = cross(a, b) / (f.x1 * f.y2), inverse = 1.0 / (det * det);
        if (!(det > 0.0)) return std::numeric_limits<double>::infinity();
        const Vec2d j1 = a / f.x1, j2 = (b - f.x2 * j1) / f.y2;
        const double norm = glm::dot(j1, j1) + glm::dot(j2, j2);
        sum += f.weight * norm * (1.0 + inverse);
        const double by_norm = 0.5 * f.weight * (1.0 + inverse);
        const double by_cross = -0.5 * f.weight * norm * inverse / (det * f.x1 * f.y2);
        const Vec2d by_j2 = by_norm / f.y2 * j2;
        const Vec2d by_a = (by_norm * j1 - f.x2 * by_j2) / f.x1 + by_cross * Vec2d(b.y, -b.x);
        const Vec2d by_b = by_j2 + by_cross * Vec2d(-a.y, a.x);
        gradient[f.vertices[0]] -= by_a + by_b;
        gradient[f.vertices[1]] += by_a;
        gradient[f.vertices[2]] += by_b;
    }
    return 0.25 * sum;
}

double IsometryEnergy::step_to_collapse(std::span<const Vec2d> places,
                                        std::span<const Vec2d> direction) const {
    double step = std::numeric_limits<double>::infinity();
    for (const Flat& f : triangles_) {
        const auto [i, j, k] = f.vertices;
        const Vec2d a = places[j] - places[i], b = places[k] - places[i];
        const Vec2d da = direction[j] - direction[i], db = direction[k] - direction[i];
        const double c0 = cross(a, b), c1 = cross(a, db) + cross(da, b), c2 = cross(da, db);
        // Where c0 + c1 t + c2 t^2 is positive up to the step found so far there is no root before.
        if (c0 + std::min(c1, 0.0) * step + std::min(c2, 0.0) * step * step > 0.0) continue;
        step = std::min(step, first_root(c0, c1, c2));
    }
    return step;
}

}  // namespace burl
