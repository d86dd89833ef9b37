// Anisotropic lookups against closed forms: linear functions, waves, ellipses by brute force.
#include "atlas/measure/lookup.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "atlas/measure/lookup_errors.h"
#include "atlas/measure/uv_atlas.h"
#include "tests/atlas/support/kept_wave.h"
#include "tests/atlas/support/made_meshes.h"

namespace burl {
namespace {

constexpr std::size_t size = 512;

/// All levels of value(x, y), x and y in texels of level 0.
template <class Value>
MipChain<Vec3f> chain_of(Value value) {
    Image<Vec3f> image(size, size);
    for (std::size_t y = 0; y < size; ++y)
        for (std::size_t x = 0; x < size; ++x)
            image(x, y) = Vec3f(Vec3d(value(double(x) + 0.5, double(y) + 0.5)));
    return build_mip_chain(std::move(image));
}

TEST(Anisotropic, FootprintIsTheEllipseOfTheTwoAxes) {
    const std::array<std::array<Vec2d, 2>, 5> pairs{{{{{3.0, 1.0}, {-0.2, 0.7}}},
                                                     {{{1.0, 2.0}, {2.0, 1.0}}},
                                                     {{{0.0, 0.1}, {5.0, 0.0}}},
                                                     {{{1.0, 1.0}, {2.0, 2.0}}},
                                                     {{{-4.0, 1.0}, {0.3, -2.0}}}}};
    for (const auto& [a, b] : pairs) {
        double longest = 0.0, shortest = 1e9;
        Vec2d direction(0.0);
        for (int i = 0; i < 20000; ++i) {
            const double t = i * std::numbers::pi / 10000.0;
            const Vec2d p = a * std::cos(t) + b * std::sin(t);
            shortest = std::min(shortest, glm::length(p));
            if (glm::length(p) > longest) longest = glm::length(p), direction = p;
        }
        const TexelFootprint ellipse = texel_footprint(a, b);
        EXPECT_NEAR(glm::length(ellipse.major), longest, 1e-5);
        EXPECT_NEAR(ellipse.minor, shortest, 1e-3);
        EXPECT_NEAR(std::abs(glm::dot(ellipse.major, direction)), longest * longest, 1e-3);
    }
    EXPECT_EQ(texel_footprint(Vec2d(0.0), Vec2d(0.0)).minor, 0.0);
}

TEST(Anisotropic, MapsVectorsAsTheTriangleIsMapped) {
    Mesh mesh = made::mesh_of({{1, 0, 0}, {3, 0, 1}, {1, 2, 5}}, {{0, 1, 2}, {0, 0, 1}});
    Atlas atlas;
    atlas.corners = {{Vec2d(10, 20), Vec2d(14, 21), Vec2d(9, 30)}, {}};
    const auto& p = mesh.positions;
    const Vec2d u = mapped(mesh, atlas, 0, 0.3 * (p[1] - p[0]) - 2.0 * (p[2] - p[1]));
    EXPECT_NEAR(u.x, 0.3 * 4.0 + 2.0 * 5.0, 1e-12);
    EXPECT_NEAR(u.y, 0.3 * 1.0 - 2.0 * 9.0, 1e-12);
    EXPECT_EQ(mapped(mesh, atlas, 1, p[1]), Vec2d(0.0));  // a triangle without area
}

TEST(Anisotropic, TrilinearIsLinearBetweenLevels) {
    const auto chain = chain_of([](double x, double y) { return std::sin(x * y); });
    const Vec2d at(200.3, 117.9);
    const Vec3d one = trilinear(chain, at, 1.0), two = trilinear(chain, at, 2.0);
    EXPECT_NEAR(trilinear(chain, at, 1.25).x, 0.75 * one.x + 0.25 * two.x, 1e-12);
    EXPECT_EQ(trilinear(chain, at, -3.0), trilinear(chain, at, 0.0));
    EXPECT_EQ(trilinear(chain, at, 40.0), Vec3d(chain.levels.back()(0, 0)));
    // A round footprint of standard deviation 2^(l-1) is one lookup in level l.
    EXPECT_EQ(anisotropic(chain, at, {Vec2d(0.0, 2.0), 2.0}), trilinear(chain, at, 2.0));
}

TEST(Anisotropic, ALinearFunctionIsItself) {
    const auto chain = chain_of([](double x, double y) { return 0.001 * x - 0.0005 * y + 0.4; });
    for (const double ratio : {1.0, 1.2, 2.5, 5.0, 8.0, 30.0})
        for (const double angle : {0.0, 0.4, 1.9}) {
            const Vec2d at(256.3, 240.8);
            const Vec2d major = 1.3 * ratio * Vec2d(std::cos(angle), std::sin(angle));
            EXPECT_NEAR(anisotropic(chain, at, {major, 1.3}).x, 0.001 * at.x - 0.0005 * at.y + 0.4,
                        1e-6);
        }
}

// A wave along the footprint is damped as by the Gaussian itself, one across it hardly at all. The
// ellipse is turned with the waves, so that lookups lie anywhere between texels.
TEST(Anisotropic, DampsAWaveAsTheFootprintDoes) {
    const double angle = 0.7;
    const Vec2d along(std::cos(angle), std::sin(angle)), across(-along.y, along.x);
    for (const double minor : {1.0, 2.0})
        for (const double phases : {0.5, 1.0, 1.5}) {  // per standard deviation
            const double k = phases / (8.0 * minor);
            const auto chain = chain_of([&](double x, double y) {
                const Vec2d p(x, y);
                return Vec3d(std::cos(k * glm::dot(p, along)), std::cos(k * glm::dot(p, across)),
                             1.0);
            });
            for (const Vec2d at : {Vec2d(250.0, 260.0), Vec2d(263.4, 231.9)}) {
                const Vec3d seen = anisotropic(chain, at, {8.0 * minor * along, minor});
                EXPECT_NEAR(seen.x,
                            made::kept_by_gaussian(phases, gaussian_cut) *
                                std::cos(k * glm::dot(at, along)),
                            0.012)
                    << minor << " " << phases;
                EXPECT_NEAR(seen.y,
                            made::kept_by_gaussian(phases / 8.0, gaussian_cut) *
                                std::cos(k * glm::dot(at, across)),
                            0.012);
                EXPECT_NEAR(seen.z, 1.0, 1e-6);
            }
        }
}

// Eight probes reach no further than eight times the width of a level's texel: longer footprints
// are looked up in coarser levels.
TEST(Anisotropic, LongerFootprintsAreWidened) {
    const auto chain = chain_of([](double x, double y) { return std::sin(0.1 * x + 0.07 * y); });
    const Vec2d at(256.3, 240.8), major(30.0, 14.0);
    EXPECT_EQ(anisotropic(chain, at, {major, 0.1}),
              anisotropic(chain, at, {major, glm::length(major) / 8.0}));
}

// The whole measure: on a plane mapped evenly the truth by closed form is met, and an offset of the
// truth is the error.
TEST(LookupErrors, GrazingLookupsOnAPlaneMeetTheClosedForm) {
    Mesh mesh = made::square();
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t p : t)
            mesh.corners.uvs.push_back({mesh.positions[p].y, mesh.positions[p].x});
    const Connectivity connectivity = made::neighbours_by_brute_force(mesh);
    const Atlas atlas = atlas_from_uvs(mesh, connectivity, size);
    const auto edges = mesh_edges(mesh, connectivity);
    const double sigma = 1.0 / double(size), k = 0.8 / (8.0 * sigma);
    const SolidColor f = grey([k](const Vec3d& p) { return std::cos(k * p.x); });
    const TextureValues values = fill_texture(rasterize_uvs(mesh, atlas, mesh.positions), f);
    SurfaceTruth truth;
    truth.texel = 1.0 / double(size);
    truth.levels.resize(1);
    truth.grazing.levels.resize(1);
    for (const SurfacePoint& point : area_uniform_points(mesh, 300, 1)) {
        const Vec3d at = position(mesh, point);
        if (std::min({at.x, at.y, 1.0 - at.x, 1.0 - at.y}) < 0.06) continue;
        const double angle = 12.9898 * double(truth.level_points.size());
        const Vec3d along(std::cos(angle), std::sin(angle), 0.0);
        const double across = std::hypot(along.x, along.y / 8.0);  // phases per deviation
        truth.level_points.push_back(point);
        truth.grazing.points.push_back(point);
        truth.grazing.axes.push_back({along, Vec3d(-along.y, along.x, 0.0)});
        truth.levels[0].means.push_back(f(at));
        truth.grazing.levels[0].means.push_back(made::kept_by_gaussian(0.8 * across, gaussian_cut) *
                                                f(at));
    }
    const StoredValue exact = [](double value) { return value; };
    const auto measured = measure_lookups(mesh, atlas, values, edges, truth, exact);
    ASSERT_TRUE(measured.levels[1].grazing);
    EXPECT_FALSE(measured.levels[0].grazing);
    EXPECT_LT(measured.levels[1].grazing->rmse, 0.006);
    for (Vec3d& mean : truth.grazing.levels[0].means) mean += 0.1;
    const auto off = measure_lookups(mesh, atlas, values, edges, truth, exact);
    EXPECT_NEAR(off.levels[1].grazing->rmse, 0.1, 0.002);
    EXPECT_NEAR(off.levels[1].grazing->rmse_8bit, 0.1, 0.002);
}

}  // namespace
}  // namespace burl
