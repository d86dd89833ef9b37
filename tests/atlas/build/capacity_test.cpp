// Texels per triangle and the sizes proposed, against the definition; loose pieces; what takes the
// place of patches.
#include "atlas/build/capacity.h"

#include <gtest/gtest.h>

#include "atlas/build/mesh_atlas.h"
#include "tests/atlas/support/made_meshes.h"

namespace burl {
namespace {

AtlasOptions of(AtlasKind kind, std::uint32_t size) {
    AtlasOptions options;
    options.kind = kind;
    options.size = size;
    return options;
}

TEST(Capacity, ProposesTheSmallestSizesThatSuffice) {
    for (const std::uint64_t triangles : {1u, 7u, 5856u, 69451u, 1000000u})
        for (const AtlasKind kind : {AtlasKind::patch, AtlasKind::area}) {
            const Capacity c = capacity(triangles, of(kind, 64));
            EXPECT_DOUBLE_EQ(c.texels_per_triangle, 4096.0 / double(triangles));
            for (const auto& [size, wanted] :
                 {std::pair(c.good_size, 25.0), std::pair(c.least_size, 5.0)}) {
                ASSERT_GT(size, 0u);
                EXPECT_GE(double(size) * size, wanted * double(triangles));
                EXPECT_LT(double(size - 1) * (size - 1), wanted * double(triangles));
            }
        }
    const Capacity quad = capacity(5856, of(AtlasKind::quad, 64));
    EXPECT_EQ(quad.good_size, 512u);  // 25 x 5856 texels are 382.6 squared
    EXPECT_EQ(quad.least_size, 256u);
    EXPECT_EQ(quad.holding_size, 128u);
    EXPECT_EQ(capacity(100'000'000, of(AtlasKind::patch, 64)).good_size, 0u);
}

TEST(Capacity, SaysSoInOneSentence) {
    EXPECT_EQ(shortage(capacity(100, of(AtlasKind::patch, 50))), "");
    EXPECT_EQ(shortage(capacity(100, of(AtlasKind::patch, 30))),
              "9 texels per triangle at 30 x 30; --size 50 gives 25");
    EXPECT_EQ(shortage(capacity(100, of(AtlasKind::patch, 20))),
              "4 texels per triangle at 20 x 20: a colour per vertex would show as much; --size 23 "
              "gives 5, --size 50 gives 25");
    EXPECT_NE(shortage(capacity(100'000'000, of(AtlasKind::patch, 64))).find("no size gives 25"),
              std::string::npos);
}

TEST(Capacity, OfATextureThatIsNotSquareIsOfItsTexels) {
    AtlasOptions wide = of(AtlasKind::uv, 64);
    wide.height = 1;
    EXPECT_DOUBLE_EQ(capacity(2, wide).texels_per_triangle, 32.0);
    wide.size = 8, wide.height = 2;
    EXPECT_EQ(shortage(capacity(2, wide)), "8 texels per triangle at 8 x 2; --size 8 gives 25");
}

TEST(Capacity, LoosePiecesAreToldByTexelsEach) {
    Connectivity pieces;
    pieces.shells = 1000;
    EXPECT_EQ(why_no_patches(pieces, of(AtlasKind::patch, 512)), "");  // 262 texels each
    EXPECT_EQ(why_no_patches(pieces, of(AtlasKind::patch, 500)),
              "1000 loose pieces would have 250 texels each, too few for patches");
    EXPECT_EQ(why_no_patches(pieces, of(AtlasKind::chart, 500)),
              "1000 loose pieces would have 250 texels each, too few for charts");
    pieces.shells = 20;
    EXPECT_EQ(why_no_patches(pieces, of(AtlasKind::patch, 4)), "");
}

TEST(Capacity, MostlyLoosePiecesBecomePairs) {
    const Mesh soup = made::soup(400, 3);
    const Connectivity connectivity = build_connectivity(soup);
    ASSERT_GT(connectivity.shells, 200u);
    const MeshAtlas few = build_atlas(soup, connectivity, of(AtlasKind::patch, 128));
    EXPECT_EQ(few.atlas().options.kind, AtlasKind::quad);
    EXPECT_NE(few.atlas().notes.fallback.find("loose pieces"), std::string::npos);
    const MeshAtlas enough = build_atlas(soup, connectivity, of(AtlasKind::patch, 1024));
    EXPECT_EQ(enough.atlas().options.kind, AtlasKind::patch);
    EXPECT_EQ(enough.atlas().notes.fallback, "");
}

TEST(Capacity, PairsTakeTheLargestSquareOrStripsWhereItIsSmall) {
    const Mesh soup = made::soup(400, 3);
    const Connectivity connectivity = build_connectivity(soup);
    const MeshAtlas inside = build_atlas(soup, connectivity, of(AtlasKind::patch, 150));
    EXPECT_EQ(inside.atlas().options.kind, AtlasKind::quad);
    EXPECT_EQ(inside.atlas().options.size, 150u);
    EXPECT_NE(inside.atlas().notes.fallback.find("128 x 128"), std::string::npos);
    for (const auto& corners : inside.atlas().corners)
        for (const Vec2d& c : corners) EXPECT_LT(std::max(c.x, c.y), 128.0);
    const MeshAtlas strips = build_atlas(soup, connectivity, of(AtlasKind::patch, 250));
    EXPECT_EQ(strips.atlas().options.kind, AtlasKind::area);
    EXPECT_NE(strips.atlas().notes.fallback.find("area atlas"), std::string::npos);
}

}  // namespace
}  // namespace burl
