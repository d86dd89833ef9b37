#include "atlas/shape/disc_overlap.h"

#include <algorithm>
#include <cmath>

namespace burl {

namespace {

struct PlanePiece {
    double area = 0.0;
    Vec2d moment{0.0};
    PlanePiece& operator+=(const PlanePiece& p) {
        area += p.area, moment += p.moment;
        return *this;
    }
};

PlanePiece triangle_from_origin(const Vec2d& a, const Vec2d& b) {
    const double area = 0.5 * cross(a, b);
    return {area, area / 3.0 * (a + b)};
}

/// Angle from one unit vector to another, in (-pi, pi), to about 1e-13: halved until
/// it is small and summed up as the series of the arctangent, so that its bits are not the C
/// library's.
double angle_between(const Vec2d& from, const Vec2d& to) {
    Vec2d turn(glm::dot(from, to), cross(from, to));
    if (turn.y == 0.0) return 0.0;  // also of half a turn, either way round
    double parts = 1.0;
    for (; std::abs(turn.y) > 0.2 * turn.x && parts < 64.0; parts *= 2.0)
        turn = glm::normalize(turn + Vec2d(1.0, 0.0));
    const double t = turn.y / turn.x, square = t * t;
    double sum = 0.0;
    for (int k = 17; k >= 1; k -= 2) sum = 1.0 / k - square * sum;
    return parts * t * sum;
}

/// The sector of the disc between the directions of `a` and `b`, less than half a turn apart.
PlanePiece sector(const Vec2d& a, const Vec2d& b, double radius) {
    const double length_a = glm::length(a), length_b = glm::length(b);
    if (length_a == 0.0 || length_b == 0.0) return {};
    const Vec2d from = a / length_a, to = b / length_b;
    return {0.5 * radius * radius * angle_between(from, to),
            radius * radius * radius / 3.0 * Vec2d(to.y - from.y, from.x - to.x)};
}

/// The piece that the edge from a to b adds: a triangle within the disc, sectors outside it.
PlanePiece below_edge(const Vec2d& a, const Vec2d& b, double radius) {
    const Vec2d along = b - a;
    const double square = glm::dot(along, along), half = glm::dot(a, along);
    const double root = half * half - square * (glm::dot(a, a) - radius * radius);
    if (!(root > 0.0) || square == 0.0) return sector(a, b, radius);
    const double first = std::clamp((-half - std::sqrt(root)) / square, 0.0, 1.0);
    const double last = std::clamp((-half + std::sqrt(root)) / square, 0.0, 1.0);
    if (!(first < last)) return sector(a, b, radius);
    const Vec2d in = a + first * along, out = a + last * along;
    PlanePiece piece = triangle_from_origin(in, out);
    if (first > 0.0) piece += sector(a, in, radius);
    if (last < 1.0) piece += sector(out, b, radius);
    return piece;
}

/// The whole triangle, which is counter-clockwise about `normal`.
SurfacePiece whole(const std::array<Vec3d, 3>& corners, const Vec3d& normal) {
    const Vec3d twice = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double area = 0.5 * glm::dot(twice, normal);
    return {area, area / 3.0 * (corners[0] + corners[1] + corners[2])};
}

}  // namespace

SurfacePiece piece_in_ball(const std::array<Vec3d, 3>& corners, const Vec3d& normal,
                           double radius) {
    const auto inside = [&](const Vec3d& p) { return glm::dot(p, p) <= radius * radius; };
    if (std::ranges::all_of(corners, inside)) return whole(corners, normal);
    const Vec3d centre = glm::dot(corners[0], normal) * normal;
    const double square = radius * radius - glm::dot(centre, centre);
    if (!(square > 0.0)) return {};
    const Vec3d x = glm::normalize(corners[1] - corners[0]), y = glm::cross(normal, x);
    std::array<Vec2d, 3> places;
    for (std::size_t k = 0; k < 3; ++k)
        places[k] = {glm::dot(corners[k] - centre, x), glm::dot(corners[k] - centre, y)};
    PlanePiece sum;
    for (std::size_t k = 0; k < 3; ++k)
        sum += below_edge(places[k], places[(k + 1) % 3], std::sqrt(square));
    const double area = std::max(sum.area, 0.0);  // rounding
    return {area, area * centre + sum.moment.x * x + sum.moment.y * y};
}

}  // namespace burl
