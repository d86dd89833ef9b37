// Derivatives of a triangle's map: with (u,v) of the corners q0, q1, q2 and det = twice the
// triangle's area in the unit square, ds/du = (p1 (v2-v0) + p2 (v0-v1)) / det, ds/dv = (p1 (u0-u2)
// + p2 (u1-u0)) / det.
#include "atlas/chart/stretch.h"

#include <algorithm>
#include <cmath>

namespace burl {
namespace {

/// Smallest weight of a triangle relative to the mean triangle's, so that triangles without area
/// are kept from flipping, too.
constexpr double least_weight = 1e-6;

/// Height over longest side below which a triangle is a sliver: a small move of a corner gives it
/// any anisotropy, and next to no area shows it.
constexpr double sliver = 0.01;

}  // namespace

double first_root(double a, double b, double c) {
    const double infinity = std::numeric_limits<double>::infinity();
    const double under = b * b - 4.0 * a * c;
    if (under < 0.0) return infinity;
    // Both roots without cancellation: q / c and a / q.
    const double q = -0.5 * (b + std::copysign(std::sqrt(under), b));
    double root = infinity;
    if (c != 0.0 && q / c > 0.0) root = q / c;
    if (q != 0.0 && a / q > 0.0) root = std::min(root, a / q);
    return root;
}

double Stretch::distortion() const {
    return finite() ? std::sqrt(x) * std::sqrt(y) / (area * area)
                    : std::numeric_limits<double>::infinity();
}

double Stretch::best_aspect() const {
    return std::sqrt(x / y);
}

StretchMeasure::StretchMeasure(const Patch& patch) {
    triangles_.reserve(patch.triangles.size());
    for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
        const Triangle& v = patch.triangles[t];
        const Vec3d e1 = patch.points[v[1]] - patch.points[v[0]];
        const Vec3d e2 = patch.points[v[2]] - patch.points[v[0]];
        const double length = glm::length(e1), twice = glm::length(glm::cross(e1, e2));
        const Vec2d p2 = length > 0.0 ? Vec2d(glm::dot(e1, e2) / length, twice / length)
                                      : Vec2d(glm::length(e2), 0.0);
        const bool fan = patch.faces[t] == not_in_mesh;
        const double longest =
            std::max({length * length, glm::dot(e2, e2), glm::dot(e2 - e1, e2 - e1)});
        const bool counts = !fan && twice > sliver * longest;
        triangles_.push_back({v, Vec2d(length, 0.0), p2, 0.5 * twice * (fan ? fan_weight : 1.0),
                              counts ? 0.5 * twice : 0.0});
        area_ += triangles_.back().weight;
    }
    const double floor = least_weight * area_ / double(triangles_.size());
    area_ = 0.0;
    for (Flat& flat : triangles_) area_ += flat.weight = std::max(flat.weight, floor);
}

Stretch StretchMeasure::operator()(std::span<const Vec2d> uv) const {
    Stretch result{0.0, 0.0, area_};
    for (const Flat& f : triangles_) {
        const Vec2d a = uv[f.vertices[1]] - uv[f.vertices[0]];
        const Vec2d b = uv[f.vertices[2]] - uv[f.vertices[0]];
        const double det = cross(a, b);
        if (!(det > 0.0)) return {};
        const Vec2d du = (f.p1 * b.y - f.p2 * a.y) / det, dv = (f.p2 * a.x - f.p1 * b.x) / det;
        result.x += f.weight * glm::dot(du, du);
        result.y += f.weight * glm::dot(dv, dv);
    }
    if (!std::isfinite(result.x) || !std::isfinite(result.y)) return {};
    return result;
}

std::vector<double> StretchMeasure::of_triangles(std::span<const Vec2d> uv, double aspect) const {
    std::vector<double> result;
    result.reserve(triangles_.size());
    for (const Flat& f : triangles_) {
        const Vec2d a = uv[f.vertices[1]] - uv[f.vertices[0]];
        const Vec2d b = uv[f.vertices[2]] - uv[f.vertices[0]];
        const double det = cross(a, b);
        const Vec2d du = (f.p1 * b.y - f.p2 * a.y) / det, dv = (f.p2 * a.x - f.p1 * b.x) / det;
        result.push_back(std::sqrt(0.5 * (glm::dot(du, du) / aspect + glm::dot(dv, dv) * aspect)));
    }
    return result;
}

std::vector<Vec2d> StretchMeasure::gradient(std::span<const Vec2d> uv, double factor_x,
                                            double factor_y) const {
    std::vector<Vec2d> result(uv.size(), Vec2d(0.0));
    for (const Flat& f : triangles_) {
        const Vec2d a = uv[f.vertices[1]] - uv[f.vertices[0]];
        const Vec2d b = uv[f.vertices[2]] - uv[f.vertices[0]];
        const double det = cross(a, b);
        const Vec2d du = (f.p1 * b.y - f.p2 * a.y) / det, dv = (f.p2 * a.x - f.p1 * b.x) / det;
        const double x = factor_x * f.weight, y = factor_y * f.weight;
        const double by_det = -2.0 * (x * glm::dot(du, du) + y * glm::dot(dv, dv)) / det;
        const double x1 = 2.0 * x * glm::dot(du, f.p1) / det;
        const double x2 = 2.0 * x * glm::dot(du, f.p2) / det;
        const double y1 = 2.0 * y * glm::dot(dv, f.p1) / det;
        const double y2 = 2.0 * y * glm::dot(dv, f.p2) / det;
        // det = a.x b.y - a.y b.x
        const Vec2d by_a(y2 + by_det * b.y, -x2 - by_det * b.x);
        const Vec2d by_b(-y1 - by_det * a.y, x1 + by_det * a.x);
        result[f.vertices[0]] -= by_a + by_b;
        result[f.vertices[1]] += by_a;
        result[f.vertices[2]] += by_b;
    }
    return result;
}

// k = (|du|^2 / aspect + |dv|^2 aspect) det / (4 area), and du det and dv det are linear in a and
// b.
StretchMeasure::Conformal StretchMeasure::conformal(const Flat& f, const Vec2d& a, const Vec2d& b,
                                                    double aspect) {
    const double det = cross(a, b), share = 1.0 / (4.0 * f.area * det);
    const Vec2d u = f.p1 * b.y - f.p2 * a.y, v = f.p2 * a.x - f.p1 * b.x;
    const double k = share * (glm::dot(u, u) / aspect + glm::dot(v, v) * aspect);
    const Vec2d by_u = 2.0 * share / aspect * u, by_v = 2.0 * share * aspect * v;
    const double by_det = -k / det;
    return {k,
            {glm::dot(by_v, f.p2) + by_det * b.y, -glm::dot(by_u, f.p2) - by_det * b.x},
            {-glm::dot(by_v, f.p1) - by_det * a.y, glm::dot(by_u, f.p1) + by_det * a.x}};
}

double StretchMeasure::anisotropy(std::span<const Vec2d> uv, double aspect) const {
    double sum = 0.0, area = 0.0;
    for (const Flat& f : triangles_) {
        if (f.area == 0.0) continue;
        const Vec2d &first = uv[f.vertices[0]], &a = uv[f.vertices[1]], &b = uv[f.vertices[2]];
        const double k = conformal(f, a - first, b - first, aspect).k;
        sum += f.area * k * k;
        area += f.area;
    }
    return (sum + std::max(area_ - area, 0.0)) / area_;
}

void StretchMeasure::add_anisotropy_gradient(std::span<const Vec2d> uv, double aspect,
                                             double factor, std::span<Vec2d> gradient) const {
    for (const Flat& f : triangles_) {
        if (f.area == 0.0) continue;
        const Vec2d &first = uv[f.vertices[0]], &a = uv[f.vertices[1]], &b = uv[f.vertices[2]];
        const Conformal c = conformal(f, a - first, b - first, aspect);
        const double outer = 2.0 * factor * c.k * f.area / area_;
        gradient[f.vertices[0]] -= outer * (c.by_a + c.by_b);
        gradient[f.vertices[1]] += outer * c.by_a;
        gradient[f.vertices[2]] += outer * c.by_b;
    }
}

double StretchMeasure::step_to_collapse(std::span<const Vec2d> uv,
                                        std::span<const Vec2d> direction) const {
    double step = std::numeric_limits<double>::infinity();
    for (const Flat& f : triangles_) {
        const auto [i, j, k] = f.vertices;
        const Vec2d a = uv[j] - uv[i], b = uv[k] - uv[i];
        const Vec2d da = direction[j] - direction[i], db = direction[k] - direction[i];
        step = std::min(step, first_root(cross(a, b), cross(a, db) + cross(da, b), cross(da, db)));
    }
    return step;
}

}  // namespace burl
