// Nets of shells: exact, without overlap, as few pieces as a person would cut.
#include "atlas/outline/unfold.h"

#include <cmath>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

#include "atlas/chart/least_rectangle.h"
#include "tests/atlas/support/made_patches.h"

namespace burl {
namespace {

std::vector<std::uint32_t> all_faces(const Mesh& mesh) {
    std::vector<std::uint32_t> faces(mesh.triangles.size());
    std::iota(faces.begin(), faces.end(), 0u);
    return faces;
}

std::optional<std::vector<FlatChart>> unfolded(const Mesh& mesh, std::size_t most = 8) {
    return unfold(mesh, build_connectivity(mesh), all_faces(mesh), {.most = most});
}

/// A closed cylinder of radius 1 with the given sides; caps are fans.
Mesh cylinder(std::uint32_t sides, double height) {
    std::vector<Vec3d> positions{{0.0, 0.0, 0.0}, {0.0, 0.0, height}};
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i < sides; ++i) {
        const double a = 2.0 * std::numbers::pi * i / sides;
        positions.push_back({std::cos(a), std::sin(a), 0.0});
        positions.push_back({std::cos(a), std::sin(a), height});
        const std::uint32_t p = 2 + 2 * i, q = 2 + 2 * ((i + 1) % sides);
        triangles.push_back({0, q, p});
        triangles.push_back({1, p + 1, q + 1});
        triangles.push_back({p, q, q + 1});
        triangles.push_back({p, q + 1, p + 1});
    }
    return made::mesh_of(positions, triangles);
}

double polygon_area(const std::vector<Vec2d>& points) {
    double twice = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i)
        twice += cross(points[i], points[(i + 1) % points.size()]);
    return 0.5 * twice;
}

/// Fails unless every triangle is in one chart with its edges' lengths kept, and every chart's
/// outline encloses its triangles and nothing else.
void expect_exact(const Mesh& mesh, const std::vector<FlatChart>& charts) {
    std::vector<int> times(mesh.triangles.size(), 0);
    for (const FlatChart& chart : charts) {
        ASSERT_EQ(chart.faces.size(), chart.triangles.size());
        double area = 0.0;
        for (std::size_t t = 0; t < chart.faces.size(); ++t) {
            ++times[chart.faces[t]];
            area += triangle_area(mesh, chart.faces[t]);
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t j = (k + 1) % 3;
                const Triangle &points = mesh.triangles[chart.faces[t]], &v = chart.triangles[t];
                const double length =
                    glm::distance(mesh.positions[points[k]], mesh.positions[points[j]]);
                EXPECT_NEAR(glm::distance(chart.places[v[k]], chart.places[v[j]]), length, 1e-9);
            }
        }
        EXPECT_NEAR(chart.area, area, 1e-9);
        EXPECT_NEAR(polygon_area(chart.outline), area, 1e-6);
    }
    for (const int n : times) EXPECT_EQ(n, 1);
}

TEST(Unfold, BoxesAreNetsThatFillTheirRectangles) {
    const Mesh box = made::box(1);
    const auto charts = unfolded(box);
    ASSERT_TRUE(charts);
    expect_exact(box, *charts);
    EXPECT_LE(charts->size(), 3u);
    for (const FlatChart& chart : *charts)
        EXPECT_NEAR(least_rectangle(convex_hull(chart.outline)).area(), chart.area, 1e-6);
}

TEST(Unfold, PiecesBecomeNoLongerThanAllowed) {
    const Mesh box = made::box(1);  // with sides of 1, 2 and 3
    std::vector<double> found;
    for (const double most : {2.0, 5.5, 6.5, 20.0}) {
        const auto charts = unfold(box, build_connectivity(box), all_faces(box), {.longest = most});
        ASSERT_TRUE(charts);
        expect_exact(box, *charts);
        found.push_back(0.0);
        for (const FlatChart& chart : *charts)
            found.back() =
                std::max(found.back(), least_rectangle(convex_hull(chart.outline)).longer());
        EXPECT_LE(found.back(), std::max(most, 3.0) + 1e-9) << "a side is never divided";
    }
    EXPECT_NEAR(found[0], 3.0, 1e-9);
    EXPECT_GT(found[2], found[0]);
}

TEST(Unfold, CylindersAreARectangleAndTwoDisks) {
    const Mesh mesh = cylinder(32, 3.0);
    const auto charts = unfolded(mesh);
    ASSERT_TRUE(charts);
    expect_exact(mesh, *charts);
    ASSERT_EQ(charts->size(), 3u);
    const double side = 2.0 * std::sin(std::numbers::pi / 32);
    int rectangles = 0;
    for (const FlatChart& chart : *charts) {
        if (chart.faces.size() != 64) continue;
        ++rectangles;
        EXPECT_NEAR(least_rectangle(convex_hull(chart.outline)).area(), 32.0 * side * 3.0, 1e-6);
    }
    EXPECT_EQ(rectangles, 1);
}

TEST(Unfold, BallsAreLeftToOthers) {
    EXPECT_FALSE(unfolded(made::ball(3)));
    EXPECT_FALSE(unfolded(made::ball(3), 10000)) << "a comb of smooth cuts";
}

TEST(Unfold, CoarseBallsComeApart) {
    const Mesh ball = made::ball(0);
    const auto charts = unfolded(ball, 20);
    ASSERT_TRUE(charts);
    expect_exact(ball, *charts);
    EXPECT_LT(charts->size(), ball.triangles.size() / 2);
}

TEST(Unfold, TrianglesWithoutAreaAreLeftToOthers) {
    Mesh mesh = made::box(1);
    mesh.positions.push_back(0.5 * (mesh.positions[0] + mesh.positions[1]));
    mesh.triangles.push_back({0, 1, std::uint32_t(mesh.positions.size()) - 1});
    EXPECT_FALSE(unfolded(mesh, 100));
}

TEST(LeastRectangle, TurnedRectanglesAreFound) {
    for (const double angle : {0.0, 0.3, 1.2, 2.9}) {
        const Vec2d u(std::cos(angle), std::sin(angle)), v(-u.y, u.x);
        std::vector<Vec2d> points;
        for (int i = 0; i <= 6; ++i)
            for (int j = 0; j <= 4; ++j)
                points.push_back(double(i) * 0.5 * u + double(j) * 0.25 * v);
        const TurnedRectangle box = least_rectangle(convex_hull(points));
        EXPECT_NEAR(box.area(), 3.0, 1e-9);
        EXPECT_NEAR(box.longer(), 3.0, 1e-9);
        EXPECT_NEAR(box.perimeter(), 8.0, 1e-9);
    }
}

}  // namespace
}  // namespace burl
