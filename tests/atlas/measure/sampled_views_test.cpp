// Sampled views against closed forms: waves on a plane, a sphere met by its equation, plates; and
// samplers against their definition.
#include "atlas/measure/sampled_views.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <tbb/global_control.h>

#include "atlas/measure/lookup_errors.h"
#include "atlas/measure/uv_atlas.h"
#include "tests/atlas/support/made_meshes.h"

namespace burl {
namespace {

constexpr double radian = std::numbers::pi / 180.0;

double sinc(double x) {
    return std::abs(x) < 1e-9 ? 1.0 : std::sin(x) / x;
}

/// Leaves out pixels that come within `margin` of the unit square's border.
SampledViews inside(const SampledViews& views, const Mesh& mesh, double margin) {
    SampledViews kept{{}, {}, views.texel, views.rows};
    for (ViewRow& row : kept.rows) row.means.clear();
    for (std::size_t i = 0; i < views.points.size(); ++i) {
        const Vec3d at = position(mesh, views.points[i]);
        if (std::min({at.x, at.y, 1.0 - at.x, 1.0 - at.y}) < margin) continue;
        kept.points.push_back(views.points[i]);
        kept.axes.push_back(views.axes[i]);
        for (std::size_t r = 0; r < views.rows.size(); ++r)
            kept.rows[r].means.push_back(views.rows[r].means[i]);
    }
    return kept;
}

TEST(SampledViews, AxesAreThePointsOwnPlane) {
    const Mesh mesh = made::ball(2);
    const SampledViews views =
        sample_views(mesh, grey([](const Vec3d&) { return 0.5; }), 0.01, {.points = 200});
    ASSERT_EQ(views.points.size(), 200u);
    ASSERT_EQ(views.rows.size(), 25u);
    Vec3d mean_along(0.0);
    for (std::size_t i = 0; i < views.points.size(); ++i) {
        const Vec3d n = face_normal(mesh, views.points[i].triangle);
        const auto& [along, across] = views.axes[i];
        EXPECT_NEAR(glm::dot(along, n), 0.0, 1e-12);
        EXPECT_NEAR(glm::length(glm::cross(along, across) - n), 0.0, 1e-12);
        mean_along += along / 200.0;
        const PixelSteps steps = views.steps(i, {4.0, 60.0, {}, 0.0});
        EXPECT_NEAR(glm::length(steps.x - 0.04 * across), 0.0, 1e-12);
        EXPECT_NEAR(glm::length(steps.y - 0.08 * along), 0.0, 1e-12);
    }
    EXPECT_LT(glm::length(mean_along), 0.2);
}

// On a plane a pixel is a parallelogram, over which a wave's mean is known.
TEST(SampledViews, MeansOfAWaveOnAPlane) {
    const Mesh mesh = made::square();
    const Vec3d k(70.0, 40.0, 0.0);
    ViewOptions options{.points = 400, .minifications = {1.0, 4.0}, .tilts = {0.0, 60.0, 80.0}};
    const SampledViews all = sample_views(
        mesh, grey([&](const Vec3d& p) { return std::cos(glm::dot(k, p)); }), 0.005, options);
    const SampledViews views = inside(all, mesh, 0.08);
    ASSERT_GT(views.points.size(), 200u);
    for (const ViewRow& row : views.rows) {
        double squares = 0.0;
        for (std::size_t i = 0; i < views.points.size(); ++i) {
            const double side = 0.005 * row.minification;
            const double across = side * glm::dot(k, views.axes[i].across);
            const double along =
                side / std::cos(row.tilt * radian) * glm::dot(k, views.axes[i].along);
            const double truth = std::cos(glm::dot(k, position(mesh, views.points[i]))) *
                                 sinc(0.5 * across) * sinc(0.5 * along);
            squares += std::pow(row.means[i].x - truth, 2) / double(views.points.size());
        }
        EXPECT_LT(std::sqrt(squares), 0.02) << row.minification << " " << row.tilt;
        EXPECT_LT(std::sqrt(squares), 1.5 * row.noise) << row.minification << " " << row.tilt;
    }
}

// What lines of sight meet of a sphere, by its equation: where a line misses it, it does not count.
TEST(SampledViews, PixelsOnASphereSeeWhatRaysMeet) {
    const Mesh mesh = made::ball(6);
    const SolidColor f = [](const Vec3d& p) { return 0.5 + 0.5 * p; };
    const ViewOptions options{.points = 60, .minifications = {6.0}, .tilts = {0.0, 50.0, 80.0}};
    const SampledViews views = sample_views(mesh, f, 0.02, options);
    for (const ViewRow& row : views.rows) {
        for (std::size_t i = 0; i < views.points.size(); ++i) {
            const FootprintAxes& axes = views.axes[i];
            const Vec3d centre = position(mesh, views.points[i]);
            const Vec3d towards =
                std::cos(row.tilt * radian) * face_normal(mesh, views.points[i].triangle) +
                std::sin(row.tilt * radian) * axes.along;
            const PixelSteps steps = views.steps(i, row);
            Vec3d sum(0.0);
            double met = 0.0;
            for (double a = -0.49; a < 0.5; a += 0.02)
                for (double b = -0.49; b < 0.5; b += 0.02) {
                    const Vec3d o = centre + a * steps.x + b * steps.y;
                    const double middle = glm::dot(o, towards);
                    const double rest = middle * middle - glm::dot(o, o) + 1.0;
                    const double t = std::sqrt(std::max(0.0, rest)) - middle;
                    if (rest < 0.0 || std::abs(t) > 2.0 * glm::length(steps.y)) continue;
                    sum += f(o + t * towards);
                    met += 1.0;
                }
            EXPECT_LT(glm::length(row.means[i] - sum / met), 0.03) << row.tilt << " " << i;
        }
    }
}

// A plate's other side and what stands in the way are not seen.
TEST(SampledViews, OnlyThePointsOwnSideCounts) {
    Mesh mesh = made::square();
    const auto n = std::uint32_t(mesh.positions.size());
    for (const double z : {-0.004, 0.5})
        for (std::uint32_t i = 0; i < n; ++i)
            mesh.positions.push_back(mesh.positions[i] + Vec3d(0.0, 0.0, z));
    const std::vector<Triangle> top = mesh.triangles;
    for (const auto& [a, b, c] : top) mesh.triangles.push_back({a + n, c + n, b + n});
    for (const auto& [a, b, c] : top) mesh.triangles.push_back({a + 2 * n, b + 2 * n, c + 2 * n});
    mesh = made::mesh_of(mesh.positions, mesh.triangles);
    const SolidColor f = grey([](const Vec3d& p) {
        return p.z > 0.4 ? 1.0 : p.z < -0.002 ? 0.5 : 0.0;
    });
    for (const ViewRow& row :
         sample_views(mesh, f, 0.003, {.points = 300, .minifications = {1.0, 4.0}}).rows) {
        for (std::size_t i = 0; i < row.means.size(); ++i)
            EXPECT_EQ(row.means[i].x, i < 100 ? 0.0 : i < 200 ? 0.5 : 1.0) << row.tilt << " " << i;
        EXPECT_EQ(row.noise, 0.0);
    }
}

TEST(SampledViews, AreTheSameOnAnyNumberOfThreads) {
    const Mesh mesh = made::ball(3);
    const SolidColor f = grey([](const Vec3d& p) { return std::sin(40.0 * p.x * p.y); });
    const ViewOptions options{.points = 100, .minifications = {4.0}};
    const SampledViews all = sample_views(mesh, f, 0.01, options);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const SampledViews alone = sample_views(mesh, f, 0.01, options);
    for (std::size_t r = 0; r < all.rows.size(); ++r)
        EXPECT_EQ(all.rows[r].means, alone.rows[r].means);
    EXPECT_TRUE(sample_views(mesh, f, 0.01, {.points = 0}).rows.empty());
}

/// All levels of a 256 x 256 image, level l of which is l everywhere.
MipChain<Vec3f> numbered_levels() {
    MipChain<Vec3f> chain;
    for (std::size_t side = 256; side > 0; side /= 2)
        chain.levels.emplace_back(side, side, Vec3f(float(chain.levels.size())));
    return chain;
}

TEST(Sampler, LevelsFollowTheLongerStep) {
    const MipChain<Vec3f> chain = numbered_levels();
    const auto level = [&](const TexelSteps& steps, int most) {
        return sampler_lookup(chain, {100.0, 90.0}, steps, most).x;
    };
    const TexelSteps five{{3.0, 4.0}, {0.0, 1.0}};  // lengths 5 and 1
    EXPECT_NEAR(level(five, 1), std::log2(5.0), 1e-6);
    EXPECT_NEAR(level(five, 2), std::log2(5.0 / 2.0), 1e-6);
    EXPECT_NEAR(level(five, 4), std::log2(5.0 / 4.0), 1e-6);
    EXPECT_NEAR(level(five, 16), 0.0, 1e-6);  // five probes
    EXPECT_NEAR(level({five.y, five.x}, 2), std::log2(5.0 / 2.0), 1e-6);
    EXPECT_NEAR(level({{12.0, 0.0}, {0.0, 4.5}}, 16), 2.0, 1e-6);  // three probes
    EXPECT_NEAR(level({{8.0, 0.0}, {0.0, 8.0}}, 16), 3.0, 1e-6);   // one
    EXPECT_EQ(level({{0.2, 0.0}, {0.0, 0.1}}, 1), 0.0);            // magnified
    EXPECT_EQ(level({{0.0, 0.0}, {0.0, 0.0}}, 16), 0.0);
    EXPECT_EQ(level({{900.0, 0.0}, {0.0, 0.0}}, 1), 8.0);
}

TEST(Sampler, ProbesLieEvenlyOnTheLongerStep) {
    Image<Vec3f> image(64, 64);
    for (std::size_t y = 0; y < 64; ++y)
        for (std::size_t x = 0; x < 64; ++x)
            image(x, y) = Vec3f(float((x * 37 + y * 91) % 64) / 64.0f);
    const MipChain<Vec3f> chain = build_mip_chain(image);
    const Vec2d at(30.3, 31.8), step(3.2, -2.4);  // four texels long
    Vec3d mean(0.0);
    for (const double share : {-0.3, -0.1, 0.1, 0.3})
        mean += 0.25 * bilinear(image, at + share * step);
    for (const TexelSteps& steps : {TexelSteps{step, {0.6, 0.8}}, TexelSteps{{0.6, 0.8}, step}})
        EXPECT_NEAR(sampler_lookup(chain, at, steps, 4).x, mean.x, 1e-12);
    EXPECT_EQ(sampler_lookup(chain, at, {step, {0.6, 0.8}}, 1), trilinear(chain, at, 2.0));
}

// Turning the screen round its centre leaves the ellipse as it is.
TEST(Sampler, EllipseHasTheSameAxesOnATurnedScreen) {
    const TexelSteps steps{{4.0, 1.0}, {3.5, 2.0}};
    for (double turn = 0.0; turn < 3.0; turn += 0.3) {
        const double c = std::cos(turn), s = std::sin(turn);
        const TexelSteps axes =
            ellipse_steps({c * steps.x + s * steps.y, c * steps.y - s * steps.x});
        EXPECT_NEAR(glm::dot(axes.x, axes.y), 0.0, 1e-9);
        EXPECT_NEAR(glm::length(axes.x) * glm::length(axes.y), 4.0 * 2.0 - 3.5, 1e-9);
        const double squares = glm::dot(steps.x, steps.x) + glm::dot(steps.y, steps.y);
        EXPECT_NEAR(glm::dot(axes.x, axes.x) + glm::dot(axes.y, axes.y), squares, 1e-9);
    }
    EXPECT_EQ(ellipse_steps({}).x, Vec2d(0.0));
}

/// The second moment of a lookup in level l, in texels of level 0 squared, at this coordinate:
/// means of 4^l texels that hold the function itself, interpolated between.
double moment(double coordinate, double level) {
    const double side = std::exp2(level), place = coordinate / side - 0.5;
    const double t = place - std::floor(place);
    return (side * side - 1.0) / 12.0 + side * side * t * (1.0 - t);
}

// On a plane mapped evenly all is known: a wave is damped by the second moments of texels,
// interpolation and probes, and by a pixel's, a twelfth of its sides squared.
TEST(SampledViews, ErrorsOnAnEvenPlaneAreThoseOfTheSamplers) {
    constexpr double size = 256.0, k = 40.0 / size;
    Mesh mesh = made::square();
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t p : t)
            mesh.corners.uvs.push_back({mesh.positions[p].y, mesh.positions[p].x});
    const Connectivity connectivity = made::neighbours_by_brute_force(mesh);
    const Atlas atlas = atlas_from_uvs(mesh, connectivity, std::uint32_t(size));
    const SolidColor f = grey([](const Vec3d& p) { return 0.5 + 0.5 * std::cos(k * size * p.x); });
    const MipChain<Vec3f> chain =
        build_mip_chain(fill_texture(rasterize_uvs(mesh, atlas, mesh.positions), f).values);
    const ViewOptions options{
        .points = 1500, .minifications = {1.0, 2.0}, .tilts = {0.0, 60.0}, .rays = 12};
    SampledViews views = inside(sample_views(mesh, f, 1.0 / size, options), mesh, 0.05);
    const std::vector<ViewError> errors = view_errors(mesh, atlas, chain, views);
    ASSERT_EQ(errors.size(), 4u);
    for (std::size_t r = 0; r < errors.size(); ++r) {
        const double side = errors[r].minification;
        const double length = side / std::cos(errors[r].tilt * radian);
        // Trilinear, 2x and 16x: at 60 degrees two probes, a sixth of the length from the middle.
        for (const std::size_t sampler : {0u, 1u, 4u}) {
            const bool two = sampler > 0 && errors[r].tilt > 0.0;
            const double level = std::round(std::log2(two ? side : length));
            double squares = 0.0;
            for (std::size_t i = 0; i < views.points.size(); ++i) {
                const double x = views.axes[i].across.x * side, y = views.axes[i].along.x * length;
                const double at = position(mesh, views.points[i]).x * size;
                const double own =
                    two ? 0.5 * (moment(at + y / 6.0, level) + moment(at - y / 6.0, level)) +
                              y * y / 36.0
                        : moment(at, level);
                const double spread = own - (x * x + y * y) / 12.0;
                squares += std::pow(0.25 * k * k * spread * std::cos(k * at), 2);
            }
            const double expected = std::sqrt(squares / double(views.points.size()));
            EXPECT_NEAR(errors[r].rmse[sampler] / expected, 1.0, 0.1)
                << errors[r].minification << " " << errors[r].tilt << " " << sampler;
        }
    }
    for (ViewRow& row : views.rows)
        for (Vec3d& mean : row.means) mean += 0.1;
    for (const ViewError& error : view_errors(mesh, atlas, chain, views))
        for (const double rmse : error.rmse) EXPECT_NEAR(rmse, 0.1, 0.01);
}

}  // namespace
}  // namespace burl
