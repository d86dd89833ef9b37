// The atlas of a mesh's own texture coordinates, against searches of all triangles for each texel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <tbb/task_arena.h>

#include "atlas/base/error.h"
#include "atlas/build/mesh_atlas.h"
#include "atlas/uv/layout.h"
#include "atlas/uv/raster.h"
#include "tests/atlas/support/made_patches.h"

namespace burl {
namespace {

/// The mesh with place(point) as texture coordinates, the same from all sides.
template <class Place>
Mesh uv_mesh(Mesh mesh, Place place) {
    mesh.corners.uvs.clear();
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t p : t) mesh.corners.uvs.push_back(place(mesh.positions[p]));
    return mesh;
}

/// Triangles that share no points, with places in a texture of `size` texels; point k of triangle t
/// lies at (its place, t).
Mesh uv_soup(const std::vector<std::array<Vec2d, 3>>& places, double size) {
    std::vector<Vec3d> points;
    std::vector<Triangle> triangles;
    std::vector<Vec2d> uvs;
    for (std::uint32_t t = 0; t < places.size(); ++t) {
        triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
        for (const Vec2d& at : places[t]) {
            points.emplace_back(at.x, at.y, double(t));
            uvs.push_back(at / size);
        }
    }
    Mesh mesh = made::mesh_of(points, triangles);
    mesh.corners.uvs = uvs;
    return mesh;
}

AtlasOptions uv_options(std::uint32_t size, UvOverlap overlap = UvOverlap::refuse) {
    AtlasOptions options;
    options.kind = AtlasKind::uv;
    options.size = size;
    options.overlap = overlap;
    return options;
}

struct UvShown {
    Atlas atlas;
    SolidAtlas solid;
    Image<std::uint32_t> triangles;
    Image<Vec3d> points;
};

UvShown shown_uvs(const Mesh& mesh, const AtlasOptions& options) {
    UvShown all{layout_uvs(mesh, made::neighbours_by_brute_force(mesh), options), {}, {}, {}};
    all.solid = rasterize_uv_charts(mesh, all.atlas, mesh.positions);
    const std::size_t size = options.size;
    all.triangles = Image<std::uint32_t>(size, size, std::numeric_limits<std::uint32_t>::max());
    all.points = Image<Vec3d>(size, size, Vec3d(NAN));
    for (std::size_t y = 0; y < size; ++y)
        for (const Span& span : all.solid.row(y))
            for (std::size_t x = span.x; x < span.x + span.count; ++x) {
                EXPECT_TRUE(std::isnan(all.points(x, y).x)) << "two spans at " << x << ", " << y;
                all.triangles(x, y) = all.solid.triangle_of(span.map);
                all.points(x, y) = all.solid.maps[span.map](std::int64_t(x), std::int64_t(y));
            }
    return all;
}

std::string refusal(const Mesh& mesh, const AtlasOptions& options) {
    try {
        layout_uvs(mesh, made::neighbours_by_brute_force(mesh), options);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

double twice_area(const std::array<Vec2d, 3>& c) {
    return cross(c[1] - c[0], c[2] - c[0]);
}

/// Whether the place lies in or on the triangle.
bool holds(const std::array<Vec2d, 3>& c, const Vec2d& at) {
    const double sign = twice_area(c) < 0.0 ? -1.0 : 1.0;
    for (std::size_t k = 0; k < 3; ++k)
        if (sign * cross(c[(k + 1) % 3] - c[k], at - c[k]) < 0.0) return false;
    return true;
}

TEST(UvAtlas, APlaneGoesOnForATexelThenStandsAndIsTheBorderFarAway) {
    // The square is [0, 1]^2, its chart texels 10 to 35 both ways.
    const Mesh mesh = uv_mesh(
        made::square(), [](const Vec3d& p) { return Vec2d(0.2 + 0.5 * p.x, 0.2 + 0.5 * p.y); });
    const UvShown all = shown_uvs(mesh, uv_options(50));
    for (std::size_t y = 0; y < 50; ++y)
        for (std::size_t x = 0; x < 50; ++x) {
            const Vec2d at(double(x) + 0.5, double(y) + 0.5);
            const Vec2d border = glm::clamp(at, Vec2d(10.0), Vec2d(35.0));
            const Vec2d shown(10.0 + 25.0 * all.points(x, y).x, 10.0 + 25.0 * all.points(x, y).y);
            const double away = glm::length(at - border);
            if (away <= 1.0) {
                EXPECT_LT(glm::length(shown - at), 1e-9) << x << ", " << y;
            } else if (at.x == border.x || at.y == border.y) {
                const Vec2d way = away <= 1.5 ? (at - border) / away : Vec2d(0.0);
                EXPECT_LT(glm::length(shown - border - way), 1e-9) << x << ", " << y;
            } else {
                EXPECT_NEAR(glm::length(shown - border), away <= 1.5 ? 1.0 : 0.0, 1e-9);
            }
        }
    EXPECT_EQ(all.atlas.chart_count, 1u);
    EXPECT_EQ(all.atlas.notes.overlapped_texels, 0u);
}

TEST(UvAtlas, CornersAreTheCoordinatesTimesTheSize) {
    const Mesh mesh = uv_mesh(
        made::grid(4, 3), [](const Vec3d& p) { return Vec2d(0.1 + 0.7 * p.x, 0.9 - 0.8 * p.y); });
    const Atlas atlas = shown_uvs(mesh, uv_options(64)).atlas;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(atlas.corners[t][k], mesh.corners.uvs[3 * t + k] * 64.0);
}

/// The place of a triangle nearest to `at`, by steps along its edges.
Vec2d nearest_place(const std::array<Vec2d, 3>& c, const Vec2d& at) {
    if (holds(c, at)) return at;
    Vec2d best = c[0];
    for (std::size_t k = 0; k < 3; ++k)
        for (int i = 0; i <= 400; ++i) {
            const Vec2d place = glm::mix(c[k], c[(k + 1) % 3], i / 400.0);
            if (glm::length(place - at) < glm::length(best - at)) best = place;
        }
    return best;
}

TEST(UvAtlas, TexelsShowTheFirstTriangleThatHoldsTheirCentreElseTheNearest) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> anywhere(0.0, 40.0), side(-9.0, 9.0);
    std::vector<std::array<Vec2d, 3>> places;
    while (places.size() < 14) {
        const Vec2d a(anywhere(random), anywhere(random));
        const std::array<Vec2d, 3> c{a, a + Vec2d(side(random), side(random)),
                                     a + Vec2d(side(random), side(random))};
        const bool within = std::ranges::all_of(c, [](const Vec2d& p) {
            return p.x >= 0.0 && p.y >= 0.0 && p.x <= 40.0 && p.y <= 40.0;
        });
        if (within && std::abs(twice_area(c)) > 30.0) places.push_back(c);
    }
    const UvShown all = shown_uvs(uv_soup(places, 40.0), uv_options(40, UvOverlap::first));
    int exact = 0;
    for (std::size_t y = 0; y < 40; ++y)
        for (std::size_t x = 0; x < 40; ++x) {
            const Vec2d at(double(x) + 0.5, double(y) + 0.5), shown(all.points(x, y));
            std::vector<double> away;
            for (const auto& c : places) away.push_back(glm::length(nearest_place(c, at) - at));
            const auto least = std::ranges::min_element(away);
            const std::uint32_t t = all.triangles(x, y);
            if (*least == 0.0) {
                EXPECT_EQ(t, std::size_t(least - away.begin())) << x << ", " << y;
            }
            EXPECT_NEAR(away[t], *least, *least < exact_reach ? 1e-2 : 1.0) << x << ", " << y;
            const Vec2d border = nearest_place(places[t], at);
            EXPECT_LT(glm::length(shown - border), 1.0 + 5e-2) << x << ", " << y;
            if (*least < 1.0) {  // all of these triangles are higher than that
                EXPECT_LT(glm::length(shown - at), 1e-9) << x << ", " << y;
                ++exact;
            }
        }
    EXPECT_GT(exact, 300);
}

TEST(UvAtlas, ChartsWithoutATexelsCentreShowThemselves) {
    // Beside a large triangle: one within a texel, and one thinner than a texel along a row.
    const std::vector<std::array<Vec2d, 3>> places{
        {Vec2d(2, 2), Vec2d(14, 2), Vec2d(2, 14)},
        {Vec2d(20.7, 5.6), Vec2d(20.9, 5.7), Vec2d(20.8, 5.9)},
        {Vec2d(18.2, 20.7), Vec2d(27.9, 20.8), Vec2d(27.9, 20.9)}};
    const UvShown all = shown_uvs(uv_soup(places, 32.0), uv_options(32));
    EXPECT_EQ(all.triangles(20, 5), 1u);
    EXPECT_LT(glm::length(Vec2d(all.points(20, 5)) - Vec2d(20.7, 5.6)), 0.25);
    for (std::size_t x = 18; x < 28; ++x) {
        EXPECT_EQ(all.triangles(x, 20), 2u) << x;
        EXPECT_NEAR(all.points(x, 20).x, std::max(double(x) + 0.5, 18.2), 0.02);
        EXPECT_NEAR(all.points(x, 20).y, 20.75, 0.2);
    }
}

TEST(UvAtlas, OverlapsAreCountedAndRefusedUnlessAllowed) {
    // Two squares of 8 x 8 texels: 4 x 5 centres are inside of both, one of them in the first
    // triangle.
    const auto square = [](double x, double y) {
        return std::array{std::array{Vec2d(x, y), Vec2d(x + 8, y), Vec2d(x, y + 8)},
                          std::array{Vec2d(x + 8, y + 8), Vec2d(x, y + 8), Vec2d(x + 8, y)}};
    };
    const auto a = square(2.25, 2), b = square(6.25, 5);
    const Mesh mesh = uv_soup({a[0], a[1], b[0], b[1]}, 16.0);
    EXPECT_EQ(
        refusal(mesh, uv_options(16)),
        "made: 3 triangles share 20 texels with others, so that only one of them can be right "
        "there; --uv-overlap first shows the first (for mirrored or stacked charts), --atlas "
        "chart gives each its own texels");
    const UvShown all = shown_uvs(mesh, uv_options(16, UvOverlap::first));
    EXPECT_EQ(all.atlas.notes.overlapped_texels, 20u);
    EXPECT_LT(all.triangles(7, 7), 2u);
    EXPECT_GE(all.triangles(12, 11), 2u);
}

TEST(UvAtlas, NeighboursInATextureShareNothing) {
    const Mesh mesh =
        uv_mesh(made::grid(7, 7), [](const Vec3d& p) { return Vec2d(p.x, p.y * 0.999); });
    for (const std::uint32_t size : {14u, 21u, 32u, 100u})
        EXPECT_EQ(refusal(mesh, uv_options(size)), "") << size;
}

TEST(UvAtlas, MirroredHalvesOnTopOfOneAnotherAreOneOverlap) {
    Mesh mesh = uv_mesh(made::grid(2, 1), [](const Vec3d& p) {
        return Vec2d(0.1 + 0.8 * (1.0 - std::abs(2.0 * p.x - 1.0)), 0.1 + 0.8 * p.y);
    });
    EXPECT_NE(refusal(mesh, uv_options(64)).find("4 triangles share"), std::string::npos);
    const UvShown all = shown_uvs(mesh, uv_options(64, UvOverlap::first));
    // The mirrored half joins the first one in its coordinates, and shows its texels.
    EXPECT_EQ(all.atlas.chart_count, 1u);
    for (std::size_t y = 10; y < 30; ++y)
        for (std::size_t x = 10; x < 50; ++x) EXPECT_LT(all.points(x, y).x, 0.5);
}

TEST(UvAtlas, CoordinatesOutsideOfTheSquareAreRefusedWithTheirTiles) {
    const auto moved = [](double u, double v) {
        return uv_mesh(made::square(), [=](const Vec3d& p) {
            return Vec2d(0.1 + 0.8 * p.x + u, 0.1 + 0.8 * p.y - v);
        });
    };
    EXPECT_EQ(refusal(moved(0, 0), uv_options(16)), "");
    EXPECT_NE(refusal(moved(1, 0), uv_options(16)).find("1 UDIM tile (1002)"), std::string::npos);
    EXPECT_NE(refusal(moved(2, 3), uv_options(16)).find("(1033)"), std::string::npos);
    EXPECT_NE(refusal(moved(0.5, 0), uv_options(16)).find("in no single tile"), std::string::npos);
    EXPECT_NE(refusal(moved(-1, 0), uv_options(16)).find("in no single tile"), std::string::npos);
    AtlasOptions tile = uv_options(16);
    tile.tile = 1033;
    const UvShown there = shown_uvs(moved(2, 3), tile),
                  here = shown_uvs(moved(0, 0), uv_options(16));
    for (std::size_t y = 0; y < 16; ++y)
        for (std::size_t x = 0; x < 16; ++x)
            EXPECT_NEAR(glm::length(there.points(x, y) - here.points(x, y)), 0.0, 1e-12);
    tile.tile = 1001;
    EXPECT_TRUE(shown_uvs(moved(2, 3), tile).solid.spans.empty());
}

TEST(UvAtlas, MissingAndUselessCoordinatesAreNamed) {
    EXPECT_NE(refusal(made::square(), uv_options(16)).find("has no texture coordinates"),
              std::string::npos);
    const Mesh flat = uv_mesh(made::square(), [](const Vec3d& p) { return Vec2d(p.x, p.x); });
    EXPECT_NE(refusal(flat, uv_options(16)).find("none of its triangles has an area"),
              std::string::npos);
    Mesh wild = uv_mesh(made::square(), [](const Vec3d& p) { return Vec2d(p.x, p.y); });
    wild.corners.uvs[0] = Vec2d(NAN, 0.0);
    const UvShown all = shown_uvs(wild, uv_options(16));
    EXPECT_EQ(all.atlas.notes.flat_triangles, 1u);
    for (const std::uint32_t t : all.triangles.pixels()) EXPECT_EQ(t, 1u);
}

TEST(UvAtlas, TrianglesTooSmallForNumbersAreFlat) {
    Mesh mesh = uv_mesh(made::square(), [](const Vec3d& p) { return Vec2d(p.x, p.y); });
    const auto shrink_first = [&](double scale) {
        for (std::size_t k = 0; k < 3; ++k) mesh.corners.uvs[k] *= scale;
        return shown_uvs(mesh, uv_options(16));
    };
    EXPECT_EQ(shrink_first(1e-9).atlas.notes.flat_triangles, 0u);
    const UvShown tiny = shrink_first(1e-150);
    EXPECT_EQ(tiny.atlas.notes.flat_triangles, 1u);
    for (const Vec3d& point : tiny.points.pixels()) EXPECT_TRUE(std::isfinite(glm::length(point)));
}

TEST(UvAtlas, TexelsBesideAChartShowTheSurfaceOnTheOtherSideOfItsBorder) {
    // Two halves of a ball, each seen from the other pole: the lower one is mirrored.
    Mesh mesh = made::ball(4);
    for (const Triangle& t : mesh.triangles) {
        double z = 0.0;
        for (const std::uint32_t p : t) z += mesh.positions[p].z;
        for (const std::uint32_t p : t) {
            const Vec3d& at = mesh.positions[p];
            mesh.corners.uvs.push_back(Vec2d(z < 0.0 ? 0.75 : 0.25, 0.5) +
                                       0.2 / (1.0 + std::abs(at.z)) * Vec2d(at));
        }
    }
    const UvShown all = shown_uvs(mesh, uv_options(128));
    int beyond = 0;
    for (std::size_t y = 0; y < 128; ++y)
        for (std::size_t x = 0; x < 128; ++x) {
            const bool lower = x >= 64;
            const Vec2d middle(lower ? 96.0 : 32.0, 64.0);
            const double away = glm::distance(Vec2d(double(x) + 0.5, double(y) + 0.5), middle);
            if (away < 25.6 + 1.5 || away > 25.6 + 6.0) continue;
            const Vec3d point = all.points(x, y);
            EXPECT_TRUE(made::lies_on(mesh, point, 1e-12)) << x << ", " << y;
            EXPECT_TRUE(lower ? point.z > 0.0 : point.z < 0.0) << x << ", " << y;
            EXPECT_EQ(mesh.corners.uvs[3 * all.triangles(x, y)].x > 0.5, lower);
            ++beyond;
        }
    EXPECT_GT(beyond, 1000);
}

TEST(UvAtlas, IsTheSameForAllNumbersOfThreads) {
    const Mesh mesh = uv_mesh(made::ball(4), [](const Vec3d& p) {
        return Vec2d(0.25 + 0.2 * p.x + (p.z < 0.0 ? 0.5 : 0.0), 0.5 + 0.2 * p.y);
    });
    const Connectivity connectivity = build_connectivity(mesh);
    const AtlasOptions options = uv_options(300, UvOverlap::first);
    const auto made_by = [&](int threads) {
        tbb::task_arena arena(threads);
        return arena.execute([&] {
            const MeshAtlas atlas = build_atlas(mesh, connectivity, options);
            return rasterize(mesh, atlas, mesh.positions);
        });
    };
    const SolidAtlas one = made_by(1), four = made_by(4);
    ASSERT_EQ(one.spans.size(), four.spans.size());
    EXPECT_EQ(one.row_begin, four.row_begin);
    for (std::size_t i = 0; i < one.spans.size(); ++i) {
        EXPECT_EQ(one.spans[i].x, four.spans[i].x);
        EXPECT_EQ(one.spans[i].count, four.spans[i].count);
        EXPECT_EQ(one.spans[i].map, four.spans[i].map);
    }
    for (std::size_t i = 0; i < one.maps.size(); ++i)
        EXPECT_EQ(one.maps[i].origin, four.maps[i].origin);
}

TEST(UvAtlas, ATextureThatIsNotSquareFillsItsOwnRowsAlone) {
    const Mesh mesh = uv_mesh(made::square(), [](const Vec3d& p) { return Vec2d(p.x, p.y); });
    AtlasOptions wide = uv_options(32);
    wide.height = 8;
    const UvShown all = shown_uvs(mesh, wide);
    EXPECT_EQ(all.atlas.extent(), Vec2d(32.0, 8.0));
    for (std::size_t y = 0; y < 32; ++y)
        for (std::size_t x = 0; x < 32; ++x)
            if (y < 8) {
                EXPECT_NEAR(all.points(x, y).y, (double(y) + 0.5) / 8.0, 1e-12);
            } else {
                EXPECT_TRUE(std::isnan(all.points(x, y).x));
            }
}

}  // namespace
}  // namespace burl
