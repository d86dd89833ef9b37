#include "atlas/shape/surface_lattice.h"

#include <algorithm>
#include <cmath>

#include "atlas/base/each_index.h"
#include "atlas/shape/triangle_slope.h"

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

/// Points that are worked out between two looks for a request to stop.
constexpr std::size_t points_at_once = 1024;

/// The corners of triangles (3t+k) at each point, in their order.
class PointCorners {
  public:
    PointCorners(std::span<const Triangle> triangles, std::size_t points)
        : begin_(points + 1, 0), corners_(3 * triangles.size()) {
        for (const Triangle& triangle : triangles)
            for (const std::uint32_t point : triangle) ++begin_[point + 1];
        for (std::size_t p = 0; p < points; ++p) begin_[p + 1] += begin_[p];
        std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
        for (std::size_t i = 0; i < corners_.size(); ++i)
            corners_[next[triangles[i / 3][i % 3]]++] = std::uint32_t(i);
    }
    std::span<const std::uint32_t> at(std::uint32_t point) const {
        return std::span(corners_).subspan(begin_[point], begin_[point + 1] - begin_[point]);
    }

  private:
    std::vector<std::size_t> begin_;
    std::vector<std::uint32_t> corners_;
};

/// The mean side of a texel, in mesh units.
double mean_texel(const SolidAtlas& solid, const ShapeScene& shape) {
    double area = 0.0, texels = 1.0;
    for (const double one : shape.areas()) area += one;
    for (const Span& span : solid.spans) texels += double(span.count);
    return shape.diagonal() * std::sqrt(area / texels);
}

}  // namespace

ShownPlace place_shown(const SolidAtlas& solid, const TexelOwners& owners, const ShapeScene& shape,
                       std::uint32_t x, std::uint32_t y, std::uint32_t map) {
    const Vec3d point = solid.maps[map](x, y);
    ShownPlace place{solid.triangle_of(map), {}};
    place.weights = shape.weights_at(place.triangle, point);
    const bool inside = place.weights.x >= 0.0 && place.weights.y >= 0.0 && place.weights.z >= 0.0;
    const std::uint32_t owner = inside ? place.triangle : owners(x, y, map);
    if (owner != place.triangle) place = {owner, shape.weights_at(owner, point)};
    return place;
}

SurfaceLattice::SurfaceLattice(const SolidAtlas& solid, const TexelOwners& owners,
                               const ShapeScene& shape, const PointMask& mask,
                               const LatticeOptions& options) {
    choose_sides(solid, owners, shape, options);
    begin_.push_back(0);
    for (const std::uint32_t side : sides_) begin_.push_back(begin_.back() + point_count(side));
    least_ = 0.1 * mean_texel(solid, shape);
    take_values(shape, mask, options.stop);
    if (options.for_slopes && !options.stop.stop_requested()) mend_corners(shape);
}

void SurfaceLattice::choose_sides(const SolidAtlas& solid, const TexelOwners& owners,
                                  const ShapeScene& shape, const LatticeOptions& options) {
    const double square = shape.diagonal() * shape.diagonal();
    sides_.assign(shape.triangles().size(), 0);
    std::vector<std::uint64_t> texels(sides_.size(), 0);
    for (std::uint32_t y = 0; y < solid.size; ++y)
        for (const Span& span : solid.row(y))
            for (std::uint32_t x = span.x; x < span.x + span.count; ++x) {
                const std::uint32_t t = place_shown(solid, owners, shape, x, y, span.map).triangle;
                const double side =
                    side_for(solid.maps[span.map], square * shape.areas()[t], options.spacing);
                sides_[t] = std::max(sides_[t], std::uint32_t(side));
                ++texels[t];
            }
    covered_.resize(sides_.size());
    for (std::size_t t = 0; t < sides_.size(); ++t) {
        covered_[t] = sides_[t] > 0 && 2 * point_count(sides_[t]) <= texels[t];
        if (!covered_[t] && !options.for_slopes) sides_[t] = 0;
    }
}

void SurfaceLattice::take_values(const ShapeScene& shape, const PointMask& mask,
                                 const std::stop_token& stop) {
    values_.resize(begin_.back());
    const auto work = [&](std::size_t t) {
        if (sides_[t] == 0) return;
        const auto points = lattice_points(shape, std::uint32_t(t), sides_[t]);
        for (std::size_t done = 0; done < points.size() && !stop.stop_requested();
             done += points_at_once) {
            const std::size_t count = std::min(points_at_once, points.size() - done);
            mask(std::span(points).subspan(done, count),
                 std::span(values_).subspan(begin_[t] + done, count));
        }
    };
    for_each_index(sides_.size(), work, 4);
}

float SurfaceLattice::value(std::uint32_t triangle, const LatticePlace& at) const {
    return values_[begin_[triangle] + point_number(sides_[triangle], at[0], at[1])];
}

LatticeCell SurfaceLattice::at(std::uint32_t triangle, const Vec3d& weights) const {
    const std::uint32_t side = sides_[triangle];
    const Vec3d place = double(side) * onto_triangle(weights);
    const double u = std::min(place.y, double(side)), v = std::min(place.z, double(side) - u);
    const auto i = std::min(std::uint32_t(u), side - 1);
    const auto j = std::min(std::uint32_t(v), side - 1 - i);
    const double a = u - i, b = v - j;
    LatticeCell cell;
    if (a + b <= 1.0 || i + j + 1 >= side)
        cell = {{std::max(1.0 - a - b, 0.0), a, b}, {{{i, j}, {i + 1, j}, {i, j + 1}}}};
    else
        cell = {{a + b - 1.0, 1.0 - b, 1.0 - a}, {{{i + 1, j + 1}, {i + 1, j}, {i, j + 1}}}};
    for (int k = 0; k < 3; ++k) cell.values[k] = value(triangle, cell.places[std::size_t(k)]);
    return cell;
}

/// The change of the mask over a cell along one axis, at a lattice point.
double SurfaceLattice::change(std::uint32_t triangle, const LatticePlace& at,
                              std::size_t axis) const {
    const std::uint32_t side = sides_[triangle];
    LatticePlace low = at, high = at;
    if (at[0] + at[1] < side)
        ++high[axis];
    else if (at[axis] == 0)  // the corner that the other axis ends in: beside it
        --low[1 - axis], --high[1 - axis], ++high[axis];
    if (at[axis] > 0) --low[axis];
    return (double(value(triangle, high)) - double(value(triangle, low))) /
           double(high[axis] - low[axis]);
}

/// The gradient at a cell by the triangle's own values.
Vec3d SurfaceLattice::own_slope(std::uint32_t triangle, const LatticeCell& cell) const {
    Vec2d changes(0.0);
    for (int k = 0; k < 3; ++k)
        for (std::size_t axis = 0; axis < 2; ++axis)
            changes[int(axis)] +=
                cell.weights[k] * change(triangle, cell.places[std::size_t(k)], axis);
    const auto& [b, c] = edges_[triangle];
    const double cells = double(sides_[triangle]);
    return gradient_along({b / cells, c / cells}, changes, least_);
}

Vec3d SurfaceLattice::slope(std::uint32_t triangle, const Vec3d& weights) const {
    const Vec3d on = onto_triangle(weights);
    Vec3d slope = own_slope(triangle, at(triangle, on));
    for (int k = 0; k < 3; ++k) slope += on[k] * Vec3d(mends_[3 * triangle + std::size_t(k)]);
    return slope;
}

/// Sets what the slopes of triangles lack, at their corners, of the means of all that meet there:
/// each counts by its area and by how much it faces the same way, from 60 degrees on not at all.
void SurfaceLattice::mend_corners(const ShapeScene& shape) {
    const std::span<const Triangle> triangles = shape.triangles();
    edges_.resize(triangles.size());
    std::vector<Vec3d> own(3 * triangles.size(), Vec3d(0.0));
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        const auto& [a, b, c] = triangles[t];
        edges_[t] = {shape.diagonal() * (shape.points()[b] - shape.points()[a]),
                     shape.diagonal() * (shape.points()[c] - shape.points()[a])};
        if (sides_[t] == 0) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            Vec3d corner(0.0);
            corner[int(k)] = 1.0;
            own[3 * t + k] = own_slope(t, at(t, corner));
        }
    }
    const PointCorners corners(triangles, shape.points().size());
    mends_.assign(own.size(), Vec3f(0.0f));
    const auto mend = [&](std::size_t i) {
        const std::size_t t = i / 3;
        if (sides_[t] == 0) return;
        Vec3d sum(0.0);
        double weights = 0.0;
        for (const std::uint32_t j : corners.at(triangles[t][i % 3])) {
            const double facing = glm::dot(shape.normals()[t], shape.normals()[j / 3]) - 0.5;
            if (sides_[j / 3] == 0 || !(facing > 0.0)) continue;
            sum += facing * shape.areas()[j / 3] * own[j];
            weights += facing * shape.areas()[j / 3];
        }
        if (weights > 0.0) mends_[i] = Vec3f(sum / weights - own[i]);
    };
    for_each_index(mends_.size(), mend);
}

}  // namespace burl
