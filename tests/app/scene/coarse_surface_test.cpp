// Coarse surfaces against the surfaces that they stand for.
#include "app/scene/coarse_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "tests/app/support/sample_scene.h"

namespace burl {
namespace {

/// A unit sphere that has all that a surface can have, another number for every vertex.
Surface sphere(std::uint32_t rings) {
    const Mesh mesh = sphere_mesh(rings, 2 * rings);
    Surface surface;
    surface.positions = mesh.positions;
    surface.triangles = mesh.triangles;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const auto number = double(v);
        surface.normals.emplace_back(mesh.positions[v]);
        surface.uvs.emplace_back(number, -number);
        surface.tangents.emplace_back(float(v), 0.0f, 0.0f, 1.0f);
        surface.colors.emplace_back(0.0f, float(v), 0.0f, 1.0f);
        surface.blocks.emplace_back(float(v), 0.0f, 1.0f, 1.0f);
        surface.target.positions.emplace_back(number, 0.0, 0.0);
        surface.target.normals.emplace_back(0.0f, float(v), 0.0f);
    }
    surface.target_share = 0.25;
    surface.material.roughness = 0.7f;
    surface.placements = {Mat4d(1.0), Mat4d(2.0)};
    return surface;
}

double area(const Surface& surface) {
    double sum = 0.0;
    for (const Triangle& t : surface.triangles)
        sum += 0.5 * glm::length(glm::cross(surface.positions[t[1]] - surface.positions[t[0]],
                                            surface.positions[t[2]] - surface.positions[t[0]]));
    return sum;
}

TEST(CoarseSurface, HasAboutAsManyTrianglesAsAskedForAndTheShapeOfTheOther) {
    const Surface fine = sphere(200);
    for (const std::size_t most : {500, 4000, 20000}) {
        const Surface coarse = coarse_surface(fine, most);
        const std::size_t count = coarse.triangles.size();
        EXPECT_LE(double(count), 1.25 * double(most));
        EXPECT_GE(double(count), 0.3 * double(most));
        EXPECT_NEAR(area(coarse) / area(fine), 1.0, most == 500 ? 0.06 : 0.02) << most;
        // A point of a triangle is as far below the sphere as a chord of its longest side.
        for (const Triangle& t : coarse.triangles) {
            const Vec3d middle =
                (coarse.positions[t[0]] + coarse.positions[t[1]] + coarse.positions[t[2]]) / 3.0;
            EXPECT_GT(glm::length(middle), 1.0 - 20.0 / double(most));
        }
    }
}

/// No crack: every edge of a closed surface is passed both ways.
TEST(CoarseSurface, OfAClosedSurfaceIsClosedAndTurnedTheSameWay) {
    const Surface coarse = coarse_surface(sphere(100), 2000);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    std::size_t outwards = 0;
    for (const Triangle& t : coarse.triangles) {
        for (int i = 0; i < 3; ++i) ++edges[{t[std::size_t(i)], t[std::size_t((i + 1) % 3)]}];
        const Vec3d &a = coarse.positions[t[0]], &b = coarse.positions[t[1]],
                    &c = coarse.positions[t[2]];
        outwards += glm::dot(glm::cross(b - a, c - a), a) > 0.0;
    }
    for (const auto& [edge, times] : edges)
        EXPECT_EQ(times, (edges[{edge.second, edge.first}])) << edge.first << ' ' << edge.second;
    EXPECT_GT(double(outwards), 0.98 * double(coarse.triangles.size()));
}

TEST(CoarseSurface, KeepsAllThatItsVerticesHad) {
    const Surface fine = sphere(100), coarse = coarse_surface(fine, 1500);
    std::set<std::size_t> seen;
    for (std::size_t v = 0; v < coarse.positions.size(); ++v) {
        const auto was = std::size_t(coarse.uvs[v].x);
        EXPECT_TRUE(seen.insert(was).second);
        EXPECT_EQ(coarse.positions[v], fine.positions[was]);
        EXPECT_EQ(coarse.normals[v], fine.normals[was]);
        EXPECT_EQ(coarse.tangents[v], fine.tangents[was]);
        EXPECT_EQ(coarse.colors[v], fine.colors[was]);
        EXPECT_EQ(coarse.blocks[v], fine.blocks[was]);
        EXPECT_EQ(coarse.target.positions[v], fine.target.positions[was]);
        EXPECT_EQ(coarse.target.normals[v], fine.target.normals[was]);
    }
    EXPECT_TRUE(coarse.target.tangents.empty());
    EXPECT_EQ(coarse.target_share, fine.target_share);
    EXPECT_EQ(coarse.material.roughness, fine.material.roughness);
    EXPECT_EQ(coarse.placements, fine.placements);
}

/// Vertices of blocks of an atlas lie one on the other: where they stand for one another, no crack
/// opens.
TEST(CoarseSurface, ATriangleSoupHasNoCracksEither) {
    const Surface whole = sphere(100);
    Surface soup;
    for (const Triangle& t : whole.triangles) {
        const auto first = std::uint32_t(soup.positions.size());
        for (const std::uint32_t v : t) soup.positions.push_back(whole.positions[v]);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    const Surface coarse = coarse_surface(soup, 2000);
    EXPECT_LE(coarse.triangles.size(), 2500u);
    EXPECT_NEAR(area(coarse) / area(whole), 1.0, 0.03);
}

TEST(CoarseSurface, LeavesAloneWhatIsSmallOrHasNoArea) {
    const Surface fine = sphere(20);
    EXPECT_EQ(coarse_surface(fine, fine.triangles.size()).triangles, fine.triangles);
    Surface point = fine;
    for (Vec3d& p : point.positions) p = Vec3d(3.0);
    EXPECT_EQ(coarse_surface(point, 10).triangles, fine.triangles);
}

}  // namespace
}  // namespace burl
