#include "atlas/shape/nearest_surface.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "atlas/shape/triangle_slope.h"

namespace burl {

namespace {

std::array<Vec3d, 3> points_of(const ShapeScene& shape, std::uint32_t triangle) {
    const auto& [a, b, c] = shape.triangles()[triangle];
    return {shape.points()[a], shape.points()[b], shape.points()[c]};
}

/// A place of a triangle, by the weights of its corners, and its squared distance in the unit
/// space.
struct SurfacePlace {
    double square = std::numeric_limits<double>::infinity();
    std::uint32_t triangle = 0;
    Vec3d weights{1.0 / 3.0};

    void take(const SurfacePlace& other) {
        const bool as_near = other.square == square && other.triangle < triangle;
        if (other.square < square || as_near) *this = other;
    }
};

/// The nearest place of a triangle's side k, which runs from corner k to the next one.
SurfacePlace place_on_side(const std::array<Vec3d, 3>& corners, std::size_t k, const Vec3d& p) {
    const std::size_t next = (k + 1) % 3;
    const Vec3d along = corners[next] - corners[k], off = p - corners[k];
    const double square = glm::dot(along, along);
    const double at = square > 0.0 ? std::clamp(glm::dot(off, along) / square, 0.0, 1.0) : 0.0;
    const Vec3d rest = off - at * along;
    SurfacePlace place{glm::dot(rest, rest), 0, Vec3d(0.0)};
    place.weights[int(k)] = 1.0 - at, place.weights[int(next)] = at;
    return place;
}

/// The nearest place of a triangle to a point of the unit space.
SurfacePlace place_on(const ShapeScene& shape, std::uint32_t triangle, const Vec3d& p,
                      const Vec3d& weights) {
    const std::array<Vec3d, 3> corners = points_of(shape, triangle);
    SurfacePlace best;
    if (glm::min(weights.x, glm::min(weights.y, weights.z)) >= 0.0) {
        const double off = glm::dot(p - corners[0], shape.normals()[triangle]);
        best = {off * off, 0, weights};
    } else {
        for (std::size_t k = 0; k < 3; ++k) best.take(place_on_side(corners, k, p));
    }
    best.triangle = triangle;
    return best;
}

/// Two directions perpendicular to a normal and to each other.
std::array<Vec3d, 2> ways_along(const Vec3d& normal) {
    const Vec3d size = glm::abs(normal);
    const Vec3d other = size.x <= size.y && size.x <= size.z ? Vec3d(1, 0, 0)
                        : size.y <= size.z                   ? Vec3d(0, 1, 0)
                                                             : Vec3d(0, 0, 1);
    const Vec3d u = glm::cross(normal, other);
    const Vec3d first = u / std::max(glm::length(u), 0.5);
    return {first, glm::cross(normal, first)};
}

}  // namespace

NearestSurface::NearestSurface(const ShapeScene& shape) : shape_(&shape) {
    std::vector<Box3> boxes(shape.triangles().size());
    for (std::uint32_t t = 0; t < boxes.size(); ++t) boxes[t] = box_of(points_of(shape, t));
    tree_ = build_box_tree(boxes);
}

ShapePoint NearestSurface::operator()(const Vec3d& position) const {
    const Vec3d p = shape_->to_unit(position);
    SurfacePlace best;
    std::vector<std::uint32_t> open;
    if (!tree_.nodes.empty()) open.push_back(0);
    while (!open.empty()) {
        const std::uint32_t number = open.back();
        open.pop_back();
        const BoxNode& node = tree_.nodes[number];
        if (square_distance(node.box, p) > best.square) continue;
        if (node.second != 0) {
            std::array<std::uint32_t, 2> children{number + 1, node.second};
            if (square_distance(tree_.nodes[children[0]].box, p) <
                square_distance(tree_.nodes[children[1]].box, p))
                std::swap(children[0], children[1]);
            open.insert(open.end(), children.begin(), children.end());
            continue;
        }
        for (std::uint32_t i = node.begin; i < node.end; ++i) {
            const std::uint32_t t = tree_.items[i];
            if (shape_->areas()[t] > 0.0)
                best.take(place_on(*shape_, t, p, shape_->weights_at(t, position)));
        }
    }
    return shape_->surface_point(best.triangle, best.weights);
}

void mask_slopes(const NearestSurface& nearest, const ShapeMask& mask,
                 std::span<const ShapePoint> points, double step, std::span<Vec3d> slopes) {
    if (mask.slopes) return mask.slopes(points, slopes);
    std::vector<ShapePoint> places;
    for (const ShapePoint& point : points)
        for (const Vec3d& way : ways_along(point.normal))
            for (const double side : {-step, step}) {
                const ShapePoint there = nearest(point.position + side * way);
                const bool turns = glm::dot(there.normal, point.normal) < 0.5;
                places.push_back(turns ? point : there);
            }
    std::vector<float> values(places.size());
    mask.values(places, values);
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::array<Vec3d, 2> edges;
        Vec2d changes;
        for (std::size_t k = 0; k < 2; ++k) {
            const std::size_t low = 4 * i + 2 * k;
            edges[k] = places[low + 1].position - places[low].position;
            changes[int(k)] = double(values[low + 1]) - double(values[low]);
        }
        slopes[i] = gradient_along(edges, changes, 0.05 * step);
    }
}

}  // namespace burl
