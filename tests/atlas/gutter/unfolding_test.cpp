// Straight walks against closed forms: lines of a plane, of an unrolled cylinder, of a cone's
// sector and of a cube's net, whatever the triangles.
#include "atlas/gutter/unfolding.h"

#include <gtest/gtest.h>

#include "atlas/solid/solid_atlas.h"
#include "tests/atlas/support/made_patches.h"

namespace burl {
namespace {

struct Walked {
    Walk walk;
    Vec3d point;
    TexelMap map;
};

/// Walks out of an edge; the plane has the edge's triangle at `places`.
struct Walker {
    Mesh mesh;
    EdgeNeighbours neighbours;
    explicit Walker(Mesh m) : mesh(std::move(m)), neighbours(mesh.triangles, mesh.positions) {}

    Walked operator()(std::uint32_t edge, const std::array<Vec2d, 3>& places, const Vec2d& from,
                      const Vec2d& to, AtOpenEdge at_open_edge = AtOpenEdge::end) const {
        Unfolding unfolding(mesh.triangles, mesh.positions, neighbours, at_open_edge);
        const Walk walk = unfolding.walk(unfolding.begin(edge, places), from, to);
        const UnfoldedTriangle last = unfolding.unfolded(walk.tile);
        const Triangle& t = mesh.triangles[last.triangle];
        // Its own anchor is texel (0,0), whose centre is at (.5,.5).
        const TexelMap map = affine_map(
            last.places, {mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]}, {0, 0},
            {1, 1});
        const Vec2d at = from + walk.share * (to - from) - Vec2d(0.5);
        return {walk, map.origin + at.x * map.step_x + at.y * map.step_y, map};
    }
    /// The edge from one point to another.
    std::uint32_t edge(std::uint32_t a, std::uint32_t b) const {
        for (std::uint32_t e = 0; e < 3 * mesh.triangles.size(); ++e)
            if (TriangleEdge::start(mesh.triangles, e) == a &&
                TriangleEdge::end(mesh.triangles, e) == b)
                return e;
        ADD_FAILURE() << "no edge " << a << ", " << b;
        return 0;
    }
};

std::mt19937 random_numbers(7);
double between(double low, double high) {
    return std::uniform_real_distribution(low, high)(random_numbers);
}

/// An open tube of facets, unrolled: triangle t's corners, near its first point's own column.
std::array<Vec2d, 3> unrolled(const Mesh& mesh, std::uint32_t t, std::uint32_t columns,
                              double height, std::uint32_t rows) {
    const double chord = 2.0 * std::sin(std::numbers::pi / columns);
    std::array<Vec2d, 3> places;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t p = mesh.triangles[t][k];
        double column = p % columns;
        if (t / 2 % columns == columns - 1 && column == 0.0) column = columns;
        places[k] = {chord * column, height * double(p / columns) / rows};
    }
    return places;
}

/// The point of the tube at a place of its unrolled plane.
Vec3d rolled(const Vec2d& at, std::uint32_t columns) {
    const double chord = 2.0 * std::sin(std::numbers::pi / columns);
    const double column = std::floor(at.x / chord), share = at.x / chord - column;
    const auto corner = [&](double i) {
        const double angle = 2.0 * std::numbers::pi * i / columns;
        return Vec3d(std::cos(angle), std::sin(angle), at.y);
    };
    return (1.0 - share) * corner(column) + share * corner(column + 1.0);
}

TEST(Unfolding, WalksOnATubeAreLinesOfTheUnrolledTube) {
    const std::uint32_t columns = 24, rows = 20;
    const Walker walker(made::tube(columns, rows, 6.0));
    int far = 0;
    for (int i = 0; i < 2000; ++i) {
        const auto edge = std::uint32_t(3 * (48 * 8) + random_numbers() % (3 * 48 * 5));
        const auto places = unrolled(walker.mesh, edge / 3, columns, 6.0, rows);
        const Vec2d a = places[edge % 3], b = places[(edge % 3 + 1) % 3];
        const Vec2d out(b.y - a.y, a.x - b.x), from = glm::mix(a, b, between(0.0, 1.0));
        const Vec2d to = from + glm::normalize(out) * between(0.0, 1.4) +
                         glm::normalize(b - a) * between(-0.4, 0.4);
        const Walked walked = walker(edge, places, from, to);
        EXPECT_TRUE(walked.walk.arrived);
        EXPECT_LT(glm::distance(walked.point, rolled(to, columns)), 1e-12);
        // The frame is turned along: it stays orthonormal in the facet's plane.
        EXPECT_NEAR(glm::length(walked.map.step_x), 1.0, 1e-11);
        EXPECT_NEAR(glm::dot(walked.map.step_x, walked.map.step_y), 0.0, 1e-11);
        EXPECT_NEAR(walked.map.step_y.z, 1.0, 1e-11);
        far += std::abs(to.x - from.x) > 1.0;
    }
    EXPECT_GT(far, 100);
}

/// A tube, and an edge of it where walks begin: its middle in the unrolled plane, and the way out.
struct TubeEdge {
    Mesh mesh = made::tube(24, 20, 6.0);
    EdgeNeighbours neighbours{mesh.triangles, mesh.positions};
    std::uint32_t edge = 3 * (48 * 8);
    std::array<Vec2d, 3> places = unrolled(mesh, edge / 3, 24, 6.0, 20);
    Vec2d from = glm::mix(places[0], places[1], 0.5);
    Vec2d out = glm::normalize(Vec2d(places[1].y - places[0].y, places[0].x - places[1].x));
};

TEST(Unfolding, LongWalksEndWhereTheyAreToldTo) {
    const TubeEdge tube;
    const auto& [mesh, neighbours, edge, places, from, out] = tube;
    std::size_t last = 0;
    double share = 0.0;
    for (const int longest : {1, 2, 5, 9}) {
        Unfolding unfolding(mesh.triangles, mesh.positions, neighbours, AtOpenEdge::end, longest);
        const Walk walk = unfolding.walk(unfolding.begin(edge, places), from, from + 1.9 * out);
        EXPECT_FALSE(walk.arrived);
        EXPECT_EQ(unfolding.size(), std::size_t(longest) + 1);  // the first is not walked into
        EXPECT_GT(walk.share, share);
        EXPECT_GT(unfolding.size(), last);
        share = walk.share;
        last = unfolding.size();
    }
    Unfolding unfolding(mesh.triangles, mesh.positions, neighbours);
    EXPECT_TRUE(unfolding.walk(unfolding.begin(edge, places), from, from + 1.9 * out).arrived);
}

/// A cone of n facets with this angle in the plane at its tip, point 0.
Mesh cone(std::uint32_t n, double angle) {
    std::vector<Vec3d> positions{Vec3d(0.0)};
    std::vector<Triangle> triangles;
    const double radius = std::sin(angle / (2.0 * n)) / std::sin(std::numbers::pi / n);
    for (std::uint32_t i = 0; i < n; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / n;
        positions.push_back(
            {radius * std::cos(turn), radius * std::sin(turn), -std::sqrt(1.0 - radius * radius)});
        triangles.push_back({0, i + 1, (i + 1) % n + 1});
    }
    return made::mesh_of(positions, triangles);
}

TEST(Unfolding, WalksRoundAConesTipAreLinesOfItsSector) {
    const std::uint32_t n = 40;
    for (const double angle : {0.4, 2.0, 4.5}) {
        const Walker walker(cone(n, angle));
        const double step = angle / n;
        const auto at = [&](double i, double r) {
            return r * Vec2d(std::cos(step * i), std::sin(step * i));
        };
        const auto lifted = [&](double turn, double r) {
            const double i = std::floor(turn);
            // On the facet: the place on the chord at that direction.
            const Vec2d a = at(i, 1.0), b = at(i + 1.0, 1.0), way = at(turn, 1.0);
            const double along = cross(a, way) / (cross(a, way) - cross(b, way));
            const Vec3d p = walker.mesh.positions[std::size_t(i) % n + 1],
                        q = walker.mesh.positions[(std::size_t(i) + 1) % n + 1];
            const double chord = glm::length(glm::mix(a, b, along));
            return glm::mix(p, q, along) * (r / chord);
        };
        for (int trial = 0; trial < 500; ++trial) {
            const double r0 = between(0.05, 0.7), r1 = between(0.05, 0.9);
            const double turn = between(0.001, std::min(0.95 * std::numbers::pi / step, 90.0));
            // Facet 0 reaches from direction 0 to 1; walks leave it across direction 1.
            const Vec2d from = at(1.0, r0), to = at(1.0 + turn, r1);
            const std::uint32_t edge = walker.edge(2, 0);
            const Walked walked = walker(edge, {Vec2d(0.0), at(0.0, 1.0), at(1.0, 1.0)}, from, to);
            EXPECT_TRUE(walked.walk.arrived);
            EXPECT_LT(glm::distance(walked.point, lifted(1.0 + turn, r1)), 1e-11);
        }
    }
}

/// A unit cube's top and two sides; edge e of the top leads to side e.
TEST(Unfolding, WalksCrossACubesEdgesByItsNet) {
    const Walker walker(made::mesh_of(
        {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
        {{0, 1, 2}, {0, 2, 3}, {1, 5, 6}, {1, 6, 2}, {2, 6, 7}, {2, 7, 3}, {5, 4, 6}, {4, 7, 6}}));
    const std::array<Vec2d, 3> top{{{0, 0}, {1, 0}, {1, 1}}};
    // Over the edge x = 1: down the side, then along the bottom.
    for (const double far : {0.25, 0.75, 1.5, 1.9}) {
        const Walked walked = walker(1, top, {1.0, 0.5}, {1.0 + far, 0.6});
        const Vec3d expected = far < 1.0 ? Vec3d(1.0, 0.6, 1.0 - far) : Vec3d(2.0 - far, 0.6, 0.0);
        EXPECT_TRUE(walked.walk.arrived);
        EXPECT_LT(glm::distance(walked.point, expected), 1e-15 * 8);
        const Vec3d down = far < 1.0 ? Vec3d(0, 0, -1) : Vec3d(-1, 0, 0);
        EXPECT_LT(glm::distance(walked.map.step_x, down), 1e-15 * 8);
        EXPECT_LT(glm::distance(walked.map.step_y, Vec3d(0, 1, 0)), 1e-15 * 8);
    }
    // Over the edge x = 1 and the upright edge beside it: the net has that side turned.
    const Walked round = walker(1, top, {1.0, 0.9}, {1.5, 1.4});
    EXPECT_TRUE(round.walk.arrived);
    EXPECT_LT(glm::distance(round.point, Vec3d(0.6, 1.0, 0.5)), 1e-14);
    EXPECT_LT(glm::distance(round.map.step_y, Vec3d(-1, 0, 0)), 1e-14);
}

TEST(Unfolding, APlanesTrianglesDoNotMatter) {
    int arrived = 0;
    for (int trial = 0; trial < 40; ++trial) {
        // A sheet of jittered, sheared points; its first triangle is placed by any affine map.
        Mesh mesh = made::grid(12, 12);
        for (Vec3d& p : mesh.positions) {
            const bool inner = p.x > 0.01 && p.x < 0.99 && p.y > 0.01 && p.y < 0.99;
            if (inner) p += Vec3d(between(-0.02, 0.02), between(-0.02, 0.02), 0.0);
            p = Vec3d(p.x + 0.3 * p.y, 2.0 * p.y, 0.7 * p.x);
        }
        const Walker walker(mesh);
        const Vec2d x(between(3.0, 9.0), between(-1.0, 1.0)), y(between(-1.0, 1.0), 4.0);
        const auto place = [&](const Vec3d& p) {
            const double v = p.y / 2.0, u = p.x - 0.3 * v;
            return u * x + v * y;
        };
        const auto edge = std::uint32_t(3 * (2 * (12 * 6 + 6)));
        std::array<Vec2d, 3> places;
        for (std::size_t k = 0; k < 3; ++k)
            places[k] = place(mesh.positions[mesh.triangles[edge / 3][k]]);
        const Vec2d a = places[0], b = places[1], from = glm::mix(a, b, between(0.0, 1.0));
        const Vec2d to = from + 0.2 * Vec2d(b.y - a.y, a.x - b.x) + between(-3.0, 3.0) * (b - a);
        const Walked walked = walker(edge, places, from, to);
        if (!walked.walk.arrived) continue;
        ++arrived;
        EXPECT_LT(glm::distance(place(walked.point), to), 1e-12);
        EXPECT_NEAR(walked.point.z, 0.7 * (walked.point.x - 0.15 * walked.point.y), 1e-12);
    }
    EXPECT_GT(arrived, 10);
}

TEST(Unfolding, AnOpenEdgeEndsAWalkOrMirrorsIt) {
    const Walker walker(
        made::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 3, 2}}));
    const std::array<Vec2d, 3> places{{{0, 0}, {8, 0}, {0, 8}}};
    const Vec2d from(4.0, 4.0), to(12.0, 5.0);
    const Walked ended = walker(1, places, from, to);
    EXPECT_FALSE(ended.walk.arrived);
    EXPECT_NEAR(ended.walk.share, 0.5, 1e-15);
    EXPECT_LT(glm::distance(ended.point, Vec3d(1.0, 0.5625, 0.0)), 1e-15);
    const Walked mirrored = walker(1, places, from, to, AtOpenEdge::mirror);
    EXPECT_TRUE(mirrored.walk.arrived);
    EXPECT_LT(glm::distance(mirrored.point, Vec3d(0.5, 0.625, 0.0)), 1e-15);
    EXPECT_LT(glm::distance(mirrored.map.step_x, Vec3d(-0.125, 0, 0)), 1e-15);
    // Out of an open edge at once, and out of a triangle without area.
    EXPECT_EQ(walker(0, places, {4.0, 0.0}, {4.0, -3.0}).walk.share, 0.0);
    EXPECT_LT(glm::distance(walker(0, places, {4.0, 0.0}, {4.0, -3.0}, AtOpenEdge::mirror).point,
                            Vec3d(0.5, 0.375, 0.0)),
              1e-15);
    EXPECT_FALSE(walker(1, {{{0, 0}, {4, 4}, {8, 8}}}, from, to).walk.arrived);
}

TEST(Unfolding, WalksThatDoNotGetOnAreGivenUp) {
    const Mesh mesh =
        made::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 3, 2}});
    const EdgeNeighbours neighbours(mesh.triangles, mesh.positions);
    for (const double side : {0.4, 1e-3, 1e-8}) {
        Unfolding unfolding(mesh.triangles, mesh.positions, neighbours, AtOpenEdge::mirror);
        const std::uint32_t first = unfolding.begin(1, {{{0, 0}, {side, 0}, {0, side}}});
        const Walk walk = unfolding.walk(first, {0.5 * side, 0.5 * side}, {100.0, 40.0});
        EXPECT_EQ(walk.arrived, side == 0.4) << side;  // by way of 350 squares
        EXPECT_LT(walk.share, side == 0.4 ? 1.5 : 0.2) << side;
        EXPECT_EQ(unfolding.size() > 100, side == 0.4) << side;
    }
}

TEST(Unfolding, KeepsNoMoreTrianglesThanItIsTold) {
    const TubeEdge tube;
    const auto& [mesh, neighbours, edge, places, from, out] = tube;
    Unfolding unfolding(mesh.triangles, mesh.positions, neighbours, AtOpenEdge::end, longest_walk,
                        6);
    const std::uint32_t first = unfolding.begin(edge, places);
    const Walk walk = unfolding.walk(first, from, from + 1.9 * out);
    EXPECT_FALSE(walk.arrived);
    EXPECT_EQ(unfolding.size(), 6u);
    // What is unfolded can still be walked over.
    const Walk half = unfolding.walk(first, from, from + 0.9 * walk.share * 1.9 * out);
    EXPECT_TRUE(half.arrived);
    EXPECT_EQ(unfolding.size(), 6u);
}

TEST(Unfolding, EdgesOfThreeTrianglesEndWalks) {
    const Walker walker(made::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 1, 1}},
                                      {{0, 1, 2}, {1, 3, 2}, {1, 4, 2}}));
    EXPECT_FALSE(walker(1, {{{0, 0}, {8, 0}, {0, 8}}}, {4, 4}, {5, 5}).walk.arrived);
}

TEST(Unfolding, TrianglesWithoutAreaAreWalkedOver) {
    // Point 4 is the middle of the edge between the two large triangles, with a flat one there.
    const Walker walker(made::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {.5, .5, 0}},
                                      {{0, 1, 2}, {1, 4, 2}, {1, 3, 4}, {4, 3, 2}}));
    const std::array<Vec2d, 3> places{{{0, 0}, {8, 0}, {0, 8}}};
    for (const double at : {0.1, 0.4, 0.6, 0.9}) {
        const Vec2d from = glm::mix(places[1], places[2], at), to = from + Vec2d(0.3, 0.3);
        const Walked walked = walker(1, places, from, to);
        EXPECT_TRUE(walked.walk.arrived);
        EXPECT_LT(glm::distance(walked.point, Vec3d(to / 8.0, 0.0)), 1e-15);
    }
}

TEST(EdgeNeighbours, CountATrianglesCopiesOnce) {
    // Two triangles on an edge, a copy of each, and one without area.
    const std::vector<Vec3d> points{{0, 0, 0}, {1, 0, 0},   {0, 1, 0},
                                    {1, 1, 0}, {.5, .5, 0}, {1, 1, 1}};
    std::vector<Triangle> triangles{{0, 1, 2}, {1, 3, 2}, {0, 1, 2}, {3, 2, 1}, {1, 4, 2}};
    EXPECT_EQ(EdgeNeighbours(triangles, points).across(1), 5u);
    triangles.erase(triangles.begin() + 1);  // the copy of the second takes its place
    EXPECT_EQ(EdgeNeighbours(triangles, points).across(1), 7u);
    triangles.erase(triangles.begin() + 2);  // none with area is left
    EXPECT_EQ(EdgeNeighbours(triangles, points).across(1), 8u);
    triangles.push_back({1, 3, 2});
    triangles.push_back({1, 5, 2});
    EXPECT_EQ(EdgeNeighbours(triangles, points).across(1), TriangleEdge::none);
}

TEST(EdgeNeighbours, AgreeWithBruteForce) {
    for (const auto& [name, mesh] : made::all()) {
        SCOPED_TRACE(name);
        if (name == "nasty") continue;  // which of several triangles meet is not defined
        const Connectivity expected = made::neighbours_by_brute_force(mesh);
        const EdgeNeighbours neighbours(mesh.triangles, mesh.positions);
        for (std::uint32_t e = 0; e < 3 * mesh.triangles.size(); ++e) {
            const std::uint32_t over = neighbours.across(e);
            const std::int32_t n = over == TriangleEdge::none ? -1 : std::int32_t(over / 3);
            EXPECT_EQ(n, expected.neighbours[e / 3][e % 3]);
        }
    }
}

}  // namespace
}  // namespace burl
