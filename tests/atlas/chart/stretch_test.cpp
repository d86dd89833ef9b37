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

TEST(Stretch, AnisotropyHasItsClosedForm) {
    // A rectangle 1 x 0.5 as one of aspect 2 keeps its angles; as a square it has s1 / s2 = 2.
    const Patch patch = made::whole(flat_grid());
    const StretchMeasure measure(patch);
    const auto uv = flat_uv(patch, 1.0, 0.5);
    EXPECT_NEAR(measure.anisotropy(uv, 2.0), 1.0, 1e-12);
    EXPECT_NEAR(measure.anisotropy(uv, 1.0), 1.25 * 1.25, 1e-12);
    EXPECT_NEAR(measure.anisotropy(uv, 6.0), std::pow(0.5 * (3.0 + 1.0 / 3.0), 2), 1e-12);
    // A shear by k has (s1 / s2 + s2 / s1) / 2 = 1 + k^2 / 2, whatever its scale.
    std::vector<Vec2d> sheared;
    for (const Vec3d& p : patch.points) sheared.emplace_back(0.1 * (p.x - 0.7 * p.y), 0.1 * p.y);
    EXPECT_NEAR(measure.anisotropy(sheared, 1.0), std::pow(1.0 + 0.245, 2), 1e-12);
}

TEST(Stretch, SliversHaveNoAnisotropy) {
    // A triangle of 1 x 0.005 beside one of 1 x 1; the sliver alone is sheared.
    const Mesh mesh = made::mesh_of({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -0.005, 0}},
                                    {{0, 1, 2}, {0, 3, 1}});
    const Patch patch = made::whole(mesh);
    std::vector<Vec2d> uv(patch.points.size());
    for (std::size_t v = 0; v < uv.size(); ++v) {
        uv[v] = Vec2d(patch.points[v].x, patch.points[v].y);
        if (uv[v].y < 0.0) uv[v].x += 0.3;
    }
    EXPECT_NEAR(StretchMeasure(patch).anisotropy(uv, 1.0), 1.0, 1e-9);
}

TEST(Stretch, AnisotropysGradientMatchesDifferences) {
    const Patch patch = made::random_disk(3, 60);
    const StretchMeasure measure(patch);
    auto uv = flat_uv(patch, 1.0, 1.0);
    constexpr double factor = 0.7, aspect = 1.6, h = 1e-6;
    std::vector<Vec2d> gradient(uv.size(), Vec2d(2.0, -3.0));
    measure.add_anisotropy_gradient(uv, aspect, factor, gradient);
    double largest = 0.0;
    for (Vec2d& g : gradient) {
        g -= Vec2d(2.0, -3.0);
        largest = std::max({largest, std::abs(g.x), std::abs(g.y)});
    }
    EXPECT_GT(largest, 0.01);
    for (std::size_t v = 0; v < uv.size(); ++v)
        for (const int axis : {0, 1}) {
            const double at = uv[v][axis];
            uv[v][axis] = at + h;
            const double above = measure.anisotropy(uv, aspect);
            uv[v][axis] = at - h;
            const double below = measure.anisotropy(uv, aspect);
            uv[v][axis] = at;
            EXPECT_NEAR(factor * (above - below) / (2.0 * h), gradient[v][axis], 1e-6 * largest)
                << v;
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
