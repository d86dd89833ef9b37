// Lookup errors against textures whose errors are known.
#include "atlas/measure/lookup_errors.h"

#include <gtest/gtest.h>

#include <cmath>

#include <tbb/global_control.h>

#include "atlas/measure/lookup.h"
#include "atlas/measure/seams.h"
#include "atlas/measure/uv_atlas.h"
#include "tests/atlas/support/made_meshes.h"

namespace burl {
namespace {

TruthOptions few(std::uint32_t size) {
    TruthOptions options;
    options.size = size;
    options.points = 5000;
    options.level_points = 1000;
    options.grazing_points = 500;
    options.levels = 4;
    return options;
}

/// Rounds linear values to 1/255.
double to_255(double value) {
    return std::round(value * 255.0) / 255.0;
}

using Function = std::function<double(const Vec3d&)>;

/// The unit square mapped by place(point), with everything measured at 64 x 64 texels.
struct Square {
    Mesh mesh = made::square();
    Atlas atlas;
    std::vector<MeshEdge> edges;
    TextureValues texture;
    LookupErrors errors;

    template <class Place>
    Square(const Function& value, Place place, GapFill fill = GapFill::nearest) {
        const SolidColor f = grey(value);
        for (std::size_t t = 0; t < 2; ++t)
            for (const std::uint32_t p : mesh.triangles[t])
                mesh.corners.uvs.push_back(place(t, mesh.positions[p]));
        const Connectivity connectivity = made::neighbours_by_brute_force(mesh);
        edges = mesh_edges(mesh, connectivity);
        atlas = atlas_from_uvs(mesh, connectivity, 64);
        texture = fill_texture(rasterize_uvs(mesh, atlas, mesh.positions), f, fill);
        errors = measured(texture, surface_truth(mesh, f, few(64)));
    }

    LookupErrors measured(const TextureValues& values, const SurfaceTruth& truth,
                          const StoredValue& in_8bit = to_255, bool sharp = false) const {
        return measure_lookups(mesh, atlas, values, edges, truth, in_8bit, sharp);
    }
};

Vec2d whole(std::size_t, const Vec3d& p) {
    return {p.x, p.y};
}
/// The second triangle moved off by a quarter; both at half size.
Vec2d apart(std::size_t t, const Vec3d& p) {
    return Vec2d(0.05 + 0.5 * p.x + (t == 0 ? 0.25 : 0.0), 0.05 + 0.5 * p.y);
}

double linear(const Vec3d& p) {
    return 0.3 + 0.4 * p.x - 0.2 * p.y;
}

TEST(Bilinear, InterpolatesAndClamps) {
    Image<Vec3f> image(3, 2);
    for (std::size_t y = 0; y < 2; ++y)
        for (std::size_t x = 0; x < 3; ++x)
            image(x, y) = Vec3f(float(x) + 10.0f * float(y), 1.0f, -float(x));
    EXPECT_EQ(bilinear(image, {1.5, 0.5}), Vec3d(1.0, 1.0, -1.0));
    EXPECT_DOUBLE_EQ(bilinear(image, {1.25, 0.75}).x, 0.75 + 2.5);
    EXPECT_DOUBLE_EQ(bilinear(image, {1.25, 0.75}).z, -0.75);
    EXPECT_EQ(bilinear(image, {-5.0, 9.0}).x, 10.0);
    EXPECT_EQ(bilinear(image, {3.0, 0.0}).x, 2.0);
}

// Bilinear lookup reproduces a linear function, but for float's rounding and the half texel of
// clamped border.
TEST(LookupErrors, LinearFunctionOnAPlane) {
    const Square inset(linear, [](std::size_t, const Vec3d& p) {
        return Vec2d(0.25, 0.25) + Vec2d(p.x, p.y) * (31.0 / 64) + 0.5 / 64;  // on texel centres
    });
    EXPECT_GT(inset.errors.psnr, 140.0);
    EXPECT_GT(inset.errors.psnr_8bit, 58.0);  // 1/(255 sqrt 12) is 58.9 dB
    EXPECT_LT(inset.errors.psnr_8bit, 66.0);
    EXPECT_EQ(inset.errors.levels[0].mismatch, 0.0);
    EXPECT_NEAR(inset.errors.levels[0].foreign, 0.0, 1e-12);
    const Square all(linear, whole);
    EXPECT_LT(all.errors.interior_rmse, 1e-6);  // only the border's half texel is wrong
    EXPECT_GT(all.errors.seam_rmse, 1e-4);
    EXPECT_NEAR(all.errors.seam_points, 1.0 - std::pow(62.0 / 64, 2), 0.01);
    for (const LevelError& level : all.errors.levels) EXPECT_EQ(level.foreign, 0.0);
}

// f - c on one side of a seam, f + c on the other: lookups on the seam differ by 2c.
TEST(LookupErrors, MismatchAcrossASeamIsItsOffset) {
    const double offset = 0.05;
    Square square(linear, apart);
    for (std::size_t y = 0; y < 64; ++y)
        for (std::size_t x = 0; x < 64; ++x)
            square.texture.values(x, y) = Vec3f(square.texture.shown(x, y) == 0 ? 0.5f : 0.6f);
    const SeamPoints points = seam_points(square.mesh, square.atlas, square.edges, 1000, 1);
    EXPECT_EQ(points.places.size(), 1000u);
    EXPECT_EQ(points.share, 1.0);
    EXPECT_NEAR(mismatch(points, square.texture.values, 64), 2.0 * offset, 0.01);
    // Half of a texture shifted: the RMS error is the shift.
    const SolidColor middle = grey([](const Vec3d&) { return 0.55; });
    const LookupErrors errors =
        square.measured(square.texture, surface_truth(square.mesh, middle, few(64)));
    EXPECT_NEAR(errors.levels[0].rmse, offset, 0.002);
    EXPECT_NEAR(errors.psnr, -20.0 * std::log10(offset), 0.3);
}

// Long waves, straight on, two and four texels to the pixel: what a trilinear lookup blurs more
// than the pixel does is 1/6 of a texel's square along each axis, and 2 s of it are taken back.
TEST(LookupErrors, SharpLevelsErrLessInViews) {
    const Function wave = [](const Vec3d& p) { return 0.5 + 0.3 * std::sin(9.0 * p.x); };
    const Square square(wave, whole);
    const SurfaceTruth truth = surface_truth(square.mesh, grey(wave), few(64));
    const LookupErrors means = square.measured(square.texture, truth),
                       sharp = square.measured(square.texture, truth, to_255, true);
    EXPECT_EQ(sharp.levels[0].rmse, means.levels[0].rmse);
    EXPECT_TRUE(sharp.sharp && !means.sharp);
    ASSERT_EQ(means.views.size(), sharp.views.size());
    for (std::size_t r = 0; r < means.views.size(); ++r) {
        const ViewError &before = means.views[r], &now = sharp.views[r];
        EXPECT_LE(now.rmse[0], 1.001 * before.rmse[0]) << r;
        const bool near = before.minification == 2.0 || before.minification == 4.0;
        if (before.tilt > 0.0 || !near) continue;
        EXPECT_NEAR(now.rmse[0] / before.rmse[0], 0.7, 0.1) << r;
    }
}

TEST(LookupErrors, JoinedEdgesHaveNoMismatch) {
    const Square square([](const Vec3d& p) { return std::sin(50.0 * p.x); }, whole);
    for (const LevelError& level : square.errors.levels) EXPECT_EQ(level.mismatch, 0.0);
}

TEST(TextureValues, CopyTheNearestOwnedTexel) {
    const Square square(linear, apart);
    const auto& owner = square.texture.owner;
    const auto distance = [](std::size_t a, std::size_t b) { return double(a) - double(b); };
    for (std::size_t y = 0; y < 64; y += 3)
        for (std::size_t x = 0; x < 64; x += 3) {
            double nearest = 1e9;
            for (std::size_t j = 0; j < 64; ++j)
                for (std::size_t i = 0; i < 64; ++i)
                    if (owner(i, j) != no_triangle)
                        nearest = std::min(nearest, std::hypot(distance(i, x), distance(j, y)));
            bool found = false;  // its value is that of some texel exactly as near
            for (std::size_t j = 0; j < 64 && !found; ++j)
                for (std::size_t i = 0; i < 64 && !found; ++i)
                    found = owner(i, j) != no_triangle &&
                            owner(i, j) == square.texture.shown(x, y) &&
                            std::hypot(distance(i, x), distance(j, y)) == nearest &&
                            square.texture.values(i, j) == square.texture.values(x, y);
            EXPECT_TRUE(found) << x << " " << y;
        }
}

// The surface of the nearest triangle goes on for two texels; further out nothing changes.
TEST(TextureValues, ContinueTheSurfaceOrLeaveItBlack) {
    const Square square(linear, apart, GapFill::extrapolate), black(linear, apart, GapFill::black);
    const auto& owner = square.texture.owner;
    for (std::size_t y = 0; y < 64; ++y)
        for (std::size_t x = 0; x < 64; ++x) {
            const std::uint32_t shown = square.texture.shown(x, y);
            ASSERT_NE(shown, no_triangle);
            if (owner(x, y) != no_triangle) continue;
            EXPECT_EQ(black.texture.values(x, y), Vec3f(0.0f));
            EXPECT_EQ(black.texture.shown(x, y), no_triangle);
            bool near = false;
            for (std::size_t j = std::max<std::size_t>(y, 1) - 1; j <= std::min(y + 1, 63ul); ++j)
                for (std::size_t i = std::max<std::size_t>(x, 1) - 1; i <= std::min(x + 1, 63ul);
                     ++i)
                    near = near || owner(i, j) == shown;
            const Vec2d uv = (Vec2d(double(x), double(y)) + 0.5) / 64.0 -
                             Vec2d(0.05 + (shown == 0 ? 0.25 : 0.0), 0.05);
            const double expected = linear(Vec3d(2.0 * uv, 0.0));
            if (near) {
                EXPECT_NEAR(square.texture.values(x, y).x, expected, 1e-6) << x << " " << y;
            }
            EXPECT_LT(square.texture.values(x, y).x, 0.75f);  // f is 0.1 to 0.7 on the square
            EXPECT_GT(square.texture.values(x, y).x, 0.05f);
        }
}

// Half of a texel's surroundings belongs to nobody: a black one shows.
TEST(LookupErrors, BlackGapsShowAtSeams) {
    const Square filled(linear, apart, GapFill::extrapolate), black(linear, apart, GapFill::black);
    EXPECT_LT(filled.errors.levels[0].rmse, 1e-6);  // a linear function goes on exactly
    EXPECT_GT(black.errors.levels[0].rmse, 0.01);
    EXPECT_GT(black.errors.seam_rmse, 100.0 * black.errors.interior_rmse);
}

// Each level is made of what the level before was stored as.
TEST(LookupErrors, RoundedLevelsFollowTheRoundedTexture) {
    const Square square([](const Vec3d&) { return 0.4; }, whole);
    const SurfaceTruth truth =
        surface_truth(square.mesh, grey([](const Vec3d&) { return 0.4; }), few(64));
    const LookupErrors coarse =
        square.measured(square.texture, truth, [](double v) { return v < 0.5 ? 0.0 : 1.0; });
    const LookupErrors add =
        square.measured(square.texture, truth, [](double v) { return v + 0.01; });
    for (std::size_t l = 0; l < coarse.levels.size(); ++l) {
        EXPECT_LT(coarse.levels[l].rmse, 1e-6);
        EXPECT_NEAR(coarse.levels[l].rmse_8bit, 0.4, 1e-6);
        EXPECT_NEAR(add.levels[l].rmse_8bit, 0.01 * double(l + 1), 1e-6);
    }
    EXPECT_NEAR(coarse.psnr_8bit, -20.0 * std::log10(0.4), 1e-3);
    EXPECT_NEAR(coarse.levels[1].grazing->rmse_8bit, 0.4, 1e-6);
}

// An error in one of three channels counts for a third of its square.
TEST(LookupErrors, OfColoursAreMeansOverTheChannels) {
    Square square([](const Vec3d&) { return 0.5; }, whole);
    for (std::size_t y = 0; y < 64; ++y)
        for (std::size_t x = 0; x < 64; ++x) square.texture.values(x, y).y += 0.3f;
    const SurfaceTruth truth =
        surface_truth(square.mesh, grey([](const Vec3d&) { return 0.5; }), few(64));
    const LookupErrors errors = square.measured(square.texture, truth);
    for (const LevelError& level : errors.levels)
        EXPECT_NEAR(level.rmse, 0.3 / std::sqrt(3.0), 1e-6);
    EXPECT_NEAR(errors.levels[1].grazing->rmse, 0.3 / std::sqrt(3.0), 1e-6);
}

TEST(ForeignShare, IsTheWeightOnOtherTexels) {
    const Square square(linear, apart);
    const std::vector<std::uint32_t> charts{0, 1};
    // A point in the middle of triangle 0, by brute force over the texels under the lookup.
    const std::vector<SurfacePoint> points{{0, {0.3, 0.3, 0.4}}};
    for (std::uint32_t l = 0; l <= 6; ++l) {
        const std::size_t count = 64u >> l;
        const Vec2d at = place(square.atlas, points[0]) / double(1u << l);
        double own = 0.0, weights = 0.0;
        for (std::size_t y = 0; y < 64; ++y)
            for (std::size_t x = 0; x < 64; ++x) {
                const auto tent = [&](double c, std::size_t i) {
                    const double held = std::clamp(c, 0.5, double(count) - 0.5);
                    return std::max(0.0, 1.0 - std::abs(held - double(i >> l) - 0.5));
                };
                const double w = tent(at.x, x) * tent(at.y, y) / std::ldexp(1.0, int(2 * l));
                weights += w;
                if (square.texture.owner(x, y) == 0) own += w;
            }
        ASSERT_NEAR(weights, 1.0, 1e-12);
        EXPECT_NEAR(foreign_share(square.atlas, square.texture, charts, points, l).foreign,
                    1.0 - own, 1e-12);
    }
    const ForeignShare last = foreign_share(square.atlas, square.texture, charts, points, 6);
    EXPECT_GT(last.foreign, 0.8);       // triangle 0 is an eighth of the texture
    EXPECT_LT(last.other_chart, 0.65);  // and shown by about half of it
}

TEST(ChartBorders, WithinOneTexel) {
    const Square square(linear, [](std::size_t, const Vec3d& p) {
        return Vec2d(0.25, 0.25) + 0.5 * Vec2d(p.x, p.y);  // texels 16 to 48
    });
    const ChartBorders borders(square.atlas, square.edges);
    for (double x = 0.0; x < 64.0; x += 0.37)
        for (double y = 0.0; y < 64.0; y += 0.41) {
            const Vec2d outside = glm::max(Vec2d(0.0), glm::abs(Vec2d(x, y) - 32.0) - 16.0);
            const double inside = std::min(16.0 - std::abs(x - 32.0), 16.0 - std::abs(y - 32.0));
            const double distance = inside >= 0.0 ? inside : glm::length(outside);
            EXPECT_EQ(borders.near({x, y}), distance <= 1.0) << x << " " << y;
        }
}

// Levels of a linear function over a joined map: the plain lookup is right away from the border.
TEST(LookupErrors, LevelsOfALinearFunctionErrOnlyAtTheBorder) {
    const Square square(linear, whole);
    for (const LevelError& level : square.errors.levels) EXPECT_LT(level.rmse, 0.03);
    // Lookups at the border are clamped to half a texel inside, 4 levels up 8 of 64 texels.
    EXPECT_GT(square.errors.levels[4].rmse, square.errors.levels[1].rmse);
}

TEST(LookupErrors, AreTheSameForEveryThreadCount) {
    const auto measured = [](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return Square([](const Vec3d& p) { return std::sin(20.0 * p.x) * p.y; }, apart).errors;
    };
    const LookupErrors one = measured(1), many = measured(4);
    EXPECT_EQ(one.psnr, many.psnr);
    EXPECT_EQ(one.seam_rmse, many.seam_rmse);
    for (std::size_t l = 0; l < one.levels.size(); ++l) {
        EXPECT_EQ(one.levels[l].rmse, many.levels[l].rmse);
        EXPECT_EQ(one.levels[l].rmse_8bit, many.levels[l].rmse_8bit);
        ASSERT_EQ(one.levels[l].grazing.has_value(), many.levels[l].grazing.has_value());
        if (one.levels[l].grazing) {
            EXPECT_EQ(one.levels[l].grazing->rmse, many.levels[l].grazing->rmse);
            EXPECT_EQ(one.levels[l].grazing->truth_noise, many.levels[l].grazing->truth_noise);
        }
        EXPECT_EQ(one.levels[l].truth_noise, many.levels[l].truth_noise);
        EXPECT_EQ(one.levels[l].foreign, many.levels[l].foreign);
    }
}

}  // namespace
}  // namespace burl
