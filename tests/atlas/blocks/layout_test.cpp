// The atlases on made meshes: every texel has one owner, every lookup stays with its
// triangle, sizes follow the weights, and the same mesh gives the same bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <tuple>

#include "atlas/base/error.h"
#include "atlas/measure/atlas_measures.h"
#include "tests/atlas/support/made_meshes.h"

namespace burl {
namespace {

constexpr AtlasKind kinds[] = {AtlasKind::uniform, AtlasKind::area, AtlasKind::length,
                               AtlasKind::quad};
constexpr Overscan overscans[] = {Overscan::nearest, Overscan::bilinear};

Atlas layout(const Mesh& mesh, const AtlasOptions& options) {
    return layout_atlas(mesh, made::neighbours_by_brute_force(mesh), options);
}

/// Calls check(mesh, atlas) for every made mesh, kind, overscan and a few sizes that fit.
template <class Check>
void for_all_atlases(Check check) {
    for (const auto& [name, mesh] : made::all())
        for (const AtlasKind kind : kinds)
            for (const Overscan overscan : overscans) {
                AtlasOptions options{kind, overscan, 0};
                const std::uint32_t least = smallest_size(mesh.triangles.size(), options);
                for (const std::uint32_t size : {least, least + 1, 17u, 50u, 128u, 333u}) {
                    if (size < least || !made::allowed(kind, size)) continue;
                    options.size = size;
                    SCOPED_TRACE(fmt::format("{} {} {} {}", name, to_string(kind),
                                             to_string(overscan), size));
                    check(mesh, layout(mesh, options));
                    if (testing::Test::HasFailure()) return;
                }
            }
}

double signed_texels(const std::array<Vec2d, 3>& c) {
    const Vec2d u = c[1] - c[0], v = c[2] - c[0];
    return 0.5 * (u.x * v.y - u.y * v.x);
}

bool same_atlas(const Atlas& a, const Atlas& b) {
    const auto same_block = [](const Block& s, const Block& t) {
        return std::tie(s.x, s.y, s.width, s.height, s.lower, s.upper, s.leg_x, s.leg_y,
                        s.overscan) == std::tie(t.x, t.y, t.width, t.height, t.lower, t.upper,
                                                t.leg_x, t.leg_y, t.overscan);
    };
    return a.charts == b.charts && a.corners.size() == b.corners.size() &&
           std::memcmp(a.corners.data(), b.corners.data(),
                       a.corners.size() * sizeof a.corners[0]) == 0 &&
           std::equal(a.blocks.begin(), a.blocks.end(), b.blocks.begin(), b.blocks.end(),
                      same_block);
}

TEST(Layout, BlocksTileTheSquareAndHoldEveryTriangleOnce) {
    for_all_atlases([](const Mesh& mesh, const Atlas& atlas) {
        const std::size_t size = atlas.options.size;
        std::vector<int> owners(size * size, 0), blocks_of(mesh.triangles.size(), 0);
        for (const Block& block : atlas.blocks) {
            ASSERT_LE(block.x + block.width, size);
            ASSERT_LE(block.y + block.height, size);
            for (std::size_t y = block.y; y < block.y + block.height; ++y)
                for (std::size_t x = block.x; x < block.x + block.width; ++x)
                    ++owners[y * size + x];
            ++blocks_of[std::size_t(block.lower)];
            if (block.upper >= 0) ++blocks_of[std::size_t(block.upper)];
        }
        EXPECT_EQ(std::count(owners.begin(), owners.end(), 1), std::ptrdiff_t(owners.size()));
        EXPECT_EQ(std::count(blocks_of.begin(), blocks_of.end(), 1),
                  std::ptrdiff_t(blocks_of.size()));
    });
}

TEST(Layout, EveryTriangleHasAreaAndKeepsItsOrientation) {
    for_all_atlases([](const Mesh&, const Atlas& atlas) {
        const std::vector<bool> collapsed = made::collapsed_triangles(atlas);
        for (std::size_t t = 0; t < atlas.corners.size(); ++t) {
            const auto& corners = atlas.corners[t];
            // The least is one texel's half, its three edges pulled in by 1/32 texel (nearest).
            const double least =
                collapsed[t] ? -1e-9
                             : 0.5 * std::pow(1.0 - (2.0 + std::sqrt(2.0)) / 32.0, 2) - 1e-9;
            EXPECT_GT(signed_texels(corners), least);
            for (const Vec2d& c : corners) {
                EXPECT_GE(std::min(c.x, c.y), 0.0);
                EXPECT_LE(std::max(c.x, c.y), atlas.options.size);
            }
        }
    });
}

TEST(Layout, CornersAreTexelCentresForBilinear) {
    for_all_atlases([](const Mesh&, const Atlas& atlas) {
        if (atlas.options.overscan != Overscan::bilinear) return;
        for (const auto& corners : atlas.corners)
            for (const Vec2d& c : corners) {
                EXPECT_EQ(c.x - std::floor(c.x), 0.5);
                EXPECT_EQ(c.y - std::floor(c.y), 0.5);
            }
    });
}

TEST(Layout, TrianglesOfOneChartMeetInThePointsTheyShare) {
    for_all_atlases([](const Mesh& mesh, const Atlas& atlas) {
        std::map<std::uint32_t, std::vector<std::size_t>> charts;
        for (std::size_t t = 0; t < atlas.charts.size(); ++t) charts[atlas.charts[t]].push_back(t);
        EXPECT_EQ(charts.size(), atlas.chart_count);
        for (const Block& block : atlas.blocks) {
            if (!block.shares_hypotenuse) continue;
            int common = 0;
            const auto& lower = mesh.triangles[std::size_t(block.lower)];
            const auto& upper = mesh.triangles[std::size_t(block.upper)];
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t j = 0; j < 3; ++j)
                    common +=
                        lower[i] == upper[j] && atlas.corners[std::size_t(block.lower)][i] ==
                                                    atlas.corners[std::size_t(block.upper)][j];
            EXPECT_EQ(common, 2);
            EXPECT_EQ(atlas.charts[std::size_t(block.lower)],
                      atlas.charts[std::size_t(block.upper)]);
        }
    });
}

TEST(Layout, JoinedBlocksShareTheirVerticalMeshEdge) {
    std::uint64_t joints = 0;
    for_all_atlases([&](const Mesh& mesh, const Atlas& atlas) {
        for (std::size_t i = 0; i < atlas.blocks.size(); ++i) {
            const Block& block = atlas.blocks[i];
            if (!block.joins_left) continue;
            ++joints;
            const auto left = std::size_t(atlas.blocks[i - 1].upper);
            const auto right = std::size_t(block.lower);
            int common = 0;
            for (std::size_t a = 0; a < 3; ++a)
                for (std::size_t b = 0; b < 3; ++b)
                    common += mesh.triangles[left][a] == mesh.triangles[right][b] &&
                              atlas.corners[left][a] == atlas.corners[right][b];
            EXPECT_EQ(common, 2);
            EXPECT_EQ(atlas.charts[left], atlas.charts[right]);
        }
    });
    EXPECT_GT(joints, 100u);
}

TEST(Layout, ScalingByPowersOfTwoAndRepeatingGiveTheSameBits) {
    for (const auto& [name, mesh] : made::all())
        for (const AtlasKind kind : kinds)
            for (const Overscan overscan : overscans) {
                const AtlasOptions options{kind, overscan, kind == AtlasKind::quad ? 256u : 200u};
                const Atlas atlas = layout(mesh, options);
                EXPECT_TRUE(same_atlas(atlas, layout(mesh, options))) << name;
                for (const double scale : {0x1p-20, 0.5, 0x1p30}) {
                    Mesh scaled = mesh;
                    for (Vec3d& p : scaled.positions) p *= scale;
                    EXPECT_TRUE(same_atlas(atlas, layout(scaled, options))) << name << scale;
                }
            }
}

TEST(Layout, ClosedAndOpenSurfacesArePairedCompletelyAndChained) {
    for (const Mesh& mesh : {made::ball(3), made::grid(20, 20)}) {
        const Atlas atlas = layout(mesh, {AtlasKind::uniform, Overscan::bilinear, 256});
        EXPECT_EQ(atlas.notes.paired_triangles, mesh.triangles.size());
        EXPECT_EQ(atlas.notes.overscan_texels, 0u);
        EXPECT_GT(atlas.notes.strips, 0u);
        EXPECT_GT(atlas.notes.saved_texels, atlas.notes.texels_total / 10);
        EXPECT_LT(atlas.chart_count, mesh.triangles.size() / 4);
    }
}

// 0-1-2-3 in a chain whose middle edge is the best match: only an augmenting path pairs all four.
TEST(Layout, AugmentingPathsLeaveNoTriangleAlone) {
    const Mesh mesh =
        made::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {-.6, .5, 0}, {1.6, .5, 0}},
                      {{0, 2, 4}, {0, 1, 2}, {1, 3, 2}, {1, 5, 3}});
    const Atlas atlas = layout(mesh, {AtlasKind::area, Overscan::nearest, 64});
    EXPECT_EQ(atlas.notes.paired_triangles, 4u);
    EXPECT_EQ(atlas.blocks.size(), 2u);
}

TEST(Layout, AreaWeightedTexelsFollowArea) {
    for (const Mesh& mesh : {made::ball(3), made::grid(20, 20), made::soup(400, 5)}) {
        const Atlas atlas = layout(mesh, {AtlasKind::area, Overscan::nearest, 1024});
        const AtlasMetrics m = measure(mesh, atlas, rasterize(mesh, atlas, mesh.positions));
        EXPECT_GT(m.coverage, 0.9);
        EXPECT_GT(m.density[0], 0.75);
        EXPECT_LT(m.density[2], 1.33);
    }
}

TEST(Layout, LengthWeightedTexelsFollowTheLongestEdge) {
    const Mesh mesh = made::soup(400, 6);
    const Atlas atlas = layout(mesh, {AtlasKind::length, Overscan::nearest, 1024});
    std::vector<double> ratios;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        ratios.push_back(std::sqrt(signed_texels(atlas.corners[t])) / longest_edge(mesh, t));
    std::sort(ratios.begin(), ratios.end());
    EXPECT_LT(ratios[380] / ratios[20], 1.4);
}

TEST(Layout, UniformTrianglesAreAllAboutOneSize) {
    const Mesh mesh = made::taper(200, 0.97);
    const Atlas atlas = layout(mesh, {AtlasKind::uniform, Overscan::bilinear, 512});
    std::uint32_t shortest = 512, longest = 0;
    for (const Block& block : atlas.blocks) {
        shortest = std::min({shortest, block.leg_x, block.leg_y});
        longest = std::max({longest, block.leg_x, block.leg_y});
    }
    EXPECT_LE(longest - shortest, 4u) << shortest << " to " << longest;
}

TEST(Layout, CoverageReachesNinetyPercentUpToThreeThousandTriangles) {
    for (const Mesh& mesh : {made::ball(4), made::grid(38, 38), made::soup(3000, 7), made::fan(500),
                             made::taper(300, 0.98)})
        for (const AtlasKind kind : {AtlasKind::area, AtlasKind::length}) {
            const Atlas atlas = layout(mesh, {kind, Overscan::nearest, 1024});
            const AtlasMetrics m = measure(mesh, atlas, rasterize(mesh, atlas, mesh.positions));
            EXPECT_GE(m.coverage, 0.9) << mesh.triangles.size() << to_string(kind);
        }
}

TEST(Layout, TrianglesWithoutAreaComeLastAndTakeTheNarrowestCells) {
    const Mesh mesh = made::nasty();
    const Atlas atlas = layout(mesh, {AtlasKind::area, Overscan::bilinear, 128});
    EXPECT_GE(atlas.notes.minimal_cells, 3u);
    EXPECT_EQ(triangle_area(mesh, std::size_t(atlas.blocks.back().lower)), 0.0);
}

TEST(Layout, SmallestSizeIsTightForTrianglesThatTouchNothing) {
    for (const Overscan overscan : overscans)
        for (const std::uint32_t count :
             {1u, 2u, 3u, 4u, 5u, 9u, 10u, 16u, 17u, 100u, 101u, 397u}) {
            const Mesh mesh = made::soup(count, count);
            AtlasOptions options{AtlasKind::area, overscan, 0};
            const std::uint32_t size = smallest_size(count, options);
            options.size = size;
            EXPECT_EQ(layout(mesh, options).corners.size(), count);
            options.size = size - 1;
            EXPECT_THROW(layout(mesh, options), Error) << count;
        }
}

TEST(Layout, SaysWhichSizeWouldDo) {
    const Mesh mesh = made::soup(100, 1);
    try {
        layout(mesh, {AtlasKind::area, Overscan::bilinear, 10});
        FAIL() << "100 loose triangles cannot fit";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::runtime);
        EXPECT_STREQ(error.what(),
                     "made has 100 triangles, which do not fit a 10 x 10 texture with this "
                     "overscan; use --size 20 or larger");
    }
}

TEST(Layout, MeshesAtTheEndsOfTheNumberRangeAreLaidOutLikeAnyOther) {
    const Mesh mesh = made::ball(2);
    const AtlasOptions options{AtlasKind::area, Overscan::bilinear, 128};
    const Atlas atlas = layout(mesh, options);
    for (const double scale : {0x1p-900, 0x1p900, 0x1p1022}) {
        Mesh extreme = mesh;
        for (Vec3d& p : extreme.positions) p *= scale;
        const Atlas other = layout(extreme, options);
        const auto points = map_positions(extreme, solid_from_mesh(extreme, SolidSpace::unit));
        const AtlasMetrics m = measure(extreme, other, rasterize(extreme, other, points));
        EXPECT_EQ(m.zero_area, 0u);
        EXPECT_NEAR(m.relative_scale, std::sqrt(m.coverage), 0.05);
        for (const Vec3d& p : points) EXPECT_LE(glm::length(p), 0.8661);
        EXPECT_EQ(other.notes.paired_triangles, atlas.notes.paired_triangles);
    }
}

TEST(Layout, NoTrianglesGiveNoBlocks) {
    const Mesh mesh;
    const Atlas atlas = layout(mesh, {AtlasKind::area, Overscan::bilinear, 4});
    EXPECT_TRUE(atlas.blocks.empty());
    const SolidAtlas solid = rasterize(mesh, atlas, {});
    EXPECT_EQ(solid.row(3).size(), 0u);
    EXPECT_EQ(measure(mesh, atlas, solid).coverage, 0.0);
}

TEST(Layout, RefusesSizesThatNoTextureHas) {
    for (const std::uint32_t size : {0u, max_atlas_size + 1, 100000u}) {
        try {
            layout(made::square(), {AtlasKind::area, Overscan::bilinear, size});
            FAIL() << size;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::usage);
        }
    }
}

}  // namespace
}  // namespace burl
