// Measures of texture coordinates against maps whose values are known.
#include "atlas/measure/uv_atlas.h"

#include <gtest/gtest.h>

#include <cmath>

#include "atlas/measure/atlas_measures.h"
#include "tests/atlas/support/made_meshes.h"

namespace burl {
namespace {

/// The mesh with place(point) as texture coordinates, the same from all sides.
template <class Place>
Mesh with_uvs(Mesh mesh, Place place) {
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t p : t) mesh.corners.uvs.push_back(place(mesh.positions[p]));
    return mesh;
}

struct Measured {
    Atlas atlas;
    SolidAtlas solid;
    AtlasMeasures all;
};

Measured uv_metrics_measured(const Mesh& mesh, std::uint32_t size) {
    const Connectivity connectivity = made::neighbours_by_brute_force(mesh);
    Measured m;
    m.atlas = atlas_from_uvs(mesh, connectivity, size);
    m.solid = rasterize_uvs(mesh, m.atlas, mesh.positions);
    m.all = measure_atlas(mesh, m.atlas, m.solid, mesh_edges(mesh, connectivity));
    return m;
}

// The unit square on [1/4, 3/4]^2 of 16 x 16 texels: corners on texel edges 4 and 12.
TEST(UvMetrics, SquareInTheMiddle) {
    const Measured m = uv_metrics_measured(
        with_uvs(made::square(), [](const Vec3d& p) { return Vec2d(p.x, p.y) * 0.5 + 0.25; }), 16);
    EXPECT_DOUBLE_EQ(m.all.use.coverage, 0.25);
    EXPECT_DOUBLE_EQ(m.all.use.relative_scale, 0.5);
    for (const double density : m.all.use.density) EXPECT_DOUBLE_EQ(density, 0.25);
    EXPECT_EQ(m.all.texels.covered, 64u);
    EXPECT_DOUBLE_EQ(m.all.use.texel_coverage, 0.25);
    EXPECT_EQ(m.all.texels.readable, 100u);  // one texel further on every side
    EXPECT_EQ(m.all.texels.overlapped, 0u);
    EXPECT_EQ(m.all.texels.outside, 0u);
    EXPECT_EQ(m.all.charts.with_area, 1u);
    EXPECT_EQ(m.all.charts.seam_share, 0.0);
    EXPECT_EQ(m.all.charts.vertex_ratio, 1.0);
    EXPECT_NEAR(m.all.shape.anisotropy_95, 1.0, 1e-12);
    EXPECT_EQ(m.all.shape.mirrored, 1.0);  // v runs down the picture, y up the square
}

TEST(UvMetrics, TexelsShowThePointOfTheTriangleUnderTheirCentre) {
    const Measured m = uv_metrics_measured(
        with_uvs(made::square(),
                 [](const Vec3d& p) { return Vec2d(0.1 + 0.8 * p.x, 0.2 + 0.5 * p.y); }),
        40);
    std::size_t texels = 0;
    for (std::size_t y = 0; y < 40; ++y)
        for (const Span& span : m.solid.row(y))
            for (std::uint32_t x = span.x; x < span.x + span.count; ++x, ++texels) {
                const Vec3d p = m.solid.maps[span.map](x, std::int64_t(y));
                EXPECT_NEAR(p.x, ((x + 0.5) / 40.0 - 0.1) / 0.8, 1e-12);
                EXPECT_NEAR(p.y, ((double(y) + 0.5) / 40.0 - 0.2) / 0.5, 1e-12);
                EXPECT_EQ(span.map, p.y > p.x ? 1u : 0u);  // on the diagonal: the lower
            }
    EXPECT_EQ(texels, 32u * 20u);
}

TEST(UvMetrics, AnisotropyOfAStretchWhateverTheTriangle) {
    const double angle = 0.7;
    const Mesh mesh = with_uvs(made::square(), [&](const Vec3d& p) {
        const Vec2d stretched(0.3 * p.x, 0.1 * p.y);
        return Vec2d(0.5 + std::cos(angle) * stretched.x - std::sin(angle) * stretched.y,
                     0.3 + std::sin(angle) * stretched.x + std::cos(angle) * stretched.y);
    });
    const Measured m = uv_metrics_measured(mesh, 64);
    EXPECT_NEAR(m.all.shape.anisotropy_50, 3.0, 1e-9);
    EXPECT_NEAR(m.all.shape.anisotropy_95, 3.0, 1e-9);
    EXPECT_TRUE(std::isinf(anisotropy({Vec3d(0), Vec3d(1, 0, 0), Vec3d(0, 1, 0)},
                                      {Vec2d(0, 0), Vec2d(1, 1), Vec2d(2, 2)})));
}

/// Two triangles of the square side by side in the texture, cut along the diagonal.
Mesh cut_square() {
    Mesh mesh = made::square();
    mesh.corners.uvs = {{0.0, 0.0}, {0.5, 0.0}, {0.5, 0.5}, {0.5, 0.5}, {1.0, 1.0}, {0.5, 1.0}};
    return mesh;
}

TEST(UvMetrics, SeamAlongTheDiagonal) {
    const Measured m = uv_metrics_measured(cut_square(), 32);
    EXPECT_EQ(m.all.charts.with_area, 2u);
    EXPECT_EQ(m.atlas.chart_count, 2u);
    EXPECT_EQ(m.all.charts.seam_share, 1.0);
    EXPECT_NEAR(m.all.charts.seam_length, std::sqrt(2.0), 1e-12);
    EXPECT_EQ(m.all.charts.vertices, 6u);
    EXPECT_EQ(m.all.charts.vertex_ratio, 1.5);
}

TEST(UvMetrics, SeamShareOfAGridCutInTwo) {
    const std::uint32_t columns = 6, rows = 4;
    Mesh mesh = made::grid(columns, rows);
    for (Vec3d& p : mesh.positions) p.z = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const bool right = (t / 2) % columns >= 3;  // squares right of the middle move away
        for (const std::uint32_t p : mesh.triangles[t])
            mesh.corners.uvs.push_back(
                {0.4 * mesh.positions[p].x + (right ? 0.2 : 0.0), 0.9 * mesh.positions[p].y});
    }
    const Measured m = uv_metrics_measured(mesh, 64);
    EXPECT_EQ(m.all.charts.with_area, 2u);
    // In sides of a square: 4 of 20 upright edges, beside 18 level ones and 24 diagonals.
    EXPECT_NEAR(m.all.charts.seam_share, 4.0 / (20.0 + 18.0 + 24.0 * std::sqrt(2.0)), 1e-12);
    EXPECT_EQ(m.all.charts.vertices, 35u + 5u);
}

TEST(UvMetrics, StackedTrianglesOverlapWhereBothAre) {
    // Two triangles at different heights on the same half of the texture.
    Mesh mesh = made::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}},
                              {{0, 1, 2}, {3, 4, 5}});
    mesh = with_uvs(mesh, [](const Vec3d& p) { return Vec2d(p.x, p.y); });
    const Measured m = uv_metrics_measured(mesh, 16);
    EXPECT_EQ(m.all.texels.overlapped, 120u);  // centres below the diagonal: 15 + 14 + ... + 1
    EXPECT_EQ(m.all.texels.covered, 136u);     // and the 16 on it
    EXPECT_EQ(m.all.charts.with_area, 2u);
    for (const Span& span : m.solid.spans) EXPECT_EQ(span.map, 0u);
}

TEST(UvMetrics, FoldedAndVanishedTriangles) {
    // A strip of four triangles; the third is folded back over the second, the fourth is a line.
    Mesh mesh = made::mesh_of({{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 0}, {2, 1, 0}},
                              {{0, 2, 1}, {2, 3, 1}, {2, 4, 3}, {4, 5, 3}});
    const std::vector<Vec2d> place{{0.1, 0.1}, {0.1, 0.5}, {0.5, 0.1},
                                   {0.5, 0.5}, {0.3, 0.1}, {0.4, 0.3}};
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t p : t) mesh.corners.uvs.push_back(place[p]);
    const Measured m = uv_metrics_measured(mesh, 64);
    EXPECT_EQ(m.all.shape.flipped, 1u);
    EXPECT_EQ(m.all.shape.vanished, 1u);
    EXPECT_GT(m.all.texels.overlapped, 0u);
    EXPECT_DOUBLE_EQ(m.all.shape.mirrored, 0.5);
}

TEST(UvMetrics, FoldsThatFloatsDoNotTellAreNotCounted) {
    // The third triangle of a strip reaches back over the second, by less and by more than 2^-24.
    for (const auto& [depth, count] : {std::pair{0x1p-26, 0u}, {0x1p-22, 1u}}) {
        Mesh mesh =
            made::mesh_of({{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 0}, {2, 1, 0}},
                          {{0, 2, 1}, {2, 3, 1}, {2, 4, 3}, {4, 5, 3}});
        const std::vector<Vec2d> place{{0.125, 0.125}, {0.125, 0.5},        {0.5, 0.125},
                                       {0.5, 0.5},     {0.5 - depth, 0.25}, {0.875, 0.25}};
        for (const Triangle& t : mesh.triangles)
            for (const std::uint32_t p : t) mesh.corners.uvs.push_back(place[p]);
        const Measured m = uv_metrics_measured(mesh, 64);
        EXPECT_EQ(m.all.shape.flipped, count) << depth;
        EXPECT_EQ(m.all.shape.vanished, 0u) << depth;
    }
}

TEST(UvMetrics, PlacesOutsideTheTextureAreCountedAndClipped) {
    for (const double far : {2.0, 1e9, 1e300}) {
        const Measured m = uv_metrics_measured(
            with_uvs(made::square(),
                     [&](const Vec3d& p) { return Vec2d(p.x * far, p.y * far) - 0.25 * far; }),
            8);
        EXPECT_EQ(m.all.texels.outside, 2u) << far;
        EXPECT_EQ(m.all.texels.covered, 64u) << far;
    }
}

// Our own layouts: nothing overlaps, folds or vanishes; every texel read belongs to a block.
TEST(UvMetrics, OurAtlasesAreSound) {
    for (const auto& [name, mesh] : made::all()) {
        if (name == "nasty") continue;  // holds duplicates and points without area
        const Connectivity connectivity = made::neighbours_by_brute_force(mesh);
        for (const Overscan overscan : {Overscan::bilinear, Overscan::nearest}) {
            const Atlas atlas = layout_atlas(mesh, connectivity, {AtlasKind::area, overscan, 128});
            const AtlasMeasures all =
                measure_atlas(mesh, atlas, rasterize(mesh, atlas, mesh.positions),
                              mesh_edges(mesh, connectivity));
            EXPECT_EQ(all.texels.overlapped, 0u) << name;
            EXPECT_EQ(all.texels.outside, 0u) << name;
            EXPECT_EQ(all.shape.flipped, 0u) << name;
            EXPECT_EQ(all.shape.vanished, 0u) << name;
            EXPECT_EQ(all.shape.mirrored, 1.0) << name;  // all alike: y runs down the picture
            EXPECT_LE(all.texels.readable, 128u * 128u);
            EXPECT_GE(all.texels.readable, all.texels.covered);
            EXPECT_EQ(all.charts.with_area, atlas.chart_count) << name;
        }
    }
}

TEST(MeshEdges, EveryEdgeOnceWithEqualEnds) {
    const Mesh mesh = made::ball(2);  // closed: 3/2 edges per triangle
    const auto edges = mesh_edges(mesh, made::neighbours_by_brute_force(mesh));
    EXPECT_EQ(edges.size(), mesh.triangles.size() * 3 / 2);
    for (const MeshEdge& edge : edges) {
        ASSERT_TRUE(edge.interior);
        for (std::size_t end : {0u, 1u})
            EXPECT_EQ(mesh.triangles[edge.first.triangle][edge.first.corners[end]],
                      mesh.triangles[edge.second.triangle][edge.second.corners[end]]);
    }
    EXPECT_EQ(mesh_edges(made::square(), made::neighbours_by_brute_force(made::square())).size(),
              5u);
}

}  // namespace
}  // namespace burl
