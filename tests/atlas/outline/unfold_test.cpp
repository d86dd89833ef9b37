// Nets of shells: exact, without overlap, as few pieces as a person would cut.
#include "atlas/outline/unfold.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>

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

/// The surface of unit cubes at these places, two triangles a face, with common vertices.
Mesh cubes(const std::vector<std::array<int, 3>>& places) {
    const std::set<std::array<int, 3>> filled(places.begin(), places.end());
    std::map<std::array<int, 3>, std::uint32_t> number;
    std::vector<Vec3d> positions;
    const auto vertex = [&](const std::array<int, 3>& at) {
        const auto [found, is_new] = number.emplace(at, std::uint32_t(positions.size()));
        if (is_new) positions.emplace_back(at[0], at[1], at[2]);
        return found->second;
    };
    std::vector<Triangle> triangles;
    for (const std::array<int, 3>& cube : filled)
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const int side : {0, 1}) {
                std::array<int, 3> beside = cube;
                beside[axis] += side == 0 ? -1 : 1;
                if (filled.contains(beside)) continue;
                std::array<std::uint32_t, 4> corner{};
                for (std::size_t k = 0; k < 4; ++k) {
                    std::array<int, 3> at = cube;
                    at[axis] += side;
                    at[(axis + 1) % 3] += k == 1 || k == 2 ? 1 : 0;
                    at[(axis + 2) % 3] += k >= 2 ? 1 : 0;
                    corner[k] = vertex(at);
                }
                if (side == 0) std::swap(corner[1], corner[3]);
                triangles.push_back({corner[0], corner[1], corner[2]});
                triangles.push_back({corner[0], corner[2], corner[3]});
            }
    return made::mesh_of(positions, triangles);
}

/// The length of the borders of charts where another part of the same border, which is more than
/// `far` away on the surface, is nearer than `gap`.
double borders_side_by_side(const Mesh& mesh, const std::vector<FlatChart>& charts, double gap,
                            double far) {
    struct Place {
        Vec2d flat;
        Vec3d point;
    };
    constexpr int steps = 50;
    double length = 0.0;
    for (const FlatChart& chart : charts) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        for (const Triangle& t : chart.triangles)
            for (std::size_t k = 0; k < 3; ++k) ++edges[std::minmax(t[k], t[(k + 1) % 3])];
        std::vector<Place> border;
        for (std::size_t f = 0; f < chart.faces.size(); ++f)
            for (std::size_t k = 0; k < 3; ++k) {
                const Triangle &flat = chart.triangles[f], &own = mesh.triangles[chart.faces[f]];
                const std::size_t j = (k + 1) % 3;
                if (edges[std::minmax(flat[k], flat[j])] > 1) continue;
                for (int i = 0; i < steps; ++i) {
                    const double u = (i + 0.5) / steps;
                    border.push_back({glm::mix(chart.places[flat[k]], chart.places[flat[j]], u),
                                      glm::mix(mesh.positions[own[k]], mesh.positions[own[j]], u)});
                }
            }
        for (const Place& a : border)
            length += std::ranges::any_of(border,
                                          [&](const Place& b) {
                                              return glm::distance(a.flat, b.flat) < gap &&
                                                     glm::distance(a.point, b.point) > far;
                                          })
                          ? 1.0 / steps
                          : 0.0;
    }
    return length;
}

TEST(Unfold, NoBordersOfOtherPlacesLieAlongEachOther) {
    const std::vector<std::vector<std::array<int, 3>>> shapes{
        {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}},             // a cross
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}},                                    // an angle
        {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 1, 1}},              // a bent rod
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},                         // a corner
        {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 1}, {2, 0, 1}, {1, 1, 0}}};  // feet
    double before = 0.0;
    for (const auto& shape : shapes) {
        const Mesh mesh = cubes(shape);
        const Connectivity connectivity = build_connectivity(mesh);
        const auto close = unfold(mesh, connectivity, all_faces(mesh), {.most = 100}),
                   apart = unfold(mesh, connectivity, all_faces(mesh), {.most = 100, .gap = 0.05});
        ASSERT_TRUE(close && apart);
        expect_exact(mesh, *apart);
        before += borders_side_by_side(mesh, *close, 0.05, 0.25);
        EXPECT_LT(borders_side_by_side(mesh, *apart, 0.04, 0.25), 0.15);
    }
    EXPECT_GT(before, 2.0) << "shapes that need no care";
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
