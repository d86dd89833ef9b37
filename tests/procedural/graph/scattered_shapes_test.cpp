// Strewn shapes against brute force over their borders and over many squares.
#include "procedural/graph/scattered_shapes.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "procedural/noise/cell_features.h"
#include "tests/procedural/graph/cases.h"

namespace burl {
namespace {

constexpr double half_turn = std::numbers::pi;

/// Points of the border of a form of radius 1.
std::vector<Vec3d> border_of(ShapeForm form) {
    std::vector<Vec3d> border, corners;
    constexpr int steps = 40000;
    if (form == ShapeForm::square)
        for (int k = 0; k < 5; ++k)
            corners.emplace_back(std::cos(half_turn * (k + 0.5) / 2),
                                 std::sin(half_turn * (k + 0.5) / 2), 0.0);
    if (form == ShapeForm::star)
        for (int k = 0; k < 11; ++k) {
            const double radius =
                k % 2 == 0 ? 1.0 : std::sin(half_turn / 10) / std::sin(0.3 * half_turn);
            corners.emplace_back(radius * std::sin(half_turn * k / 5),
                                 radius * std::cos(half_turn * k / 5), 0.0);
        }
    for (std::size_t k = 0; k + 1 < corners.size(); ++k)
        for (int i = 0; i < steps / 10; ++i)
            border.push_back(glm::mix(corners[k], corners[k + 1], i / (0.1 * steps)));
    for (int i = 0; i < steps && corners.empty(); ++i) {
        const Vec3d turned(std::cos(2 * half_turn * i / steps), std::sin(2 * half_turn * i / steps),
                           0.0);
        if (form != ShapeForm::leaf) border.push_back(turned);
        if (form == ShapeForm::ring) border.push_back(0.5 * turned);
        const Vec3d arc = 1.25 * turned - Vec3d(0.75, 0, 0);
        if (form == ShapeForm::leaf && arc.x >= 0.0) {
            border.push_back(arc);
            border.emplace_back(-arc.x, arc.y, 0.0);
        }
    }
    return border;
}

/// Whether a ray along x leaves the polygon or the curves more often than it enters.
bool holds(ShapeForm form, double x, double y) {
    const double away = std::hypot(x, y);
    if (form == ShapeForm::disk) return away <= 1.0;
    if (form == ShapeForm::ring) return away <= 1.0 && away >= 0.5;
    if (form == ShapeForm::leaf)
        return std::hypot(x - 0.75, y) <= 1.25 && std::hypot(x + 0.75, y) <= 1.25;
    const std::vector<Vec3d> border = border_of(form);
    bool inside = false;
    for (std::size_t i = 0; i < border.size(); ++i) {
        const Vec3d &a = border[i], &b = border[(i + 1) % border.size()];
        if ((a.y > y) != (b.y > y) && x < a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x))
            inside = !inside;
    }
    return inside;
}

constexpr std::array forms{ShapeForm::disk, ShapeForm::square, ShapeForm::ring, ShapeForm::star,
                           ShapeForm::leaf};

TEST(ScatteredShapes, DistancesAreThoseToTheBorder) {
    for (const ShapeForm form : forms) {
        const std::vector<Vec3d> border = border_of(form);
        for (const Vec3d& p : random_points(150, 1.6, 31)) {
            double nearest = 1e9;
            for (const Vec3d& q : border)
                nearest = std::min(nearest, std::hypot(p.x - q.x, p.y - q.y));
            const ShapeSample found = shape_distance(form, p.x, p.y);
            EXPECT_NEAR(found.value, holds(form, p.x, p.y) ? nearest : -nearest, 2e-4)
                << int(form) << ' ' << p.x << ' ' << p.y;
            EXPECT_NEAR(std::hypot(found.gx, found.gy), 1.0, 1e-12) << int(form);
            const double h = 1e-6;
            const auto at = [&](double x, double y) { return shape_distance(form, x, y).value; };
            EXPECT_NEAR(found.gx, (at(p.x + h, p.y) - at(p.x - h, p.y)) / (2 * h), 1e-4);
            EXPECT_NEAR(found.gy, (at(p.x, p.y + h) - at(p.x, p.y - h)) / (2 * h), 1e-4);
        }
        for (const Vec3d& q : border) EXPECT_LE(glm::length(q), 1.0 + 1e-12) << int(form);
    }
}

/// The shape of a square by its numbers, at (x, y).
double counted_shape(const ScatteredShapes& shapes, int i, int j, double x, double y, double& id) {
    const std::uint32_t h = LatticeHash::bits(std::uint32_t(i), std::uint32_t(j), 0, shapes.seed);
    id = hash_number(h, 0);
    if (hash_number(h, 5) >= shapes.chance) return -1e9;
    const double dx = x - (i + 0.5 + shapes.jitter * (hash_number(h, 1) - 0.5)),
                 dy = y - (j + 0.5 + shapes.jitter * (hash_number(h, 2) - 0.5));
    const double radius = shapes.radius + shapes.spread * hash_number(h, 3);
    const double turn = shapes.turn * hash_number(h, 4);
    const double far = std::hypot(dx, dy) / radius, angle = std::atan2(dy, dx) - turn;
    return radius * shape_distance(shapes.form, far * std::cos(angle), far * std::sin(angle)).value;
}

TEST(ScatteredShapes, NoneIsCutAtTheBorderOfItsSquare) {
    for (const ShapeForm form : forms) {
        ScatteredShapes shapes{9, form, 0.3, 0.45, 6.28, 1.0, 0.8};
        int inside = 0, overlaps = 0;
        for (const Vec3d& p : random_points(2000, 9.0, 37)) {
            double nearest = -1e9, top = -1.0, top_id = -1.0, nearest_id = 0.0;
            const int s = int(std::floor(p.x)), t = int(std::floor(p.y));
            int holding = 0;
            for (int i = s - 4; i <= s + 4; ++i)
                for (int j = t - 4; j <= t + 4; ++j) {
                    double id;
                    const double away = counted_shape(shapes, i, j, p.x, p.y, id);
                    if (away > nearest) nearest = away, nearest_id = id;
                    if (away < 0.0) continue;
                    ++holding;
                    if (id > top_id) top_id = id, top = away;
                }
            inside += holding > 0, overlaps += holding > 1;
            const auto found = [&](ShapeGives gives) {
                shapes.gives = gives;
                return scattered_at(shapes, p.x, p.y);
            };
            if (holding > 0 || nearest > -shapes.outside()) {
                EXPECT_NEAR(found(ShapeGives::cover).value, nearest, 1e-11);
                EXPECT_EQ(found(ShapeGives::id).value, holding > 0 ? top_id : nearest_id);
            }
            const ShapeSample edge = found(ShapeGives::edge);
            EXPECT_NEAR(edge.value, holding > 0 ? top : std::max(nearest, -shapes.outside()),
                        1e-11);
            if (edge.value > -shapes.outside()) {
                EXPECT_NEAR(std::hypot(edge.gx, edge.gy), 1.0, 1e-12);
            }
        }
        EXPECT_GT(inside, 400);
        EXPECT_GT(overlaps, 20);
    }
}

TEST(ScatteredShapes, MeansAreNearlyTheShareThatIsCovered) {
    for (const ShapeForm form : forms)
        for (const auto& [radius, spread, jitter, chance] :
             {std::array{0.45, 0.05, 0.0, 1.0}, std::array{0.1, 0.2, 1.0, 1.0},
              std::array{0.2, 0.25, 1.0, 0.6}, std::array{0.75, 0.0, 1.0, 1.0},
              std::array{0.6, 0.0, 0.0, 1.0}, std::array{0.75, 0.0, 0.0, 1.0}}) {
            const ScatteredShapes shapes{4, form, radius, spread, 1.0, jitter, chance};
            double covered = 0.0;
            for (const Vec3d& p : random_points(40000, 100.0, 41))
                covered += scattered_at(shapes, p.x, p.y).value >= 0.0 ? 1.0 / 40000 : 0.0;
            const bool apart = radius + spread <= 0.5 * (1.0 - jitter);
            EXPECT_NEAR(shapes.mean(), covered,
                        apart          ? 0.01
                        : jitter < 1.0 ? 0.17
                                       : 0.06)
                << int(form) << ' ' << radius;
        }
}

}  // namespace
}  // namespace burl
