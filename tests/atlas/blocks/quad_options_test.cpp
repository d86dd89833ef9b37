// The quad atlas's options and what it does when texels are few: clusters by coordinates or by the
// graph, gutters, diagonals with overscan, and pairs that share a texel.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "atlas/measure/atlas_measures.h"
#include "tests/atlas/support/made_meshes.h"

namespace burl {
namespace {

AtlasOptions quad(std::uint32_t size) {
    return {AtlasKind::quad, Overscan::bilinear, size};
}

AtlasOptions with_gutter(std::uint32_t size, std::uint32_t gutter) {
    AtlasOptions options = quad(size);
    options.gutter = gutter;
    return options;
}

AtlasOptions by_graph(std::uint32_t size) {
    AtlasOptions options = quad(size);
    options.partition = AtlasPartition::graph;
    return options;
}

Atlas quad_options_layout(const Mesh& mesh, const AtlasOptions& options) {
    return layout_atlas(mesh, made::neighbours_by_brute_force(mesh), options);
}

/// Per texel the map it shows.
std::vector<std::uint32_t> shown(const SolidAtlas& solid) {
    std::vector<std::uint32_t> maps(std::size_t{solid.size} * solid.size, ~0u);
    for (std::size_t y = 0; y < solid.size; ++y)
        for (const Span& span : solid.row(y))
            for (std::size_t x = span.x; x < span.x + span.count; ++x) {
                EXPECT_EQ(maps[y * solid.size + x], ~0u);
                maps[y * solid.size + x] = span.map;
            }
    return maps;
}

/// A tube bent until its walls nearly touch: clusters by place reach across, by the graph not.
Mesh two_sheets() {
    Mesh mesh = made::grid(24, 24);
    const auto count = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::uint32_t i = 0; i < count; ++i)
        mesh.positions.push_back(mesh.positions[i] + Vec3d(0.0, 0.0, 0.01));
    const std::vector<Triangle> one = mesh.triangles;
    for (const auto& [a, b, c] : one) mesh.triangles.push_back({a + count, b + count, c + count});
    return made::mesh_of(mesh.positions, mesh.triangles);
}

/// The number of squares of 16 x 16 texels that show triangles of both sheets.
std::size_t mixed_squares(const Mesh& mesh, const Atlas& atlas) {
    const std::vector<std::uint32_t> maps = shown(rasterize(mesh, atlas, mesh.positions));
    std::map<std::size_t, std::set<bool>> sheets;
    for (std::size_t i = 0; i < maps.size(); ++i)
        sheets[i / 128 / 16 * 8 + i % 128 / 16].insert(maps[i] < mesh.triangles.size() / 2);
    return std::size_t(std::count_if(sheets.begin(), sheets.end(),
                                     [](const auto& s) { return s.second.size() > 1; }));
}

TEST(QuadGraph, ClustersAreConnectedWhereCoordinatesMixSheets) {
    const Mesh mesh = two_sheets();
    EXPECT_GT(mixed_squares(mesh, quad_options_layout(mesh, quad(128))), 32u);
    EXPECT_LT(mixed_squares(mesh, quad_options_layout(mesh, by_graph(128))), 8u);
}

/// How many connected pieces the triangles have whose blocks lie in one of the 4^depth squares of
/// the texture, in the mean of the squares.
double pieces_per_square(const Mesh& mesh, const Atlas& atlas, std::uint32_t depth) {
    const Connectivity connectivity = made::neighbours_by_brute_force(mesh);
    const std::uint32_t side = atlas.options.size >> depth;
    std::vector<std::uint32_t> square(mesh.triangles.size());
    for (const Block& block : atlas.blocks) {
        const auto x = std::uint32_t(block.x + block.width / 2) / side,
                   y = std::uint32_t(block.y + block.height / 2) / side;
        for (const std::int32_t t : {block.lower, block.upper})
            if (t >= 0) square[std::size_t(t)] = (y << depth) + x;
    }
    std::vector<bool> reached(square.size(), false);
    std::size_t pieces = 0;
    for (std::size_t first = 0; first < square.size(); ++first) {
        if (reached[first]) continue;
        ++pieces;
        for (std::vector<std::size_t> open{first}; !open.empty();) {
            const std::size_t t = open.back();
            open.pop_back();
            if (reached[t]) continue;
            reached[t] = true;
            for (const std::int32_t n : connectivity.neighbours[t])
                if (n >= 0 && square[std::size_t(n)] == square[t]) open.push_back(std::size_t(n));
        }
    }
    return double(pieces) / double(std::set(square.begin(), square.end()).size());
}

TEST(QuadGraph, ClustersAreMostlyInOnePiece) {
    const Mesh sheets = two_sheets(), ball = made::ball(4);
    EXPECT_GE(pieces_per_square(sheets, quad_options_layout(sheets, quad(128)), 3), 2.0);
    for (const Mesh& mesh : {sheets, ball})
        for (const std::uint32_t depth : {1u, 2u, 3u})
            EXPECT_LE(pieces_per_square(mesh, quad_options_layout(mesh, by_graph(128)), depth), 1.1)
                << depth;
}

TEST(QuadGraph, TilesTheSquareAndRepeatsBitForBitAtEveryScale) {
    for (const auto& [name, mesh] : made::all()) {
        const Atlas atlas = quad_options_layout(mesh, by_graph(64));
        const SolidAtlas solid = rasterize(mesh, atlas, mesh.positions);
        EXPECT_EQ(measure(mesh, atlas, solid).texel_coverage, 1.0) << name;
        for (const double scale : {1.0, 0x1p-20, 0x1p30}) {
            Mesh scaled = mesh;
            for (Vec3d& p : scaled.positions) p *= scale;
            EXPECT_EQ(quad_options_layout(scaled, by_graph(64)).corners, atlas.corners)
                << name << scale;
        }
    }
}

TEST(QuadSharing, EveryTexelShowsOneOfThePairsThatShareIt) {
    const Mesh mesh = made::ball(4);  // 2048 triangles, 1024 pairs
    const Atlas atlas = quad_options_layout(mesh, quad(16));
    EXPECT_EQ(atlas.notes.minimal_cells, 2048u);
    EXPECT_EQ(atlas.notes.shared_triangles, 2048u);
    EXPECT_EQ(atlas.notes.shared_texels, 256u);
    const SolidAtlas solid = rasterize(mesh, atlas, mesh.positions);
    const std::vector<std::uint32_t> maps = shown(solid);
    std::map<std::size_t, std::vector<std::size_t>> groups;
    for (std::size_t t = 0; t < 2048; ++t) {
        const Vec2d& c = atlas.corners[t][0];
        for (const Vec2d& corner : atlas.corners[t]) EXPECT_EQ(corner, c);
        groups[std::size_t(c.y) * 16 + std::size_t(c.x)].push_back(t);
    }
    ASSERT_EQ(groups.size(), 256u);
    for (const auto& [texel, triangles] : groups) {
        EXPECT_EQ(triangles.size(), 8u);  // all pairs are alike, so each texel gets four
        EXPECT_EQ(std::count(triangles.begin(), triangles.end(), maps[texel]), 1);
        // Neighbours: the whole ball is 2 wide, a texel's share of its surface 0.22.
        const Vec3d middle = solid.maps[maps[texel]](std::int64_t(texel % 16), texel / 16);
        for (const std::size_t t : triangles)
            for (const std::uint32_t p : mesh.triangles[t])
                EXPECT_LT(glm::distance(mesh.positions[p], middle), 0.5);
        for (const std::size_t t : triangles)
            EXPECT_EQ(atlas.charts[t], atlas.charts[triangles[0]]);
    }
}

TEST(QuadSharing, HoldsAnyMeshInAnyTexture) {
    for (const auto& [name, mesh] : made::all())
        for (const Overscan overscan : {Overscan::nearest, Overscan::bilinear})
            for (const AtlasPartition partition : {AtlasPartition::rcb, AtlasPartition::graph})
                for (const std::uint32_t size : {1u, 2u, 4u, 8u}) {
                    AtlasOptions options = quad(size);
                    options.overscan = overscan;
                    options.partition = partition;
                    const Atlas atlas = quad_options_layout(mesh, options);
                    const std::vector<std::uint32_t> maps =
                        shown(rasterize(mesh, atlas, mesh.positions));
                    EXPECT_EQ(std::count(maps.begin(), maps.end(), ~0u), 0) << name << size;
                    for (const auto& corners : atlas.corners)
                        for (const Vec2d& c : corners)
                            EXPECT_TRUE(c.x > 0.0 && c.y > 0.0 && c.x < size && c.y < size)
                                << name << size;
                }
}

// Loose triangles, so that the number of pairs and singles is known: sharing starts when there are
// more than texels, and only then.
TEST(QuadSharing, StartsWhereTexelsEnd) {
    for (const std::uint32_t count : {255u, 256u, 257u, 300u, 512u, 1000u}) {
        const Mesh mesh = made::soup(count, 8);
        const LayoutNotes notes = quad_options_layout(mesh, quad(16)).notes;
        EXPECT_EQ(notes.shared_texels > 0, count > 256);
        if (count <= 256) continue;
        EXPECT_EQ(notes.minimal_cells, count);
        // Each texel shows a triangle of its own, the others are guests.
        EXPECT_EQ(notes.shared_triangles - notes.shared_texels, count - 256);
    }
}

TEST(QuadGutter, IsAsWideAsAskedOrHalvedUntilItIsAnEighthOfTheBlock) {
    std::uint64_t narrowed = 0;
    for (const auto& [name, mesh] : made::all())
        for (const std::uint32_t gutter : {1u, 2u, 3u, 5u, 8u}) {
            const Atlas atlas = quad_options_layout(mesh, with_gutter(128, gutter));
            std::uint64_t texels = 0, fewer = 0;
            for (const Block& block : atlas.blocks) {
                std::uint32_t expected = gutter;
                while (8 * expected > std::min(block.width, block.height)) expected /= 2;
                EXPECT_EQ(block.gutter, expected);
                EXPECT_EQ(block.leg_x + 1 + 2 * expected, block.width);
                EXPECT_EQ(block.leg_y + 1 + 2 * expected, block.height);
                texels += block.width * block.height - (block.leg_x + 1) * (block.leg_y + 1);
                fewer += expected < gutter ? 1 : 0;
                for (const std::int32_t t : {block.lower, block.upper})
                    for (std::size_t k = 0; t >= 0 && k < 3; ++k) {
                        const Vec2d& c = atlas.corners[std::size_t(t)][k];
                        EXPECT_GE(c.x, block.x + expected + 0.5);
                        EXPECT_GE(c.y, block.y + expected + 0.5);
                        EXPECT_LE(c.x, block.x + block.width - expected - 0.5);
                        EXPECT_LE(c.y, block.y + block.height - expected - 0.5);
                    }
            }
            EXPECT_EQ(atlas.notes.gutter_texels, texels);
            EXPECT_EQ(atlas.notes.narrowed_gutters, fewer);
            narrowed += fewer;
        }
    EXPECT_GT(narrowed, 100u);
}

// What a gutter is for: with a plane's affine map every texel of the block, gutter included, shows
// the plane where the same map goes on, so box averages stay right beyond the triangle's edge.
TEST(QuadGutter, GoesOnWithTheTrianglesOnItsSideOfTheDiagonal) {
    const Mesh mesh = made::square();
    const Atlas atlas = quad_options_layout(mesh, with_gutter(32, 3));
    const SolidAtlas solid = rasterize(mesh, atlas, mesh.positions);
    const std::vector<std::uint32_t> maps = shown(solid);
    const TexelMap& map = solid.maps[0];
    std::set<std::uint32_t> used;
    for (std::int64_t y = 0; y < 32; ++y)
        for (std::int64_t x = 0; x < 32; ++x) {
            const std::uint32_t own = maps[std::size_t(y * 32 + x)];
            used.insert(own);
            EXPECT_LT(glm::distance(solid.maps[own](x, y), map(x, y)), 1e-12);
        }
    EXPECT_EQ(used, (std::set<std::uint32_t>{0, 1}));
    const Vec3d low = map(0, 0), high = map(31, 31);
    EXPECT_NEAR(glm::distance(low, high), std::sqrt(2.0) * 31.0 / 25.0, 1e-12);
}

// Lookups up to a whole texel outside a triangle, as the next level's have them, still read texels
// that show the plane of the triangle or of its partner.
TEST(QuadGutter, LookupsBesideABlockStayWithItsTriangles) {
    const Mesh mesh = made::ball(2);
    const Atlas atlas = quad_options_layout(mesh, with_gutter(256, 2));
    const SolidAtlas solid = rasterize(mesh, atlas, mesh.positions);
    const std::vector<std::uint32_t> maps = shown(solid);
    std::uint64_t checked = 0;
    for (const Block& block : atlas.blocks) {
        ASSERT_EQ(block.gutter, 2u);
        for (std::uint32_t y = block.y; y < block.y + block.height; ++y)
            for (std::uint32_t x = block.x; x < block.x + block.width; ++x, ++checked) {
                const auto t = std::int32_t(solid.triangle_of(maps[std::size_t{y} * 256 + x]));
                EXPECT_TRUE(t == block.lower || t == block.upper);
            }
    }
    EXPECT_EQ(checked, 65536u);
}

// A pair whose diagonals' middles are apart by a quarter of the diagonal.
Mesh kinked() {
    return made::mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.7}, {0, 1, 0}}, {{0, 1, 3}, {1, 2, 3}});
}

/// Largest distance between bilinear lookups of the solid point and the surface.
double worst_lookup(const Mesh& mesh, const Atlas& atlas) {
    const SolidAtlas solid = rasterize(mesh, atlas, mesh.positions);
    const std::vector<std::uint32_t> maps = shown(solid);
    const std::uint32_t size = solid.size;
    double worst = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (int a = 0; a <= 60; ++a)
            for (int b = 0; a + b <= 60; ++b) {
                const Vec3d w = Vec3d(a, b, 60 - a - b) / 60.0;
                Vec2d at{-0.5};
                Vec3d point{0.0}, looked_up{0.0};
                for (std::size_t k = 0; k < 3; ++k) {
                    at += w[int(k)] * atlas.corners[t][k];
                    point += w[int(k)] * mesh.positions[mesh.triangles[t][k]];
                }
                const Vec2d low = glm::clamp(glm::floor(at), 0.0, size - 2.0);
                for (const int dy : {0, 1})
                    for (const int dx : {0, 1}) {
                        const auto x = std::int64_t(low.x) + dx, y = std::int64_t(low.y) + dy;
                        const double weight =
                            (1.0 - std::abs(at.x - double(x))) * (1.0 - std::abs(at.y - double(y)));
                        looked_up +=
                            weight * solid.maps[maps[std::size_t(y) * size + std::size_t(x)]](x, y);
                    }
                worst = std::max(worst, glm::distance(looked_up, point));
            }
    return worst;
}

TEST(QuadDiagonals, OverscanRemovesTheKinkOfAPair) {
    const Mesh mesh = kinked();
    AtlasOptions options = quad(64);
    EXPECT_GT(worst_lookup(mesh, quad_options_layout(mesh, options)), 1e-3);
    options.diagonals = Diagonals::overscan;
    const Atlas atlas = quad_options_layout(mesh, options);
    EXPECT_GT(atlas.notes.overscan_texels, 64u);
    EXPECT_EQ(atlas.notes.paired_triangles, 2u);
    EXPECT_LT(worst_lookup(mesh, atlas), 1e-12);
    options.gutter = 3;
    EXPECT_LT(worst_lookup(mesh, quad_options_layout(mesh, options)), 1e-12);
}

TEST(QuadDiagonals, StaySharedWherePairsAreFlatOrBlocksSmall) {
    AtlasOptions options = quad(64);
    options.diagonals = Diagonals::overscan;
    EXPECT_EQ(quad_options_layout(made::square(), options).notes.overscan_texels, 0u);
    options.size = 16;
    EXPECT_EQ(quad_options_layout(kinked(), options).notes.overscan_texels, 0u);
}

}  // namespace
}  // namespace burl
