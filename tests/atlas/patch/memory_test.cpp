// What a large mesh's patch atlas and its texels' points hold, in bytes by count: bakes of a
// million triangles stay within their bound (docs/lab/economy.md) as long as these do.
#include <gtest/gtest.h>

#include <tbb/global_control.h>

#include "atlas/build/mesh_atlas.h"
#include "atlas/chart/coarse_map.h"
#include "tests/atlas/support/made_patches.h"
#include "tests/counted_memory.h"

namespace burl {
namespace {

template <class Element>
double bytes(const std::vector<Element>& elements) {
    return double(elements.capacity() * sizeof(Element));
}

double bytes(const Mesh& mesh) {
    return bytes(mesh.positions) + bytes(mesh.triangles) + bytes(mesh.source_faces);
}

TEST(PatchMemory, TheAtlasKeepsNinetyBytesATriangle) {
    const Mesh mesh = made::ball(6);
    const double triangles = double(mesh.triangles.size());
    const PatchAtlas atlas = *build_patch_atlas(mesh, build_connectivity(mesh), {.size = 1024});
    double all = bytes(atlas.refined.mesh) + bytes(atlas.refined.cut_faces) +
                 bytes(atlas.refined.extra_points) + bytes(atlas.atlas.corners) +
                 bytes(atlas.atlas.charts) + bytes(atlas.layout.blocks) + bytes(atlas.patches);
    for (const PlacedPatch& patch : atlas.patches) all += bytes(patch.fans);
    EXPECT_GT(all, 60.0 * triangles);  // two thirds of it are corners
    EXPECT_LT(all, 90.0 * triangles);
}

/// Two divisions of a mesh are worked out, with patches so large that they are mapped coarsely.
TEST(PatchMemory, FittingTakesAtMostThreeHundredAndTwentyBytesATriangle) {
    if (!counts_bytes()) GTEST_SKIP() << "bytes are not counted here";
    const Mesh mesh = made::ball(8);
    const Connectivity connectivity = build_connectivity(mesh);
    const tbb::global_control two(tbb::global_control::max_allowed_parallelism, 2);
    begin_peak();
    const auto fitted = fit_patches(mesh, connectivity, {.size = 1024});
    EXPECT_LT(double(peak_bytes()), 320.0 * double(mesh.triangles.size()));
    ASSERT_TRUE(fitted);
    std::size_t coarse = 0;
    for (const MappedPatch& mapped : fitted->maps.patches)
        coarse += mapped.patch.triangles.size() > largest_patch;
    EXPECT_GT(coarse, 0u);
}

TEST(PatchMemory, PatchesHaveNoRoomToSpare) {
    const Mesh mesh = made::ball(5);
    Patch patch = made::whole(mesh);
    const auto fits = [&] {
        EXPECT_EQ(patch.points.capacity(), patch.points.size());
        EXPECT_EQ(patch.origins.capacity(), patch.origins.size());
        EXPECT_EQ(patch.triangles.capacity(), patch.triangles.size());
        EXPECT_EQ(patch.faces.capacity(), patch.faces.size());
        EXPECT_EQ(patch.neighbours.capacity(), patch.neighbours.size());
    };
    fits();
    std::vector<SideMask> sides(patch.points.size(), 0);
    sides[patch.triangles[7][0]] = sides[patch.triangles[7][1]] = 1;
    EXPECT_EQ(split_chords(patch, sides), 1u);
    fits();
}

/// Rows that are filled twice over, or room for more than there is, would show.
TEST(PatchMemory, TexelsPointsHaveNoRoomToSpare) {
    const Mesh mesh = made::ball(5);
    const PatchAtlas atlas = *build_patch_atlas(mesh, build_connectivity(mesh), {.size = 512});
    const SolidAtlas solid = rasterize_patches(atlas, atlas.refined.mesh.positions);
    EXPECT_GT(solid.turned.size(), 1000u);  // gutters
    EXPECT_EQ(solid.maps.size(), atlas.atlas.corners.size() + solid.turned.size());
    EXPECT_EQ(solid.maps.capacity(), solid.maps.size());
    EXPECT_EQ(solid.turned.capacity(), solid.turned.size());
    EXPECT_EQ(solid.spans.capacity(), solid.spans.size());
    EXPECT_EQ(solid.row_begin.back(), solid.spans.size());
    std::size_t texels = 0;
    for (const Span& span : solid.spans) texels += span.count;
    EXPECT_EQ(texels, 512u * 512u);
}

}  // namespace
}  // namespace burl
