// Splitting chords: afterwards there are none, and the surface is the same.
#include "atlas/chart/chord_split.h"

#include <gtest/gtest.h>

#include "tests/atlas/support/made_patches.h"

namespace burl {
namespace {

std::vector<SideMask> random_sides(const Patch& patch, std::mt19937& random) {
    std::vector<SideMask> sides(patch.points.size(), 0);
    for (const HalfEdge h : patch.loops[0])
        sides[patch.start(h)] = static_cast<SideMask>(random() % 16);
    return sides;
}

TEST(ChordSplit, LeavesNoChordAndTheSameSurface) {
    std::mt19937 random(7);
    std::uint32_t split = 0;
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        Patch patch = made::random_disk(seed, 90);
        const Patch before = patch;
        std::vector<SideMask> sides = random_sides(patch, random);
        const std::uint32_t added = split_chords(patch, sides);
        split += added;
        made::expect_sound(patch);
        ASSERT_EQ(patch.points.size(), before.points.size() + added);
        EXPECT_EQ(patch.triangles.size(), before.triangles.size() + 2 * added);
        EXPECT_TRUE(topology_of(patch).is_disk());
        sides.resize(patch.points.size(), 0);
        for (HalfEdge h = 0; h < 3 * patch.triangles.size(); ++h)
            if (!patch.on_border(h)) {
                EXPECT_EQ(sides[patch.start(h)] & sides[patch.end(h)], 0);
            }
        // Per face: the same area, and the same normal on every piece.
        std::map<std::uint32_t, double> area;
        for (std::size_t t = 0; t < before.triangles.size(); ++t)
            area[before.faces[t]] += area_of(before, t);
        for (std::size_t t = 0; t < patch.triangles.size(); ++t)
            area[patch.faces[t]] -= area_of(patch, t);
        for (const auto& [face, rest] : area) EXPECT_NEAR(rest, 0.0, 1e-15);
        // The border is untouched, vertex by vertex.
        ASSERT_EQ(patch.loops[0].size(), before.loops[0].size());
        for (std::size_t i = 0; i < patch.loops[0].size(); ++i)
            EXPECT_EQ(patch.start(patch.loops[0][i]), before.start(before.loops[0][i]));
    }
    EXPECT_GT(split, 50u);
}

TEST(ChordSplit, NewVerticesAreMiddlesOfMeshPoints) {
    const Mesh mesh = made::square();
    Patch patch = made::whole(mesh);
    const std::vector<SideMask> sides(4, 1);
    ASSERT_EQ(split_chords(patch, sides), 1u);
    EXPECT_EQ(patch.points[4], Vec3d(0.5, 0.5, 0.0));
    EXPECT_EQ(std::minmax(patch.origins[4].a, patch.origins[4].b), std::minmax(0u, 2u));
    EXPECT_EQ(patch.triangles.size(), 4u);
}

TEST(ChordSplit, NoSharedSideNoSplit) {
    Patch patch = made::whole(made::square());
    const std::vector<SideMask> sides{0b1001, 0b0011, 0b0110, 0b1100};
    EXPECT_EQ(split_chords(patch, sides), 0u);
    EXPECT_EQ(patch.triangles.size(), 2u);
}

}  // namespace
}  // namespace burl
