// The texels of the chart atlas: each shown once, by its triangle inside charts and by the surface
// beyond their borders outside, whatever the number of threads.
#include "atlas/outline/raster.h"

#include <gtest/gtest.h>

#include <tbb/task_arena.h>

#include "atlas/outline/layout.h"
#include "atlas/uv/claims.h"
#include "tests/atlas/support/made_patches.h"

namespace burl {
namespace {

struct Charts {
    Mesh mesh;
    Atlas atlas;
    SolidAtlas solid;
    Charts(Mesh m, std::uint32_t size)
        : mesh(std::move(m)),
          atlas(*layout_charts(mesh, build_connectivity(mesh),
                               {.kind = AtlasKind::chart, .size = size})),
          solid(rasterize_charts(mesh, atlas, mesh.positions)) {}

    template <class Visit>
    void visit_texels(const Visit& visit) const {
        for (std::uint32_t y = 0; y < solid.size; ++y)
            for (const Span& span : solid.row(y))
                for (std::uint32_t x = span.x; x < span.x + span.count; ++x)
                    visit(x, y, span.map, solid.maps[span.map](x, y));
    }
};

TEST(ChartRaster, EveryTexelIsInOneSpan) {
    for (const auto& [name, mesh] :
         {made::Named{"ball", made::ball(4)}, made::Named{"tube", made::tube(24, 20, 6.0)},
          made::Named{"nasty", made::nasty()}, made::Named{"triangle", made::one_triangle()}})
        for (const std::uint32_t size : {64u, 200u, 512u}) {
            SCOPED_TRACE(name);
            const Charts charts(mesh, size);
            ASSERT_EQ(charts.solid.row_begin.size(), size + 1);
            for (std::size_t y = 0; y < size; ++y) {
                std::uint32_t next = 0;
                for (const Span& span : charts.solid.row(y)) {
                    ASSERT_EQ(span.x, next);
                    ASSERT_GT(span.count, 0u);
                    ASSERT_LT(span.map, charts.solid.maps.size());
                    ASSERT_LT(charts.solid.triangle_of(span.map), charts.mesh.triangles.size());
                    next = span.x + span.count;
                }
                EXPECT_EQ(next, size);
            }
        }
}

TEST(ChartRaster, TexelsInTrianglesShowThem) {
    const Charts charts(made::ring(40, 20), 300);
    const Image<std::uint32_t> owner = claim_texels(charts.atlas).owner;
    std::size_t inside = 0;
    charts.visit_texels([&](std::uint32_t x, std::uint32_t y, std::uint32_t map, const Vec3d& p) {
        if (owner(x, y) == unclaimed) return;
        EXPECT_EQ(map, owner(x, y));
        const auto& c = charts.atlas.corners[map];
        const Vec2d u = c[1] - c[0], v = c[2] - c[0], d = Vec2d(x + 0.5, y + 0.5) - c[0];
        const double i = cross(d, v) / cross(u, v), j = cross(u, d) / cross(u, v);
        const auto& [p0, p1, p2] = charts.mesh.triangles[map];
        const std::vector<Vec3d>& at = charts.mesh.positions;
        const Vec3d expected = at[p0] + i * (at[p1] - at[p0]) + j * (at[p2] - at[p0]);
        EXPECT_LT(glm::distance(p, expected), 1e-9);
        ++inside;
    });
    EXPECT_GT(inside, 300u * 300u * 4 / 10);
}

/// The radius of a point on a ball of triangles is between that of their middles and 1.
TEST(ChartRaster, TexelsBesideChartsShowTheSurface) {
    const Charts charts(made::ball(4), 512);
    double middles = 1.0;
    for (const auto& [a, b, c] : charts.mesh.triangles)
        middles =
            std::min(middles, glm::length(charts.mesh.positions[a] + charts.mesh.positions[b] +
                                          charts.mesh.positions[c]) /
                                  3.0);
    const Image<std::uint32_t> owner = claim_texels(charts.atlas).owner;
    std::size_t beside = 0;
    charts.visit_texels([&](std::uint32_t x, std::uint32_t y, std::uint32_t, const Vec3d& p) {
        if (owner(x, y) != unclaimed) return;
        // Up to 1.5 texels, of about 0.01 each, the plane of a border's triangle goes on.
        EXPECT_GT(glm::length(p), middles - 1e-3);
        EXPECT_LT(glm::length(p), 1.0 + 4e-3);
        ++beside;
    });
    EXPECT_GT(beside, 10000u);
}

TEST(ChartRaster, ThreadsDoNotMatter) {
    const Charts charts(made::ring(40, 20), 300);
    tbb::task_arena one(1);
    one.execute([&] {
        const SolidAtlas again = rasterize_charts(charts.mesh, charts.atlas, charts.mesh.positions);
        ASSERT_EQ(again.spans.size(), charts.solid.spans.size());
        for (std::size_t i = 0; i < again.spans.size(); ++i)
            ASSERT_EQ(again.spans[i].map, charts.solid.spans[i].map);
        for (std::size_t m = 0; m < again.maps.size(); ++m)
            ASSERT_EQ(again.maps[m].origin, charts.solid.maps[m].origin);
    });
}

}  // namespace
}  // namespace burl
