#include "procedural/graph/scattered_shapes.h"

#include <algorithm>
#include <cmath>

#include "atlas/base/elementary.h"
#include "procedural/noise/cell_features.h"

namespace burl {

namespace {

ShapeSample disk(double x, double y) {
    const double away = length_of(x, y);
    if (!(away > 0.0)) return {1.0, 0.0, 0.0};
    return {1.0 - away, -(x / away), -(y / away)};
}

ShapeSample ring(double x, double y) {
    const ShapeSample round = disk(x, y);
    if (round.value < 0.25) return round;
    return {0.5 - round.value, -round.gx, -round.gy};
}

ShapeSample square(double x, double y) {
    constexpr double half = 0.7071067811865476;  // sqrt(1/2)
    const double sx = x < 0.0 ? -1.0 : 1.0, sy = y < 0.0 ? -1.0 : 1.0;
    const double dx = std::abs(x) - half, dy = std::abs(y) - half;
    if (dx > 0.0 && dy > 0.0) {
        const double away = length_of(dx, dy);
        return {-away, -(sx * (dx / away)), -(sy * (dy / away))};
    }
    return dx > dy ? ShapeSample{-dx, -sx, 0.0} : ShapeSample{-dy, 0.0, -sy};
}

/// The mirror image of (x, y) in the line through the origin, 36 degrees from the y axis.
void mirror(double& x, double& y) {
    constexpr double sine36 = 0.5877852522924731, cosine36 = 0.8090169943749475;
    const double twice = 2.0 * (x * cosine36 - y * sine36);
    x = x - twice * cosine36;
    y = y + twice * sine36;
}

/// The distance to the segment from the tip (0, 1) to a notch, where a star's mirror images have
/// been laid upon one another, positive on the origin's side.
ShapeSample star_side(double x, double y) {
    // The notch is 0.381966 = sin 18 / sin 54 degrees from the middle, 36 degrees from the tip.
    constexpr double ex = 0.22451398828979269, ey = -0.6909830056250525;
    constexpr double square = ex * ex + ey * ey;
    const double ahead = y - 1.0;
    const double t = std::min(std::max((x * ex + ahead * ey) / square, 0.0), 1.0);
    const double dx = x - t * ex, dy = ahead - t * ey;
    const double away = length_of(dx, dy), side = ex * ahead - ey * x < 0.0 ? 1.0 : -1.0;
    if (!(away > 0.0)) return {};
    return {side * away, side * (dx / away), side * (dy / away)};
}

ShapeSample star(double x, double y) {
    bool left[3], folded[2];
    for (int k = 0; k < 3; ++k) {
        left[k] = x < 0.0;
        x = std::abs(x);
        if (k == 2) break;
        double image_x = x, image_y = y;
        mirror(image_x, image_y);
        folded[k] = image_x < x;  // beyond the line
        if (folded[k]) x = image_x, y = image_y;
    }
    ShapeSample result = star_side(x, y);
    for (int k = 2; k >= 0; --k) {
        if (k < 2 && folded[k]) mirror(result.gx, result.gy);
        if (left[k]) result.gx = -result.gx;
    }
    return result;
}

/// The lens between circles of radius 5/4 about (-3/4, 0) and (3/4, 0), whose tips are at (0, 1)
/// and (0, -1).
ShapeSample leaf(double x, double y) {
    const double sx = x < 0.0 ? -1.0 : 1.0, sy = y < 0.0 ? -1.0 : 1.0;
    const double ax = std::abs(x), ay = std::abs(y);
    const bool beyond_tip = (ay - 1.0) * 0.75 > ax;
    const double dx = beyond_tip ? ax : ax + 0.75, dy = beyond_tip ? ay - 1.0 : ay;
    const double away = length_of(dx, dy);
    return {(beyond_tip ? 0.0 : 1.25) - away, -(sx * (dx / away)), -(sy * (dy / away))};
}

/// The area of the form of radius 1.
double area_of(ShapeForm form) {
    switch (form) {
        case ShapeForm::disk:
            return 3.141592653589793;
        case ShapeForm::square:
            return 2.0;
        case ShapeForm::ring:
            return 0.75 * 3.141592653589793;
        case ShapeForm::star:
            return 5.0 * 0.22451398828979269;
        case ShapeForm::leaf:
            return 3.125 * 0.9272952180016122 - 1.5;  // 2 rho^2 arccos(d / rho) - 2 d
    }
    return 0.0;
}

/// The distance to the border of the shape whose square has this hash, at a place from its middle.
ShapeSample shape_at(const ScatteredShapes& shapes, std::uint32_t hash, double x, double y) {
    const double dx = x - shapes.jitter * (hash_number(hash, 1) - 0.5),
                 dy = y - shapes.jitter * (hash_number(hash, 2) - 0.5);
    const double radius = shapes.radius + shapes.spread * hash_number(hash, 3);
    const double turn = shapes.turn * hash_number(hash, 4);
    const double c = cosine(turn), s = sine(turn);
    const ShapeSample own =
        shape_distance(shapes.form, (c * dx + s * dy) / radius, (c * dy - s * dx) / radius);
    return {radius * own.value, c * own.gx - s * own.gy, s * own.gx + c * own.gy};
}

}  // namespace

ShapeSample shape_distance(ShapeForm form, double x, double y) {
    switch (form) {
        case ShapeForm::disk:
            return disk(x, y);
        case ShapeForm::square:
            return square(x, y);
        case ShapeForm::ring:
            return ring(x, y);
        case ShapeForm::star:
            return star(x, y);
        case ShapeForm::leaf:
            return leaf(x, y);
    }
    return {};
}

double ScatteredShapes::mean() const {
    const double largest = radius + spread;
    const double squares = (radius * radius + radius * largest + largest * largest) / 3.0;
    const double area = chance * area_of(form) * squares;
    if (largest <= 0.5 * (1.0 - jitter)) return area;
    return 0.5 * (std::min(area, 1.0) + 1.0 - std::exp(-area));
}

ShapeSample scattered_at(const ScatteredShapes& shapes, double x, double y) {
    const auto site = lattice_site<double, 2>({x, y});
    ShapeSample cover{-1.0}, top{-1.0};
    double id = -1.0, outer_id = 0.0;  // of the top shape; of the nearest one
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
            const std::uint32_t hash =
                LatticeHash::bits(site.index(0, i), site.index(1, j), 0, shapes.seed);
            if (!(hash_number(hash, 5) < shapes.chance)) continue;
            const ShapeSample own =
                shape_at(shapes, hash, site.place[0] - double(i), site.place[1] - double(j));
            const double number = hash_number(hash, 0);
            if (own.value >= 0.0 && number > id) top = own, id = number;
            if (own.value > cover.value) cover = own, outer_id = number;
        }
    if (shapes.gives == ShapeGives::cover) return cover;
    if (shapes.gives == ShapeGives::id) return {id >= 0.0 ? id : outer_id};
    if (id >= 0.0) return top;
    return cover.value > -shapes.outside() ? cover : ShapeSample{-shapes.outside()};
}

}  // namespace burl
