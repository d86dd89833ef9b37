// Slope maps hold the quadric's slopes and owners; sides and shares of octaves beside them.
#include "procedural/maps/slope_map.h"

#include <bit>
#include <cmath>

#include <gtest/gtest.h>

#include "procedural/model/octaves.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

/// Eq. 11 in float64 at every texel; gaps are 0.
TEST(SlopeMap, HoldsTheQuadricsSlopesAndTheOwner) {
    SyntheticAtlas synthetic;
    synthetic.size = 96;
    const SolidAtlas solid = synthetic.make(4);
    const Quadric q{1.5, -0.3, 0.2, 0.7, -1.1, 0.4, 0.1, 0.9, -0.6, 2.0};
    const TexelArea area{10, 20, 70, 50};
    const Image<MapTexel> map = fill_slope_map(solid, solid.maps, q, area, 2);
    Image<MapTexel> expected(area.width, area.height, MapTexel(0));
    std::size_t owned = 0;
    for (std::uint32_t y = area.y; y < area.y + area.height; ++y)
        for (const Span& span : solid.row(y))
            for (std::uint32_t x = span.x; x < span.x + span.count; ++x) {
                if (x < area.x || x >= area.x + area.width) continue;
                const TexelMap& texel = solid.maps[span.map];
                const Vec3d half = half_gradient(q, texel(x, y));
                const MapTexel found = map(x - area.x, y - area.y);
                EXPECT_NEAR(std::bit_cast<float>(found.x), 2.0 * glm::dot(half, texel.step_x),
                            1e-8);
                EXPECT_NEAR(std::bit_cast<float>(found.y), 2.0 * glm::dot(half, texel.step_y),
                            1e-8);
                EXPECT_EQ(found.z, span.map);
                expected(x - area.x, y - area.y) = found;
                ++owned;
            }
    EXPECT_GT(owned, 1000u);
    EXPECT_LT(owned, std::size_t(area.width) * area.height);
    for (std::size_t i = 0; i < map.pixels().size(); ++i)
        ASSERT_EQ(map.pixels()[i], expected.pixels()[i]) << "a gap that is not 0";
}

TEST(SlopeMap, SidesLieInTheLatticeOfEveryGroup) {
    const SolidAtlas solid = SyntheticAtlas{}.make(1);
    std::vector<OctaveGroup> groups(2);
    groups[0].lattice_from_solid.linear = Mat3d(3.0);
    groups[0].scale = 0.5;
    groups[1].lattice_from_solid.linear = Mat3d(1e60);  // beyond the lattice: counts as 0
    groups[1].scale = 1.0;
    const std::vector<Vec4f> sides = lattice_sides(solid.maps, groups);
    ASSERT_EQ(sides.size(), 4 * solid.maps.size());
    const double unit = 1.5 * stream_unit(groups[0].kind);
    for (std::size_t i = 0; i < solid.maps.size(); ++i)
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_FLOAT_EQ(sides[4 * i][axis], float(unit * solid.maps[i].step_x[axis]));
            EXPECT_FLOAT_EQ(sides[4 * i + 1][axis], float(unit * solid.maps[i].step_y[axis]));
            EXPECT_EQ(sides[4 * i + 2][axis], 0.0f);
        }
}

/// Sides of up to a quarter of a cell show everything, of half a cell nothing.
TEST(SlopeMap, SharesFallWithEveryOctave) {
    std::vector<TexelMap> maps(1);
    maps[0].step_x = Vec3d(0.125, 0.0, 0.0);
    maps[0].step_y = Vec3d(0.0, 0.06, 0.0);
    std::vector<OctaveGroup> groups(1);
    groups[0].octaves = {{0, 0, 1.0f}, {0, 1, 1.0f}, {0, 2, 1.0f}};
    EXPECT_EQ(octave_shares(maps, groups), (std::vector{1.0f, 1.0f, 0.0f}));
    maps[0].step_x.x = 0.35;
    const std::vector<float> shares = octave_shares(maps, groups);
    EXPECT_GT(shares[0], 0.0f);
    EXPECT_LT(shares[0], 1.0f);
    EXPECT_EQ(shares[1], 0.0f);
}

}  // namespace
}  // namespace burl
