#include "atlas/shape/point_masks.h"

#include <algorithm>
#include <cmath>

#include "atlas/base/random_unit.h"
#include "atlas/mesh/connectivity.h"

namespace burl {

namespace {

/// The mean of a triangle's corner attributes by the weights of a point.
template <class Value>
Value at_point(const std::vector<Value>& attributes, const ShapeScene& shape,
               const ShapePoint& point) {
    const Vec3d weights = shape.weights_at(point.triangle, point.position);
    Value sum(0);
    for (int k = 0; k < 3; ++k)
        sum += typename Value::value_type(weights[k]) *
               attributes[3 * std::size_t{point.triangle} + std::size_t(k)];
    return sum;
}

/// The gradients of a component of attributes that are interpolated between corners.
template <class Value>
void attribute_slopes(const std::vector<Value>& attributes, const ShapeScene& shape, int component,
                      std::span<const ShapePoint> points, std::span<Vec3d> slopes) {
    std::ranges::transform(points, slopes.begin(), [&](const ShapePoint& point) {
        Vec3d sum(0.0);
        if (attributes.empty()) return sum;
        const std::array<Vec3d, 3> by_corner = shape.weight_slopes(point.triangle);
        for (std::size_t k = 0; k < 3; ++k)
            sum +=
                double(attributes[3 * std::size_t{point.triangle} + k][component]) * by_corner[k];
        return sum;
    });
}

/// The gradient of the cosine to `direction` at a point.
Vec3d facing_slope(const ShapeScene& shape, const ShapePoint& point, const Vec3d& direction) {
    if (shape.corner_normals().empty()) return Vec3d(0.0);
    const Vec3d weights = shape.weights_at(point.triangle, point.position);
    std::array<Vec3d, 3> normals;
    Vec3d sum(0.0);
    for (std::size_t k = 0; k < 3; ++k) {
        normals[k] = Vec3d(shape.corner_normals()[3 * std::size_t{point.triangle} + k]);
        sum += weights[int(k)] * normals[k];
    }
    const double length = glm::length(sum);
    if (!(length > 0.0 && glm::dot(sum, point.normal) > 0.0)) return Vec3d(0.0);
    // Of direction . n / |n| the derivative along n counts for nothing.
    const Vec3d unit = sum / length, across = direction - glm::dot(direction, unit) * unit;
    const std::array<Vec3d, 3> by_corner = shape.weight_slopes(point.triangle);
    Vec3d slope(0.0);
    for (std::size_t k = 0; k < 3; ++k)
        slope += glm::dot(across, normals[k]) / length * by_corner[k];
    return slope;
}

/// For each triangle the least point number of its connected piece.
std::vector<std::uint32_t> connected_pieces(const Mesh& mesh) {
    DisjointSets sets(mesh.positions.size());
    for (const auto& [a, b, c] : mesh.triangles) sets.join(a, b), sets.join(b, c);
    std::vector<std::uint32_t> pieces(mesh.triangles.size());
    std::ranges::transform(mesh.triangles, pieces.begin(),
                           [&](const Triangle& t) { return sets.find(t[0]); });
    return pieces;
}

std::vector<std::uint32_t> parts_of_triangles(const Mesh& mesh) {
    std::vector<std::uint32_t> pieces(mesh.triangles.size(), 0);
    for (std::uint32_t part = 0; part < mesh.parts.size(); ++part) {
        const Part& run = mesh.parts[part];
        std::fill_n(pieces.begin() + run.first_triangle, run.triangle_count, part);
    }
    return pieces;
}

}  // namespace

void facing(std::span<const ShapePoint> points, const Vec3d& direction, std::span<float> values) {
    std::ranges::transform(points, values.begin(), [&](const ShapePoint& point) {
        return float(std::clamp(glm::dot(point.shading, direction), -1.0, 1.0));
    });
}

void facing_slopes(const ShapeScene& shape, std::span<const ShapePoint> points,
                   const Vec3d& direction, std::span<Vec3d> slopes) {
    std::ranges::transform(points, slopes.begin(), [&](const ShapePoint& point) {
        return facing_slope(shape, point, direction);
    });
}

void height_in_box(std::span<const ShapePoint> points, const Box3& box, int axis,
                   std::span<float> values) {
    const double low = box.low[axis], high = box.high[axis];
    std::ranges::transform(points, values.begin(), [&](const ShapePoint& point) {
        if (!(low < high)) return 0.5f;
        // Halves, so that no difference overflows.
        const double above = 0.5 * point.position[axis] - 0.5 * low;
        return float(std::clamp(above / (0.5 * high - 0.5 * low), 0.0, 1.0));
    });
}

Vec3d height_slope(const Box3& box, int axis) {
    Vec3d slope(0.0);
    const double low = box.low[axis], high = box.high[axis];
    if (low < high) slope[axis] = 0.5 / (0.5 * high - 0.5 * low);
    return slope;
}

std::vector<float> piece_values(const Mesh& mesh, PieceKind kind, std::uint64_t seed) {
    const std::vector<std::uint32_t> pieces =
        kind == PieceKind::part ? parts_of_triangles(mesh) : connected_pieces(mesh);
    std::vector<float> values(pieces.size());
    std::ranges::transform(pieces, values.begin(), [&](std::uint32_t piece) {
        return float(0x1p-24 * std::floor(0x1p24 * random_unit(seed, piece)));  // never rounds to 1
    });
    return values;
}

void vertex_color(const Mesh& mesh, const ShapeScene& shape, std::span<const ShapePoint> points,
                  std::span<Vec4f> values) {
    const auto& colors = mesh.corners.colors;
    std::ranges::transform(points, values.begin(), [&](const ShapePoint& point) {
        return colors.empty() ? Vec4f(1.0f) : at_point(colors, shape, point);
    });
}

void vertex_uv(const Mesh& mesh, const ShapeScene& shape, std::span<const ShapePoint> points,
               std::span<Vec2d> values) {
    const auto& uvs = mesh.corners.uvs;
    std::ranges::transform(points, values.begin(), [&](const ShapePoint& point) {
        return uvs.empty() ? Vec2d(0.0) : at_point(uvs, shape, point);
    });
}

void vertex_color_slopes(const Mesh& mesh, const ShapeScene& shape, int component,
                         std::span<const ShapePoint> points, std::span<Vec3d> slopes) {
    attribute_slopes(mesh.corners.colors, shape, component, points, slopes);
}

void vertex_uv_slopes(const Mesh& mesh, const ShapeScene& shape, int component,
                      std::span<const ShapePoint> points, std::span<Vec3d> slopes) {
    attribute_slopes(mesh.corners.uvs, shape, component, points, slopes);
}

}  // namespace burl
