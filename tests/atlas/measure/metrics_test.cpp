// Coverage, relative scale and density against values worked out by hand.
#include "atlas/measure/atlas_measures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/atlas/support/made_meshes.h"

namespace burl {
namespace {

/// Triangles of area 1/2 and 2 and one without area, each on 1/8 of a 4 x 4 texture.
struct Hand {
    Mesh mesh = made::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 5}, {2, 0, 5}, {0, 2, 5}},
                              {{0, 1, 2}, {3, 4, 5}, {0, 1, 1}});
    Atlas atlas;
    SolidAtlas solid;
    Hand() {
        atlas.options.size = 4;
        atlas.chart_count = 3;
        atlas.corners = {
            {{{0, 0}, {2, 0}, {0, 2}}}, {{{2, 0}, {4, 0}, {2, 2}}}, {{{0, 2}, {2, 2}, {0, 4}}}};
        solid.size = 4;
        solid.spans = {{0, 4, 0}, {1, 2, 1}};
        solid.row_begin = {0, 1, 2, 2, 2};
    }
};

TEST(Metrics, HandMadeAtlas) {
    const Hand hand;
    const AtlasMetrics m = measure(hand.mesh, hand.atlas, hand.solid);
    EXPECT_DOUBLE_EQ(m.coverage, 3.0 / 8.0);
    EXPECT_DOUBLE_EQ(m.area, 2.5);
    EXPECT_EQ(m.triangles, 3u);
    EXPECT_EQ(m.zero_area, 1u);
    EXPECT_EQ(m.charts, 3u);
    EXPECT_DOUBLE_EQ(m.texel_coverage, 6.0 / 16.0);
    EXPECT_DOUBLE_EQ(m.relative_scale, std::sqrt(2.5 * (0.25 + 0.0625) / 2.0));
    EXPECT_DOUBLE_EQ(m.density[0], 2.5 * 0.0625);  // the larger triangle is 80 % of the area
    EXPECT_DOUBLE_EQ(m.density[1], 2.5 * 0.0625);
    EXPECT_DOUBLE_EQ(m.density[2], 2.5 * 0.25);
}

AtlasMetrics measured(const Mesh& mesh, const AtlasOptions& options) {
    const Atlas atlas = layout_atlas(mesh, made::neighbours_by_brute_force(mesh), options);
    return measure(mesh, atlas, rasterize(mesh, atlas, mesh.positions));
}

// Two triangles of a unit square: one block of 8 x 8 texels with legs of 7.
TEST(Metrics, OnePairBilinear) {
    const AtlasMetrics m = measured(made::square(), {AtlasKind::area, Overscan::bilinear, 8});
    EXPECT_DOUBLE_EQ(m.coverage, 49.0 / 64.0);
    EXPECT_DOUBLE_EQ(m.relative_scale, 7.0 / 8.0);
    for (const double density : m.density) EXPECT_DOUBLE_EQ(density, 49.0 / 64.0);
    EXPECT_EQ(m.charts, 1u);
    EXPECT_DOUBLE_EQ(m.texel_coverage, 1.0);
}

TEST(Metrics, OnePairNearestIsPulledInByOne256thTexel) {
    const AtlasMetrics m = measured(made::square(), {AtlasKind::area, Overscan::nearest, 8});
    EXPECT_DOUBLE_EQ(m.coverage, std::pow((8.0 - 2.0 / 32.0) / 8.0, 2));
}

TEST(Metrics, RelativeScaleAndDensityDoNotDependOnTheUnitOfLength) {
    const Mesh mesh = made::ball(2);
    Mesh larger = mesh;
    for (Vec3d& p : larger.positions) p *= 1000.0;
    const AtlasOptions options{AtlasKind::uniform, Overscan::bilinear, 128};
    const AtlasMetrics a = measured(mesh, options), b = measured(larger, options);
    EXPECT_NEAR(a.relative_scale, b.relative_scale, 1e-12);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a.density[i], b.density[i], 1e-12);
    EXPECT_NEAR(b.area / a.area, 1e6, 1e-6);
}

TEST(Metrics, SurfaceWithoutAreaHasNoScale) {
    const Mesh mesh = made::mesh_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}, {1, 1, 1}});
    const AtlasMetrics m = measured(mesh, {AtlasKind::area, Overscan::bilinear, 16});
    EXPECT_EQ(m.zero_area, 2u);
    EXPECT_EQ(m.relative_scale, 0.0);
    EXPECT_GT(m.coverage, 0.0);
}

}  // namespace
}  // namespace burl
