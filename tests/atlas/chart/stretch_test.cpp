// The stretch against its closed form on affine maps, its gradient against differences, and the
// step to a collapse against a search.
#include "atlas/chart/stretch.h"

#include <gtest/gtest.h>

#include "tests/atlas/support/made_patches.h"

namespace burl {
namespace {

/// uv = x, y of the points scaled to the unit square.
std::vector<Vec2d> flat_uv(const Patch& patch, double width, double height) {
    std::vector<Vec2d> uv;
    for (const Vec3d& p : patch.points) uv.emplace_back(p.x / width, p.y / height);
    return uv;
}

Mesh flat_grid() {
    Mesh mesh = made::grid(6, 3);
    for (Vec3d& p : mesh.positions) p.z = 0.0;
    return mesh;
}

TEST(Stretch, FlatRectangleHasDistortionOneWhateverItsProportions) {
    Mesh mesh = flat_grid();
    for (Vec3d& p : mesh.positions) p.x *= 10.0;
    const Patch patch = made::whole(mesh);
    const Stretch s = StretchMeasure(patch)(flat_uv(patch, 10.0, 0.5));
    EXPECT_NEAR(s.area, 5.0, 1e-12);
    EXPECT_NEAR(s.x, 5.0 * 100.0, 1e-9);
    EXPECT_NEAR(s.y, 5.0 * 0.25, 1e-12);
    EXPECT_NEAR(s.distortion(), 1.0, 1e-12);
    EXPECT_NEAR(s.best_aspect(), 20.0, 1e-10);
}

TEST(Stretch, ShearHasItsClosedForm) {
    // (x + k y, y): |ds/du| = 1, |ds/dv|^2 = 1 + k^2 for the inverse of u = x - k y.
    const Patch patch = made::whole(flat_grid());
    std::vector<Vec2d> uv;
    for (const Vec3d& p : patch.points) uv.emplace_back(p.x - 0.7 * p.y, p.y);
    const Stretch s = StretchMeasure(patch)(uv);
    EXPECT_NEAR(s.x, s.area, 1e-12);
    EXPECT_NEAR(s.y, s.area * (1.0 + 0.49), 1e-12);
}

TEST(Stretch, FlippedOrCollapsedTrianglesAreInfinite) {
    const Patch patch = made::whole(flat_grid());
    auto uv = flat_uv(patch, 1.0, 0.5);
    const StretchMeasure measure(patch);
    ASSERT_TRUE(measure(uv).finite());
    for (Vec2d& q : uv) q.x = 1.0 - q.x;
    EXPECT_FALSE(measure(uv).finite());
    EXPECT_TRUE(std::isinf(measure(uv).distortion()));
    for (Vec2d& q : uv) q.x = 0.5;
    EXPECT_FALSE(measure(uv).finite());
}

TEST(Stretch, GradientMatchesDifferences) {
    const Patch patch = made::random_disk(3, 60);
    const StretchMeasure measure(patch);
    auto uv = flat_uv(patch, 1.0, 1.0);
    ASSERT_TRUE(measure(uv).finite());
    const double fx = 0.7, fy = 1.9, h = 1e-6;
    const auto gradient = measure.gradient(uv, fx, fy);
    const auto energy = [&] {
        const Stretch s = measure(uv);
        return fx * s.x + fy * s.y;
    };
    double largest = 0.0;
    for (const Vec2d& g : gradient) largest = std::max({largest, std::abs(g.x), std::abs(g.y)});
    for (std::size_t v = 0; v < uv.size(); ++v)
        for (const int axis : {0, 1}) {
            const double at = uv[v][axis];
            uv[v][axis] = at + h;
            const double above = energy();
            uv[v][axis] = at - h;
            const double below = energy();
            uv[v][axis] = at;
            EXPECT_NEAR((above - below) / (2.0 * h), gradient[v][axis], 1e-6 * largest) << v;
        }
}

TEST(Stretch, StepToCollapseIsWhereTheFirstTriangleFlips) {
    const Patch patch = made::random_disk(5, 60);
    const StretchMeasure measure(patch);
    const auto uv = flat_uv(patch, 1.0, 1.0);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int turn = 0; turn < 20; ++turn) {
        std::vector<Vec2d> direction;
        for (std::size_t v = 0; v < uv.size(); ++v) direction.push_back({any(random), any(random)});
        const double step = measure.step_to_collapse(uv, direction);
        const auto at = [&](double t) {
            auto moved = uv;
            for (std::size_t v = 0; v < uv.size(); ++v) moved[v] += t * direction[v];
            return measure(moved);
        };
        for (const double share : {0.25, 0.5, 0.75, 1.0 - 1e-9})
            EXPECT_TRUE(at(share * step).finite());
        EXPECT_FALSE(at((1.0 + 1e-6) * step).finite());
    }
    EXPECT_TRUE(std::isinf(measure.step_to_collapse(uv, std::vector<Vec2d>(uv.size()))));
}

TEST(Stretch, HolesCountLittle) {
    Patch patch = made::whole(flat_grid());
    patch.faces[0] = not_in_mesh;
    const double one = area_of(patch, 0);
    EXPECT_NEAR(StretchMeasure(patch)(flat_uv(patch, 1.0, 0.5)).area,
                0.5 - one * (1.0 - fan_weight), 1e-12);
}

}  // namespace
}  // namespace burl
