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

}  // namespace burl
