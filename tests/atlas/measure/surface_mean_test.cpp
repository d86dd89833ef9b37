// Means over surfaces against closed forms, and against a plain sum over a regular grid.
#include "atlas/measure/surface_mean.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <numbers>

#include "atlas/measure/surface_truth.h"
#include "tests/atlas/support/kept_wave.h"
#include "tests/atlas/support/made_meshes.h"

namespace burl {
namespace {

constexpr double detail = 1.0;

std::vector<SurfacePoint> inner_points(const Mesh& mesh, double margin) {
    std::vector<SurfacePoint> inner;
    for (const SurfacePoint& p : area_uniform_points(mesh, 400, 5)) {
        const Vec3d at = position(mesh, p);
        if (std::min({at.x, at.y, 1.0 - at.x, 1.0 - at.y}) > margin) inner.push_back(p);
    }
    return inner;
}

TEST(SurfacePoints, AreSpreadByArea) {
    const Mesh mesh =
        made::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {3, 0, 5}, {0, 3, 5}, {0, 0, 5}},
                      {{0, 1, 2}, {0, 0, 1}, {3, 4, 5}});
    const auto points = area_uniform_points(mesh, 10000, 1);
    ASSERT_EQ(points.size(), 10000u);
    std::array<double, 3> counts{};
    Vec3d mean(0.0);
    for (const SurfacePoint& p : points) {
        counts[p.triangle] += 1.0;
        EXPECT_NEAR(p.weights.x + p.weights.y + p.weights.z, 1.0, 1e-12);
        EXPECT_GE(std::min({p.weights.x, p.weights.y, p.weights.z}), 0.0);
        if (p.triangle == 2) mean += p.weights / 9000.0;
    }
    EXPECT_NEAR(counts[0], 1000.0, 1.0);  // areas 1/2, 0 and 9/2
    EXPECT_EQ(counts[1], 0.0);
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(mean[axis], 1.0 / 3.0, 0.01);
    EXPECT_TRUE(area_uniform_points(made::mesh_of({{0, 0, 0}}, {{0, 0, 0}}), 10, 1).empty());
}

TEST(SurfaceSamples, PiecesAddUpToTheSurface) {
    for (const auto& [name, mesh] : made::all()) {
        double expected = 0.0, sum = 0.0;
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) expected += triangle_area(mesh, t);
        for (const SurfaceSample& s :
             sample_surface(mesh, 0.05, 1, [](const Vec3d&) { return true; }))
            sum += s.area;
        EXPECT_NEAR(sum / expected, 1.0, 1e-9) << name;
    }
}

// The Gaussian mean of a linear function on a plane is the function, away from the border.
TEST(SurfaceMean, OfALinearFunctionIsTheFunction) {
    const Mesh mesh = made::square();
    const SolidColor f = grey([](const Vec3d& p) { return 3.0 * p.x - 2.0 * p.y + 0.5; });
    for (const double sigma : {0.005, 0.02, 0.1}) {
        const auto points = inner_points(mesh, gaussian_cut * sigma);
        const auto means = surface_means(mesh, f, points, sigma, detail, 1);
        double squares = 0.0;
        for (std::size_t i = 0; i < points.size(); ++i)
            squares += mean_square(means[i] - f(position(mesh, points[i])));
        // One sigma away f differs by 3.6 sigma.
        EXPECT_LT(std::sqrt(squares / double(points.size())), 0.1 * sigma) << sigma;
    }
}

// A wave of number k keeps exp(-k^2 s^2 / 2) of its amplitude; cut at 2.6 sigma a little more.
TEST(SurfaceMean, DampsAWaveAsTheGaussianDoes) {
    const Mesh mesh = made::square();
    const double sigma = 0.03, k = 1.0 / sigma;
    const SolidColor f = grey([k](const Vec3d& p) { return std::cos(k * p.x); });
    const auto points = inner_points(mesh, gaussian_cut * sigma);
    const auto means = surface_means(mesh, f, points, sigma, 0.3 * sigma, 1);
    const double kept = made::kept_by_gaussian(1.0, gaussian_cut);
    EXPECT_NEAR(kept, std::exp(-0.5), 0.04);
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_NEAR(means[i].x, kept * f(position(mesh, points[i])).x, 0.01);
}

// Eight times as long as wide: a wave along it is damped as by eight sigmas, one across as by one,
// one at an angle as by both.
TEST(SurfaceMean, DampsAWaveByTheElongatedFootprint) {
    const Mesh mesh = made::square();
    const double sigma = 0.01, stretch = 8.0, k = 1.0 / (stretch * sigma);
    const SolidColor f = [k](const Vec3d& p) {
        return Vec3d(std::cos(k * p.x), std::cos(k * p.y), std::cos(k * (p.x + p.y) / 8.0));
    };
    const auto points = inner_points(mesh, gaussian_cut * stretch * sigma);
    ASSERT_GT(points.size(), 100u);
    const std::vector<Vec3d> across(points.size(), Vec3d(0.0, 1.0, 0.0));
    const auto means = surface_means(mesh, f, points, sigma, sigma, 1, Elongation{stretch, across});
    const double along = made::kept_by_gaussian(1.0, gaussian_cut);
    const double narrow = made::kept_by_gaussian(1.0 / stretch, gaussian_cut);
    const double slanted = made::kept_by_gaussian(std::hypot(1.0, 1.0 / 8.0) / 8.0, gaussian_cut);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3d here = f(position(mesh, points[i]));
        EXPECT_NEAR(means[i].x, along * here.x, 0.01);
        EXPECT_NEAR(means[i].y, narrow * here.y, 0.01);
        EXPECT_NEAR(means[i].z, slanted * here.z, 0.01);
    }
}

// The axes lie in the triangle's plane and turn evenly.
TEST(SurfaceTruth, GrazingFootprintsPointAnywhereInThePlane) {
    const Mesh mesh = made::mesh_of({{0, 0, 0}, {3, 0, 4}, {0, 2, 0}}, {{0, 1, 2}});
    TruthOptions options;
    options.size = 128;
    options.points = 10;
    options.level_points = 10;
    options.grazing_points = 1000;
    options.detail = 0.2;
    const SurfaceTruth truth = surface_truth(mesh, grey([](const Vec3d&) { return 0.5; }), options);
    ASSERT_EQ(truth.grazing.levels.size(), 2u);  // the third level has 16 texels a side
    ASSERT_EQ(truth.grazing.axes.size(), 1000u);
    const Vec3d normal = face_normal(mesh, 0);
    double squares = 0.0, mixed = 0.0;
    for (const FootprintAxes& axes : truth.grazing.axes) {
        EXPECT_NEAR(glm::length(axes.along), 1.0, 1e-12);
        EXPECT_NEAR(glm::length(axes.across), 1.0, 1e-12);
        EXPECT_NEAR(glm::dot(axes.along, axes.across), 0.0, 1e-12);
        EXPECT_NEAR(glm::dot(axes.along, normal), 0.0, 1e-12);
        EXPECT_NEAR(glm::dot(axes.across, normal), 0.0, 1e-12);
        squares += axes.along.y * axes.along.y / 1000.0;
        mixed += axes.along.y * axes.across.y / 1000.0;
    }
    EXPECT_NEAR(squares, 0.5, 0.05);
    EXPECT_NEAR(mixed, 0.0, 0.05);
    for (const Vec3d& mean : truth.grazing.levels[0].means) EXPECT_NEAR(mean.x, 0.5, 1e-12);
}

TEST(SurfaceMean, LeavesOutTheOtherSideOfASheet) {
    Mesh mesh = made::mesh_of({{0, 0, 0},
                               {1, 0, 0},
                               {1, 1, 0},
                               {0, 1, 0},
                               {0, 0, 0.001},
                               {1, 0, 0.001},
                               {1, 1, 0.001},
                               {0, 1, 0.001}},
                              {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}});
    const SolidColor top = grey([](const Vec3d& p) { return p.z > 0.0005 ? 1.0 : 0.0; });
    const auto points = area_uniform_points(mesh, 200, 2);
    const auto means = surface_means(mesh, top, points, 0.05, detail, 1);
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_EQ(means[i].x, points[i].triangle < 2 ? 0.0 : 1.0);
    for (Triangle& t : mesh.triangles)  // turned the same way both count
        if (t[0] == 0) std::swap(t[1], t[2]);
    const auto both = surface_means(mesh, top, points, 0.05, detail, 1);
    for (const Vec3d& mean : both) EXPECT_NEAR(mean.x, 0.5, 0.05);
}

TEST(SurfaceTruth, NoiseIsTheErrorOfTheTruth) {
    Mesh mesh = made::square();
    const SolidColor f = grey([](const Vec3d& p) { return 3.0 * p.x; });
    TruthOptions options;
    options.size = 64;
    options.level_points = 3000;
    options.points = 100;
    options.levels = 4;
    options.detail = 1.0;
    const SurfaceTruth truth = surface_truth(mesh, f, options);
    ASSERT_EQ(truth.levels.size(), 4u);
    for (std::size_t l = 1; l <= 3; ++l) {
        const double sigma = std::ldexp(1.0 / 64, int(l) - 1);
        double squares = 0.0, count = 0.0;
        for (std::size_t i = 0; i < truth.level_points.size(); ++i) {
            const Vec3d at = position(mesh, truth.level_points[i]);
            if (std::min({at.x, at.y, 1 - at.x, 1 - at.y}) < gaussian_cut * sigma) continue;
            squares += mean_square(truth.levels[l - 1].means[i] - f(at));
            count += 1.0;
        }
        const double error = std::sqrt(squares / count), noise = truth.levels[l - 1].noise;
        EXPECT_LT(error, 1.5 * noise) << l;
        EXPECT_GT(error, noise / 3.0) << l;
    }
    options.size = 4;  // no more levels than the texture has
    EXPECT_EQ(surface_truth(mesh, f, options).levels.size(), 2u);
}

// The count of --max-noises is known before anything is called.
TEST(SurfaceTruth, CallsAreCountedBeforehand) {
    for (const auto& [name, mesh] : made::all())
        for (const std::uint32_t size : {16u, 64u}) {
            TruthOptions options;
            options.size = size;
            options.level_points = 2000;
            options.points = 1000;
            options.grazing_points = 500;
            options.view_points = 20;
            std::atomic<std::size_t> calls = 0;
            const SolidColor f = grey([&](const Vec3d&) { return double(++calls > 0); });
            surface_truth(mesh, f, options);
            const double counted = truth_calls(mesh, options);
            EXPECT_NEAR(counted / double(calls), 1.1, 0.2) << name << ' ' << size;
        }
}

}  // namespace
}  // namespace burl
