// The chart atlas from mesh to texture: nearly isometric, no texel claimed twice, the same whatever
// the mesh's scale and the number of threads.
#include "atlas/outline/layout.h"

#include <gtest/gtest.h>

#include <tbb/task_arena.h>

#include "atlas/build/block_levels.h"
#include "atlas/build/mesh_atlas.h"
#include "atlas/uv/claims.h"
#include "tests/atlas/support/made_patches.h"

namespace burl {
namespace {

AtlasOptions charts_of(std::uint32_t size) {
    return {.kind = AtlasKind::chart, .size = size};
}

Atlas laid_out(const Mesh& mesh, std::uint32_t size) {
    auto atlas = layout_charts(mesh, build_connectivity(mesh), charts_of(size));
    EXPECT_TRUE(atlas);
    return atlas ? std::move(*atlas) : Atlas();
}

/// The singular values of a triangle's map from the surface to texels, larger first.
Vec2d singular_values(const Mesh& mesh, const Atlas& atlas, std::size_t t) {
    const auto& [i, j, k] = mesh.triangles[t];
    const Vec3d a = mesh.positions[j] - mesh.positions[i],
                b = mesh.positions[k] - mesh.positions[i];
    const Vec3d u = glm::normalize(a), v = glm::normalize(b - glm::dot(b, u) * u);
    const auto& c = atlas.corners[t];
    const Vec2d p = (c[1] - c[0]) / glm::dot(a, u);
    const Vec2d q = (c[2] - c[0] - glm::dot(b, u) * p) / glm::dot(b, v);
    const double sum = glm::dot(p, p) + glm::dot(q, q), det = std::abs(cross(p, q));
    const double root = std::sqrt(std::max(sum * sum - 4.0 * det * det, 0.0));
    return {std::sqrt(0.5 * (sum + root)), std::sqrt(0.5 * std::max(sum - root, 0.0))};
}

std::vector<made::Named> smooth_meshes() {
    return {{"ball", made::ball(4)},
            {"ring", made::ring(40, 20)},
            {"tube", made::tube(24, 20, 6.0)},
            {"box", made::box(4)},
            {"grid", made::grid(9, 7)}};
}

TEST(ChartAtlas, MapsAreNearlyIsometricAndOneToOne) {
    for (const auto& [name, mesh] : smooth_meshes()) {
        SCOPED_TRACE(name);
        const Atlas atlas = laid_out(mesh, 512);
        double area = 0.0, texels = 0.0, bad = 0.0, scale = 0.0;
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            const auto& c = atlas.corners[t];
            ASSERT_GT(cross(c[1] - c[0], c[2] - c[0]), 0.0);
            area += triangle_area(mesh, t);
            texels += 0.5 * cross(c[1] - c[0], c[2] - c[0]);
        }
        scale = std::sqrt(texels / area);
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            const Vec2d s = singular_values(mesh, atlas, t);
            if (s.x > 1.5 * s.y || s.x > 1.5 * scale || s.y < scale / 1.5)
                bad += triangle_area(mesh, t);
        }
        EXPECT_LT(bad, 0.05 * area);
        EXPECT_GT(texels, (name == "grid" || name == "ring" ? 0.45 : 0.5) * 512 * 512);
        EXPECT_EQ(claim_texels(atlas).shared_texels, 0u);
    }
}

TEST(ChartAtlas, FlatSheetsAreOneChartAndKeepTheirLengths) {
    Mesh mesh = made::grid(9, 7);
    for (Vec3d& p : mesh.positions) p = {0.6 * p.x, p.y, 0.8 * p.x};
    const Atlas atlas = laid_out(mesh, 512);
    EXPECT_EQ(atlas.chart_count, 1u);
    const double scale = singular_values(mesh, atlas, 0).x;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Vec2d s = singular_values(mesh, atlas, t);
        EXPECT_NEAR(s.x, scale, 1e-5 * scale);
        EXPECT_NEAR(s.y, scale, 1e-5 * scale);
    }
}

TEST(ChartAtlas, LongSheetsAreDividedRatherThanLeaveTheTextureEmpty) {
    Mesh mesh = made::grid(80, 4);
    for (Vec3d& p : mesh.positions) p = {20.0 * p.x, p.y, 0.0};
    const Atlas atlas = laid_out(mesh, 512);
    EXPECT_GT(atlas.chart_count, 4u);
    double texels = 0.0;
    for (const auto& c : atlas.corners) texels += 0.5 * cross(c[1] - c[0], c[2] - c[0]);
    EXPECT_GT(texels, 0.6 * 512 * 512) << "a single chart would have 0.05";
}

TEST(ChartAtlas, ShellsThatLieFlatAreOneChartEach) {
    // A closed ball beside a half tube: the tube is one chart, since nothing need be cut.
    Mesh mesh = made::ball(2);
    const auto ball = std::uint32_t(mesh.triangles.size());
    const Mesh sheet = made::grid(8, 8);
    std::vector<Vec3d> positions = mesh.positions;
    std::vector<Triangle> triangles = mesh.triangles;
    for (const Vec3d& p : sheet.positions)
        positions.push_back({3.0 + std::cos(3.0 * p.x), std::sin(3.0 * p.x), p.y});
    for (Triangle t : sheet.triangles) {
        for (std::uint32_t& v : t) v += std::uint32_t(mesh.positions.size());
        triangles.push_back(t);
    }
    const Atlas atlas = laid_out(made::mesh_of(positions, triangles), 256);
    for (std::size_t t = ball; t < triangles.size(); ++t)
        EXPECT_EQ(atlas.charts[t], atlas.charts[ball]);
}

TEST(ChartAtlas, NeitherScaleNorPlaceNorThreadsMatter) {
    const Mesh mesh = made::ring(40, 20);
    const Atlas atlas = laid_out(mesh, 256);
    Mesh moved = mesh;
    for (Vec3d& p : moved.positions) p = 4096.0 * p + Vec3d(64.0, -32.0, 8.0);
    EXPECT_EQ(laid_out(moved, 256).corners, atlas.corners);
    tbb::task_arena one(1);
    one.execute([&] { EXPECT_EQ(laid_out(mesh, 256).corners, atlas.corners); });
}

TEST(ChartAtlas, TrianglesWithoutAreaLieAtTheirNeighbours) {
    const Mesh mesh = made::nasty();
    const Atlas atlas = laid_out(mesh, 128);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        EXPECT_LT(atlas.charts[t], atlas.chart_count);
        const auto& c = atlas.corners[t];
        if (triangle_area(mesh, t) > 0.0) {
            EXPECT_NE(cross(c[1] - c[0], c[2] - c[0]), 0.0) << t;
        }
        for (const Vec2d& q : c)
            EXPECT_TRUE(q.x >= 0.0 && q.y >= 0.0 && q.x <= 128.0 && q.y <= 128.0);
    }
}

/// A box with a triangle on each of its edges' points and a point of their own in the middle.
Mesh box_with_lines() {
    Mesh mesh = made::box(4);
    const std::size_t own = mesh.triangles.size();
    for (std::size_t t = 0; t < own; ++t) {
        const std::uint32_t p = mesh.triangles[t][0], q = mesh.triangles[t][1];
        mesh.positions.push_back(0.25 * mesh.positions[p] + 0.75 * mesh.positions[q]);
        mesh.triangles.push_back({p, std::uint32_t(mesh.positions.size() - 1), q});
    }
    return mesh;
}

TEST(ChartAtlas, LinesLieOnTheEdgesOfOthersAndTakeNoTexels) {
    const Mesh plain = made::box(4), mesh = box_with_lines();
    const Atlas expected = laid_out(plain, 256), atlas = laid_out(mesh, 256);
    for (std::size_t t = 0; t < plain.triangles.size(); ++t)
        EXPECT_EQ(atlas.corners[t], expected.corners[t]) << t;
    for (std::size_t t = 0; t < plain.triangles.size(); ++t) {
        const auto& line = atlas.corners[plain.triangles.size() + t];
        EXPECT_EQ(line[1], line[2]) << t;  // its own point lies nearer to the edge's second end
        bool found = false;
        for (std::size_t o = 0; o < plain.triangles.size(); ++o)
            for (std::size_t k = 0; k < 3; ++k) {
                const auto &a = atlas.corners[o][k], &b = atlas.corners[o][(k + 1) % 3];
                found = found || (a == line[0] && b == line[2]) || (b == line[0] && a == line[2]);
            }
        EXPECT_TRUE(found) << t;
    }
}

TEST(ChartAtlas, LevelsUpToACellAreNotMixed) {
    const Mesh mesh = made::ball(4);
    const MeshAtlas atlas = build_atlas(mesh, build_connectivity(mesh), charts_of(1024));
    ASSERT_EQ(last_pure_level(atlas), 3u);
    const Image<std::uint32_t> owner = claim_texels(atlas.atlas()).owner;
    std::vector<std::uint32_t> chart(128 * 128, unclaimed);
    for (std::size_t y = 0; y < 1024; ++y)
        for (std::size_t x = 0; x < 1024; ++x) {
            if (owner(x, y) == unclaimed) continue;
            std::uint32_t& cell = chart[y / 8 * 128 + x / 8];
            const std::uint32_t own = atlas.atlas().charts[owner(x, y)];
            EXPECT_TRUE(cell == unclaimed || cell == own);
            cell = own;
        }
}

TEST(ChartAtlas, SoupsFallBackToPairsAndSayWhy) {
    const Mesh mesh = made::soup(4000, 1);
    const MeshAtlas atlas = build_atlas(mesh, build_connectivity(mesh), charts_of(64));
    EXPECT_NE(atlas.atlas().options.kind, AtlasKind::chart);
    EXPECT_NE(atlas.atlas().notes.fallback, "");
}

TEST(ChartAtlas, StopsWhereItIsAsked) {
    std::stop_source source;
    source.request_stop();
    const Mesh mesh = made::ball(3);
    EXPECT_FALSE(layout_charts(mesh, build_connectivity(mesh), charts_of(256), source.get_token()));
}

/// The ball with its first 40 triangles twice more: as they are, with their corners turned.
Mesh ball_with_copies() {
    Mesh mesh = made::ball(3);
    for (std::size_t t = 0; t < 40; ++t) {
        const Triangle v = mesh.triangles[t];
        mesh.triangles.push_back(v);
        mesh.triangles.push_back({v[2], v[0], v[1]});
    }
    return mesh;
}

TEST(ChartAtlas, CopiesOfTrianglesShareThePlaceOfTheFirst) {
    const Mesh plain = made::ball(3), mesh = ball_with_copies();
    const Atlas expected = laid_out(plain, 512), atlas = laid_out(mesh, 512);
    EXPECT_EQ(atlas.chart_count, expected.chart_count);
    for (std::size_t t = 0; t < plain.triangles.size(); ++t) {
        EXPECT_EQ(atlas.corners[t], expected.corners[t]);
        EXPECT_FALSE(atlas.is_copy(t));
    }
    for (std::size_t t = plain.triangles.size(); t < mesh.triangles.size(); ++t) {
        const std::size_t first = (t - plain.triangles.size()) / 2;
        EXPECT_EQ(atlas.copy_of[t], first);
        EXPECT_EQ(atlas.charts[t], atlas.charts[first]);
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t j = 0; j < 3; ++j)
                EXPECT_EQ(mesh.triangles[t][k] == mesh.triangles[first][j],
                          atlas.corners[t][k] == atlas.corners[first][j]);
    }
}

TEST(ChartAtlas, CopiesThatFaceTheOtherWayOrHaveAnotherLabelHavePlacesOfTheirOwn) {
    Mesh mesh = made::ball(3);
    const auto own = std::uint32_t(mesh.triangles.size());
    const Triangle first = mesh.triangles[0], second = mesh.triangles[1];
    mesh.triangles.push_back({first[0], first[2], first[1]});
    mesh.triangles.push_back(second);
    Connectivity connectivity = build_connectivity(mesh);
    std::vector<std::uint32_t> labels(mesh.triangles.size(), 0);
    labels.back() = 1;
    cut_between(connectivity, mesh, labels);
    const auto atlas = layout_charts(mesh, connectivity, charts_of(512));
    ASSERT_TRUE(atlas);
    EXPECT_EQ(claim_texels(*atlas).shared_texels, 0u);
    for (std::uint32_t t = own; t < own + 2; ++t) {
        EXPECT_FALSE(atlas->is_copy(t));
        EXPECT_NE(atlas->charts[t], atlas->charts[t - own]);
    }
}

}  // namespace
}  // namespace burl
