#include "atlas/shape/surface_lattice.h"

#include <algorithm>
#include <cmath>

#include "atlas/base/each_index.h"

namespace burl {

namespace {

constexpr double longest_side = 4096.0;  ///< of a lattice, in cells

/// Number of points of a lattice with `side` cells along each edge.
std::size_t point_count(std::uint32_t side) {
    return side == 0 ? 0 : (std::size_t{side} + 1) * (side + 2) / 2;
}

/// Number of the point i cells from the first edge and j cells along its line, 0 <= i + j <= side.
std::size_t point_number(std::uint32_t side, std::uint32_t i, std::uint32_t j) {
    return std::size_t{i} * (side + 1) - std::size_t{i} * (i - 1) / 2 + j;
}

/// Cells along the edges of a triangle that this map shows, about `spacing` texels each.
double side_for(const TexelMap& map, double area, double spacing) {
    const double texel = glm::length(glm::cross(map.step_x, map.step_y));
    const double side = std::ceil(std::sqrt(2.0 * area / texel) / spacing);
    return side >= 1.0 && std::isfinite(side) ? std::min(side, longest_side) : 1.0;
}

std::vector<ShapePoint> lattice_points(const ShapeScene& shape, std::uint32_t triangle,
                                       std::uint32_t side) {
    std::vector<ShapePoint> points;
    for (std::uint32_t i = 0; i <= side; ++i)
        for (std::uint32_t j = 0; i + j <= side; ++j)
            points.push_back(shape.surface_point(
                triangle, Vec3d(double(side - i - j), double(i), double(j)) / double(side)));
    return points;
}

}  // namespace

SurfaceLattice::SurfaceLattice(const SolidAtlas& solid, const ShapeScene& shape,
                               const PointMask& mask, double spacing) {
    choose_sides(solid, shape, spacing);
    begin_.push_back(0);
    for (const std::uint32_t side : sides_) begin_.push_back(begin_.back() + point_count(side));
    take_values(shape, mask);
}

void SurfaceLattice::choose_sides(const SolidAtlas& solid, const ShapeScene& shape,
                                  double spacing) {
    const double square = shape.diagonal() * shape.diagonal();
    sides_.assign(shape.triangles().size(), 0);
    std::vector<std::uint64_t> texels(sides_.size(), 0);
    for (const Span& span : solid.spans) {
        const std::uint32_t t = solid.triangle_of(span.map);
        const double side = side_for(solid.maps[span.map], square * shape.areas()[t], spacing);
        sides_[t] = std::max(sides_[t], std::uint32_t(side));
        texels[t] += span.count;
    }
    for (std::size_t t = 0; t < sides_.size(); ++t)
        if (2 * point_count(sides_[t]) > texels[t]) sides_[t] = 0;
}

void SurfaceLattice::take_values(const ShapeScene& shape, const PointMask& mask) {
    values_.resize(begin_.back());
    const auto work = [&](std::size_t t) {
        if (sides_[t] == 0) return;
        const auto points = lattice_points(shape, std::uint32_t(t), sides_[t]);
        mask(points, std::span(values_).subspan(begin_[t], points.size()));
    };
    for_each_index(sides_.size(), work, 4);
}

float SurfaceLattice::value(std::uint32_t triangle, std::uint32_t i, std::uint32_t j) const {
    return values_[begin_[triangle] + point_number(sides_[triangle], i, j)];
}

LatticeCell SurfaceLattice::at(std::uint32_t triangle, const Vec3d& weights) const {
    const std::uint32_t side = sides_[triangle];
    const Vec3d place = double(side) * onto_triangle(weights);
    const double u = std::min(place.y, double(side)), v = std::min(place.z, double(side) - u);
    auto i = std::min(std::uint32_t(u), side - 1);
    auto j = std::min(std::uint32_t(v), side - 1 - i);
    const double a = u - i, b = v - j;
    if (a + b <= 1.0 || i + j + 1 >= side)
        return {{std::max(1.0 - a - b, 0.0), a, b},
                {value(triangle, i, j), value(triangle, i + 1, j), value(triangle, i, j + 1)}};
    return {{a + b - 1.0, 1.0 - b, 1.0 - a},
            {value(triangle, i + 1, j + 1), value(triangle, i + 1, j), value(triangle, i, j + 1)}};
}

}  // namespace burl
