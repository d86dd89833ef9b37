// Corner search against exhaustive search on small patches, and Laplacians against their
// definition.
#include "atlas/chart/corner_search.h"

#include <gtest/gtest.h>

#include "atlas/chart/laplacian.h"
#include "atlas/chart/rectangle_map.h"
#include "tests/atlas/support/made_patches.h"

namespace burl {
namespace {

TEST(CornerSearch, NearlyAsGoodAsTryingAllCorners) {
    for (const Mesh& mesh : {made::grid(6, 4), made::grid(5, 5), made::grid(8, 2)}) {
        const Patch patch = made::whole(mesh);
        const auto choice = search_corners(patch);
        ASSERT_TRUE(choice);
        double best = std::numeric_limits<double>::infinity();
        const std::size_t n = patch.loops[0].size();
        for (std::size_t a = 0; a < n; ++a)
            for (std::size_t b = a + 1; b < n; ++b)
                for (std::size_t c = b + 1; c < n; ++c)
                    for (std::size_t d = c + 1; d < n; ++d) {
                        Patch split = patch;
                        split_chords(split, side_masks(split, {a, b, c, d}));
                        const auto map = harmonic_map(split, {a, b, c, d});
                        if (map) best = std::min(best, map->stretch.distortion());
                    }
        EXPECT_LT(choice->distortion, 1.1 * best);
    }
}

TEST(CornerSearch, FindsTheCornersOfASheet) {
    Mesh sheet = made::grid(9, 5);
    for (Vec3d& p : sheet.positions) p.z = 0.0;
    const Patch patch = made::whole(sheet);
    const auto choice = search_corners(patch);
    ASSERT_TRUE(choice);
    EXPECT_NEAR(choice->distortion, 1.0, 1e-6);
    for (const std::size_t corner : choice->corners) {
        const Vec3d p = patch.points[patch.start(patch.loops[0][corner])];
        EXPECT_TRUE((p.x == 0.0 || p.x == 1.0) && (p.y == 0.0 || p.y == 5.0 / 9.0)) << p.x;
    }
}

TEST(CornerSearch, EndsEarlyWhenHopeless) {
    const Patch patch = made::random_disk(6, 150);
    const auto all = search_corners(patch), few = search_corners(patch, 1.0);
    ASSERT_TRUE(all && few);
    EXPECT_GE(few->distortion, all->distortion);
    EXPECT_GT(few->distortion, 1.0);
}

/// Every free vertex is the weighted mean of its neighbours.
TEST(Laplacian, HarmonicFieldsAreMeansAndBatchesChangeNoBit) {
    const Patch patch = made::random_disk(7, 200);
    const WeightedEdges edges = weighted_edges(patch);
    const PatchLaplacian laplacian(edges, inner_vertices(patch));
    ASSERT_TRUE(laplacian.factored());
    std::mt19937 random(1);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    std::vector<std::vector<Vec2d>> fields(6, std::vector<Vec2d>(patch.points.size()));
    for (auto& field : fields)
        for (Vec2d& value : field) value = {any(random), any(random)};
    auto alone = fields;
    laplacian.solve_harmonic(fields);
    for (auto& field : alone) laplacian.solve_harmonic({&field, 1});
    EXPECT_EQ(fields, alone);
    const std::vector<bool> inner = inner_vertices(patch);
    for (const auto& field : fields) {
        std::vector<Vec2d> balance(field.size(), Vec2d(0.0));
        for (const auto& e : edges.edges) {
            balance[e.a] += e.weight * (field[e.b] - field[e.a]);
            balance[e.b] += e.weight * (field[e.a] - field[e.b]);
        }
        for (std::size_t v = 0; v < field.size(); ++v)
            if (inner[v]) {
                EXPECT_LT(glm::length(balance[v]), 1e-9);
            }
    }
}

TEST(Laplacian, InverseUndoesTheMatrixAlsoForOtherWeights) {
    const Patch patch = made::random_disk(8, 120);
    WeightedEdges edges = weighted_edges(patch);
    const std::vector<bool> inner = inner_vertices(patch);
    PatchLaplacian laplacian(edges, inner);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> any(0.5, 2.0);
    for (int round = 0; round < 2; ++round) {
        std::vector<double> x(inner.size());
        for (std::size_t v = 0; v < x.size(); ++v) x[v] = inner[v] ? any(random) : 0.0;
        std::vector<double> image(x.size(), 0.0);
        for (const auto& e : edges.edges) {
            image[e.a] += e.weight * (x[e.a] - x[e.b]);
            image[e.b] += e.weight * (x[e.b] - x[e.a]);
        }
        laplacian.apply_inverse(image, image);
        for (std::size_t v = 0; v < x.size(); ++v) EXPECT_NEAR(image[v], x[v], 1e-9);
        for (auto& e : edges.edges) e.weight *= any(random);
        laplacian.refactor(edges);
        ASSERT_TRUE(laplacian.factored());
    }
}

}  // namespace
}  // namespace burl
