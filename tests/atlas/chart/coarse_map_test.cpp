// Maps carried over from coarser patches: one to one, with the same border, nearly as good as the
// map of the fine patch, and smoothing never makes one worse.
#include "atlas/chart/coarse_map.h"

#include <gtest/gtest.h>

#include "atlas/chart/stretch_sweeps.h"
#include "tests/atlas/support/made_patches.h"

namespace burl {
namespace {

/// A sheet of n x n squares over a hill.
Patch hill(std::uint32_t n) {
    Mesh mesh = made::grid(n, n);
    for (Vec3d& p : mesh.positions)
        p.z = 0.4 * std::exp(-12.0 * ((p.x - 0.4) * (p.x - 0.4) + (p.y - 0.6) * (p.y - 0.6)));
    return made::whole(mesh);
}

/// Moves inner vertices at random, by less than half the way to a neighbour in a regular grid.
void roughen(const Patch& patch, std::vector<Vec2d>& uv, double most) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-most, most);
    const std::vector<bool> inner = inner_vertices(patch);
    for (std::size_t v = 0; v < uv.size(); ++v)
        if (inner[v]) uv[v] += Vec2d{any(random), any(random)};
}

TEST(CoarseMap, CoarsePatchesKeepTheBorderAndComeBack) {
    Patch fine = hill(40);
    const auto direct = map_onto_rectangle(fine);
    ASSERT_TRUE(direct);
    CoarsePatch coarse = coarsen_patch(fine, 800);
    made::expect_sound(coarse.patch);
    EXPECT_LT(coarse.patch.triangles.size(), fine.triangles.size() / 2);
    ASSERT_EQ(coarse.patch.loops.size(), 1u);
    ASSERT_EQ(coarse.patch.loops[0].size(), fine.loops[0].size());
    for (std::size_t i = 0; i < fine.loops[0].size(); ++i)
        EXPECT_EQ(coarse.fine_vertex[coarse.patch.start(coarse.patch.loops[0][i])],
                  fine.start(fine.loops[0][i]));
    const auto map = map_onto_rectangle(coarse.patch);
    ASSERT_TRUE(map);
    EXPECT_EQ(map->extra_vertices, 0u);
    const auto uv = carry_to_fine(fine, coarse, map->uv);
    ASSERT_TRUE(uv);
    made::expect_fills_square(fine, *uv);
    for (std::size_t v = 0; v < coarse.fine_vertex.size(); ++v)
        EXPECT_EQ((*uv)[coarse.fine_vertex[v]], map->uv[v]);
    EXPECT_LT(StretchMeasure(fine)(*uv).distortion(), 1.3 * direct->stretch.distortion());
}

TEST(CoarseMap, FlatSurfacesComeBackExactly) {
    Mesh mesh = made::grid(20, 20);
    for (Vec3d& p : mesh.positions) p.z = 0.0;
    Patch fine = made::whole(mesh);
    const CoarsePatch coarse = coarsen_patch(fine, 300);
    std::vector<Vec2d> uv;
    for (const Vec3d& p : coarse.patch.points) uv.emplace_back(p.x, p.y);
    const auto carried = carry_to_fine(fine, coarse, uv);
    ASSERT_TRUE(carried);
    for (std::size_t v = 0; v < fine.points.size(); ++v)
        EXPECT_LT(glm::distance((*carried)[v], Vec2d(fine.points[v])), 1e-12);
}

TEST(CoarseMap, RandomDisksComeBackOneToOne) {
    for (std::uint32_t seed = 60; seed < 80; ++seed) {
        Patch fine = made::random_disk(seed, 400);
        std::vector<SideMask> border(fine.points.size(), 0);
        for (const HalfEdge h : fine.loops[0]) border[fine.start(h)] = 1;
        split_chords(fine, border);
        CoarsePatch coarse = coarsen_patch(fine, fine.triangles.size() / 3);
        const auto map = map_onto_rectangle(coarse.patch);
        ASSERT_TRUE(map) << seed;
        const auto uv = carry_to_fine(fine, coarse, map->uv);
        ASSERT_TRUE(uv) << seed;
        made::expect_fills_square(fine, *uv);
    }
}

TEST(CoarseMap, LargePatchesAreMappedNearlyAsWell) {
    Patch large = hill(124), small = hill(60);
    ASSERT_GT(large.triangles.size(), largest_patch);
    auto map = map_patch(large, {});
    const auto direct = map_onto_rectangle(small);
    ASSERT_TRUE(map && direct);
    EXPECT_TRUE(map->coarse);
    made::expect_sound(large);
    made::expect_fills_square(large, map->uv);
    EXPECT_NEAR(map->stretch.distortion(), direct->stretch.distortion(), 0.01);
    EXPECT_EQ(map->stretch.distortion(), StretchMeasure(large)(map->uv).distortion());
    EXPECT_EQ(map->sides, side_masks(large, map->corners));
    fit_map(large, *map, {.iterations = 10, .aspect = 2.0, .least_gain = 1e-4});
    made::expect_fills_square(large, map->uv);
    EXPECT_LT(map->stretch.distortion(), 1.5);
}

TEST(StretchSweeps, SmoothAndNeverRise) {
    Patch patch = hill(24);
    const auto map = map_onto_rectangle(patch);
    ASSERT_TRUE(map);
    const StretchMeasure measure(patch);
    std::vector<Vec2d> uv = map->uv;
    roughen(patch, uv, 0.012);
    const double aspect = map->stretch.best_aspect();
    const auto energy = [&](const std::vector<Vec2d>& at) {
        const Stretch s = measure(at);
        return s.x / aspect + s.y * aspect;
    };
    const double best = energy(map->uv), rough = energy(uv);
    ASSERT_GT(rough, 1.05 * best);
    const std::vector<bool> inner = inner_vertices(patch);
    double before = rough;
    for (int i = 0; i < 4; ++i) {
        const std::vector<Vec2d> from = uv;
        sweep_stretch(patch, uv, aspect, 1);
        EXPECT_LE(energy(uv), before);
        before = energy(uv);
        for (std::size_t v = 0; v < uv.size(); ++v) EXPECT_TRUE(inner[v] || uv[v] == from[v]);
    }
    EXPECT_LT(before - best, 0.1 * (rough - best));
}

}  // namespace
}  // namespace burl
