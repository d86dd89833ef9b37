// What lies side by side in a quad atlas is near on the surface: the order of halves, how blocks
// are turned, and what both are worth against blocks in random order.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <random>

#include <tbb/global_control.h>

#include "atlas/blocks/quad_arrangement.h"
#include "atlas/measure/lookup_errors.h"
#include "procedural/model/metric_marble.h"
#include "tests/atlas/support/made_meshes.h"

namespace burl {
namespace {

Atlas quad_neighbours_layout(const Mesh& mesh, std::uint32_t size,
                             AtlasWeight weight = AtlasWeight::error) {
    return layout_atlas(mesh, made::neighbours_by_brute_force(mesh),
                        {AtlasKind::quad, Overscan::bilinear, size, weight});
}

/// A complete tree over 2^depth items, all nodes halved the way `upright` says by depth.
std::vector<QuadNode> complete_tree(const std::vector<Vec3d>& items,
                                    const std::vector<bool>& upright) {
    std::vector<QuadNode> nodes(2 * items.size() - 1);
    const auto build = [&](const auto& self, std::size_t node, std::size_t first, std::size_t count,
                           std::size_t depth) -> void {
        QuadNode& n = nodes[node];
        n.first = std::uint32_t(first);
        n.count = std::uint32_t(count);
        n.centre = std::accumulate(items.begin() + std::ptrdiff_t(first),
                                   items.begin() + std::ptrdiff_t(first + count), Vec3d(0.0)) /
                   double(count);
        if (count == 1) return;
        n.half = std::uint32_t(count / 2);
        if (upright[depth]) n.upright = ~std::uint64_t{0};
        self(self, node + 1, first, count / 2, depth + 1);
        self(self, node + count, first + count / 2, count / 2, depth + 1);
    };
    build(build, 0, 0, items.size(), 0);
    return nodes;
}

TEST(QuadArrangement, ALineInDisorderRunsThroughInOrder) {
    // Halves and their halves are exchanged at random: only the order can put that right.
    std::vector<Vec3d> items;
    for (const int i : {0, 1, 3, 2, 7, 6, 4, 5}) items.emplace_back(i, 0, 0);
    const std::vector<QuadNode> nodes = complete_tree(items, {false, false, false});
    const std::vector<QuadSpot> spots = arrange(nodes, 3);
    ASSERT_EQ(spots.size(), 8u);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(nodes[spots[i].node].centre.x, double(i));
        EXPECT_EQ(spots[i].at.x, i);
        EXPECT_EQ(spots[i].beside[quad_left], i == 0 ? no_spot : i - 1);
        EXPECT_EQ(spots[i].beside[quad_right], i == 7 ? no_spot : i + 1);
        EXPECT_EQ(spots[i].beside[quad_above], no_spot);
    }
}

TEST(QuadArrangement, ASheetInDisorderLiesFlat) {
    // 4 x 4 points, halved in x, y, x, y; every pair of halves is in the wrong order or not by a
    // hash of where it is.
    std::vector<Vec3d> items(16);
    for (std::uint32_t i = 0; i < 16; ++i) {
        std::uint32_t at = 0;
        for (std::uint32_t bit = 0; bit < 4; ++bit) {
            const std::uint32_t prefix = (i >> (4 - bit)) + (1u << bit);
            const std::uint32_t flip = (prefix * 2654435761u >> 13) & 1u;
            at |= ((i >> (3 - bit) & 1u) ^ flip) << (3 - bit);
        }
        items[i] = Vec3d(2 * (at >> 3 & 1) + (at >> 1 & 1), 2 * (at >> 2 & 1) + (at & 1), 0);
    }
    const std::vector<QuadNode> nodes = complete_tree(items, {false, true, false, true});
    const std::vector<QuadSpot> spots = arrange(nodes, 2);
    ASSERT_EQ(spots.size(), 16u);
    for (const QuadSpot& spot : spots)
        for (const QuadSide side : {quad_left, quad_right, quad_below, quad_above})
            if (spot.beside[side] != no_spot) {
                const QuadNode& other = nodes[spots[spot.beside[side]].node];
                EXPECT_EQ(glm::distance(nodes[spot.node].centre, other.centre), 1.0);
            }
}

/// Corners of a block's triangles on the mesh, by their place in the texture.
std::map<std::pair<double, double>, Vec3d> corners_on_mesh(const Mesh& mesh, const Atlas& atlas) {
    std::map<std::pair<double, double>, Vec3d> corners;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            corners[{atlas.corners[t][k].x, atlas.corners[t][k].y}] =
                mesh.positions[mesh.triangles[t][k]];
    return corners;
}

// Whichever triangle of a pair comes first in the file, most of a flat sheet comes out in one
// piece: the corners on both sides of a border between blocks are the same points. Turned at random
// a quarter of them would be. (A part of the sheet whose halves go the other way folds.)
TEST(QuadTurns, BlocksSideBySideShareTheirEdges) {
    Mesh mesh = made::grid(16, 16);
    for (Vec3d& p : mesh.positions) p.z = 0.0;
    std::mt19937 random(5);
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 2)
        if (random() % 2 == 0) std::swap(mesh.triangles[t], mesh.triangles[t + 1]);
    const Atlas atlas = quad_neighbours_layout(mesh, 128);
    ASSERT_EQ(atlas.blocks.size(), 256u);
    const auto corners = corners_on_mesh(mesh, atlas);
    std::size_t same = 0, all = 0;
    for (const auto& [place, point] : corners) {
        // Corners lie on the centres of the border texels of 8 x 8 blocks.
        for (const auto& [dx, dy] : {std::pair{1.0, 0.0}, std::pair{0.0, 1.0}}) {
            const auto next = corners.find({place.first + dx, place.second + dy});
            if (next == corners.end()) continue;
            ++all;
            if (next->second == point) ++same;
        }
    }
    EXPECT_EQ(all, 2u * 2u * 15u * 16u);
    EXPECT_GT(double(same), 0.7 * double(all));
}

/// The atlas with its blocks exchanged at random among those of equal sides.
Atlas in_random_order(const Atlas& atlas, std::uint32_t seed) {
    Atlas shuffled = atlas;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> classes;
    for (std::size_t i = 0; i < atlas.blocks.size(); ++i)
        classes[{atlas.blocks[i].width, atlas.blocks[i].height}].push_back(i);
    std::mt19937 random(seed);
    for (const auto& [sides, members] : classes) {
        std::vector<std::size_t> order = members;
        std::shuffle(order.begin(), order.end(), random);
        for (std::size_t i = 0; i < members.size(); ++i) {
            Block& block = shuffled.blocks[members[i]];
            const Block& place = atlas.blocks[order[i]];
            const Vec2d move{double(place.x) - block.x, double(place.y) - block.y};
            block.x = place.x;
            block.y = place.y;
            for (const std::int32_t t : {block.lower, block.upper})
                if (t >= 0)
                    for (Vec2d& c : shuffled.corners[std::size_t(t)]) c += move;
        }
    }
    return shuffled;
}

LookupErrors lookups(const Mesh& mesh, const Atlas& atlas, const SurfaceTruth& truth) {
    return measure_lookups(
        mesh, atlas, fill_texture(rasterize(mesh, atlas, mesh.positions), grey(metric_marble)),
        mesh_edges(mesh, made::neighbours_by_brute_force(mesh)), truth,
        [](double value) { return value; });
}

// The paper's figure 8, as lookups of metric-marble: 16 texels a pair, the levels above the
// blocks.
TEST(QuadOrder, RandomOrderLosesWhatTheTreeKeeps) {
    Mesh mesh = made::ball(6);
    for (Vec3d& p : mesh.positions) p /= std::sqrt(3.0);
    TruthOptions options;
    options.points = 200;
    options.level_points = 600;
    options.levels = 5;
    options.size = 512;
    const SurfaceTruth truth = surface_truth(mesh, grey(metric_marble), options);
    const Atlas atlas = quad_neighbours_layout(mesh, options.size);
    const LookupErrors tree = lookups(mesh, atlas, truth),
                       random = lookups(mesh, in_random_order(atlas, 1), truth);
    EXPECT_NEAR(tree.psnr, random.psnr, 1e-6);
    ASSERT_EQ(tree.levels.size(), 6u);
    for (std::size_t l = 3; l <= 5; ++l)
        EXPECT_GT(random.levels[l].rmse, 1.8 * tree.levels[l].rmse) << "level " << l;
}

TEST(QuadAtlas, IsTheSameForEveryThreadCount) {
    const Mesh mesh = made::grid(120, 110);  // so many pairs that their tree is built by several
    const Connectivity connectivity = build_connectivity(mesh);
    const auto laid_out = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return layout_atlas(mesh, connectivity, {AtlasKind::quad, Overscan::bilinear, 512});
    };
    const Atlas one = laid_out(1);
    ASSERT_GT(one.blocks.size(), 8192u);
    for (const std::size_t threads : {2, 3, 8}) {
        const Atlas many = laid_out(threads);
        EXPECT_EQ(many.corners, one.corners) << threads;
        EXPECT_EQ(many.charts, one.charts) << threads;
        EXPECT_EQ(many.chart_count, one.chart_count) << threads;
    }
}

}  // namespace
}  // namespace burl
