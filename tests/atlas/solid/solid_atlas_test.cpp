// Spans and maps: what a lookup anywhere on the surface reads is the surface's own point.
#include "atlas/solid/solid_atlas.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include <tbb/global_control.h>

#include "tests/atlas/support/made_meshes.h"

namespace burl {
namespace {

struct Tap {
    std::int64_t x, y;
    double weight;
};

std::vector<Tap> taps(const Vec2d& at, Overscan mode) {
    if (mode == Overscan::nearest)
        return {{std::int64_t(std::floor(at.x)), std::int64_t(std::floor(at.y)), 1.0}};
    const double x = std::floor(at.x - 0.5), y = std::floor(at.y - 0.5);
    const double fx = at.x - 0.5 - x, fy = at.y - 0.5 - y;
    const auto i = std::int64_t(x), j = std::int64_t(y);
    return {{i, j, (1 - fx) * (1 - fy)},
            {i + 1, j, fx * (1 - fy)},
            {i, j + 1, (1 - fx) * fy},
            {i + 1, j + 1, fx * fy}};
}

/// Per texel the map it shows: its triangle's number, larger ones for texels no lookup reads.
std::vector<std::uint32_t> owners(const SolidAtlas& solid) {
    std::vector<std::uint32_t> owner(std::size_t{solid.size} * solid.size);
    for (std::size_t y = 0; y < solid.size; ++y)
        for (const Span& span : solid.row(y))
            for (std::size_t x = span.x; x < span.x + span.count; ++x)
                owner[y * solid.size + x] = span.map;
    return owner;
}

/// Corners, points on edges and inside, as barycentric coordinates.
std::vector<Vec3d> sample_weights() {
    constexpr int steps = 9;
    std::vector<Vec3d> weights;
    for (int a = 0; a <= steps; ++a)
        for (int b = 0; a + b <= steps; ++b)
            weights.push_back(Vec3d(a, b, steps - a - b) / double(steps));
    weights.push_back({0.317, 0.682, 0.001});
    weights.push_back({0.001, 0.4995, 0.4995});
    weights.push_back({0.499999, 0.000001, 0.5});
    return weights;
}

/// How many corners of a and b are the same point at the same place in the texture.
int shared_corners(const Mesh& mesh, const Atlas& atlas, std::size_t a, std::size_t b) {
    int count = 0;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            count += mesh.triangles[a][i] == mesh.triangles[b][j] &&
                     atlas.corners[a][i] == atlas.corners[b][j];
    return count;
}

double step_length(const TexelMap& map) {
    return glm::length(map.step_x) + glm::length(map.step_y);
}

struct Fixture {
    Mesh mesh;
    Atlas atlas;
    SolidAtlas solid;
};

/// Whether o's texel may serve t: they meet in the texture, or it shows what the triangle across
/// one of t's edges would show there (a column on the edge between two blocks of a strip).
bool stands_in(const Fixture& f, std::size_t o, std::size_t t, const Tap& tap) {
    if (shared_corners(f.mesh, f.atlas, o, t) >= 1) return true;
    const Vec3d shown = f.solid.maps[o](tap.x, tap.y);
    for (std::size_t n = 0; n < f.mesh.triangles.size(); ++n)
        if (shared_corners(f.mesh, f.atlas, n, t) == 2 &&
            glm::distance(f.solid.maps[n](tap.x, tap.y), shown) < 1e-12)
            return true;
    return false;
}

template <class Check>
void for_all_solids(Check check) {
    for (const auto& [name, mesh] : made::all())
        for (const AtlasKind kind :
             {AtlasKind::uniform, AtlasKind::area, AtlasKind::length, AtlasKind::quad})
            for (const Overscan mode : {Overscan::nearest, Overscan::bilinear})
                for (const std::uint32_t size : {16u, 37u, 128u, 201u}) {
                    const AtlasOptions options{kind, mode, size};
                    if (size < smallest_size(mesh.triangles.size(), options)) continue;
                    if (!made::allowed(kind, size)) continue;
                    SCOPED_TRACE(
                        fmt::format("{} {} {} {}", name, to_string(kind), to_string(mode), size));
                    Fixture f{mesh, {}, {}};
                    f.atlas = layout_atlas(mesh, made::neighbours_by_brute_force(mesh), options);
                    f.solid = rasterize(mesh, f.atlas, mesh.positions);
                    check(f);
                    if (testing::Test::HasFailure()) return;
                }
}

TEST(SolidAtlas, SpansTileEveryRow) {
    for_all_solids([](const Fixture& f) {
        ASSERT_EQ(f.solid.row_begin.size(), std::size_t{f.solid.size} + 1);
        EXPECT_EQ(f.solid.row_begin.back(), f.solid.spans.size());
        for (std::size_t y = 0; y < f.solid.size; ++y) {
            std::uint32_t x = 0;
            for (const Span& span : f.solid.row(y)) {
                EXPECT_EQ(span.x, x);
                EXPECT_GT(span.count, 0u);
                EXPECT_LT(span.map, f.solid.maps.size());
                EXPECT_LT(f.solid.triangle_of(span.map), f.mesh.triangles.size());
                x += span.count;
            }
            EXPECT_EQ(x, f.solid.size);
        }
    });
}

TEST(SolidAtlas, MapsTakeCornersToPoints) {
    for_all_solids([](const Fixture& f) {
        const std::vector<bool> collapsed = made::collapsed_triangles(f.atlas);
        for (std::size_t t = 0; t < f.mesh.triangles.size(); ++t)
            for (std::size_t k = 0; k < 3; ++k) {
                if (collapsed[t]) continue;
                const TexelMap& map = f.solid.maps[t];
                const Vec2d at = f.atlas.corners[t][k];
                const Vec3d shown = map.origin + (at.x - 0.5 - map.anchor_x) * map.step_x +
                                    (at.y - 0.5 - map.anchor_y) * map.step_y;
                const Vec3d point = f.mesh.positions[f.mesh.triangles[t][k]];
                EXPECT_LT(glm::distance(shown, point), 1e-13 * (1.0 + glm::length(point)));
            }
    });
}

TEST(SolidAtlas, AnchorsLieInTheTrianglesBlock) {
    for_all_solids([](const Fixture& f) {
        for (const Block& block : f.atlas.blocks)
            for (const std::int32_t t : {block.lower, block.upper}) {
                if (t < 0) continue;
                const TexelMap& map = f.solid.maps[std::size_t(t)];
                EXPECT_GE(map.anchor_x, std::int64_t{block.x});
                EXPECT_LT(map.anchor_x, std::int64_t{block.x} + block.width);
                EXPECT_GE(map.anchor_y, std::int64_t{block.y});
                EXPECT_LT(map.anchor_y, std::int64_t{block.y} + block.height);
            }
    });
}

// The property the atlas is for. A tap owned by another triangle is allowed only across a mesh
// edge or corner that both have at the same place in the texture, and shows a point near by.
TEST(SolidAtlas, LookupsReadTheirOwnTriangleOrANeighbourAcrossASharedEdge) {
    std::uint64_t own = 0, across = 0;
    for_all_solids([&](const Fixture& f) {
        const Overscan mode = f.atlas.options.overscan;
        const std::vector<std::uint32_t> owner = owners(f.solid);
        for (std::size_t t = 0; t < f.mesh.triangles.size(); ++t)
            for (const Vec3d& w : sample_weights()) {
                Vec2d at{0.0};
                Vec3d point{0.0};
                for (std::size_t k = 0; k < 3; ++k) {
                    at += w[int(k)] * f.atlas.corners[t][k];
                    point += w[int(k)] * f.mesh.positions[f.mesh.triangles[t][k]];
                }
                for (const Tap& tap : taps(at, mode)) {
                    if (tap.weight < 1e-9) continue;
                    ASSERT_TRUE(tap.x >= 0 && tap.x < f.solid.size);
                    ASSERT_TRUE(tap.y >= 0 && tap.y < f.solid.size);
                    const std::size_t o =
                        owner[std::size_t(tap.y) * f.solid.size + std::size_t(tap.x)];
                    ASSERT_LT(o, f.mesh.triangles.size());
                    ++(o == t ? own : across);
                    if (o == t) continue;
                    EXPECT_EQ(f.atlas.charts[o], f.atlas.charts[t]);
                    EXPECT_TRUE(stands_in(f, o, t, tap)) << o << " for " << t;
                    const double reach = mode == Overscan::nearest ? 0.75 : 1.5;
                    EXPECT_LE(
                        glm::distance(f.solid.maps[o](tap.x, tap.y), point),
                        reach * (step_length(f.solid.maps[o]) + step_length(f.solid.maps[t])));
                }
            }
    });
    EXPECT_GT(own, 100000u);
    EXPECT_GT(across, 1000u);
}

TEST(SolidAtlas, BilinearLookupOfSinglesReproducesTheSurfaceExactly) {
    std::uint64_t checked = 0;
    for_all_solids([&](const Fixture& f) {
        if (f.atlas.options.overscan != Overscan::bilinear) return;
        const std::vector<std::uint32_t> owner = owners(f.solid);
        for (const Block& block : f.atlas.blocks) {
            if (block.shares_hypotenuse || block.collapsed()) continue;
            for (const std::int32_t face : {block.lower, block.upper}) {
                if (face < 0) continue;
                const auto t = std::size_t(face);
                for (const Vec3d& w : sample_weights()) {
                    Vec2d at{0.0};
                    Vec3d point{0.0}, shown{0.0};
                    for (std::size_t k = 0; k < 3; ++k) {
                        at += w[int(k)] * f.atlas.corners[t][k];
                        point += w[int(k)] * f.mesh.positions[f.mesh.triangles[t][k]];
                    }
                    for (const Tap& tap : taps(at, Overscan::bilinear)) {
                        if (tap.weight < 1e-12) continue;
                        const std::size_t o =
                            owner[std::size_t(tap.y) * f.solid.size + std::size_t(tap.x)];
                        shown += tap.weight * f.solid.maps[o](tap.x, tap.y);
                    }
                    EXPECT_LT(glm::distance(shown, point), 1e-10 * (1.0 + glm::length(point)));
                    ++checked;
                }
            }
        }
    });
    EXPECT_GT(checked, 10000u);
}

TEST(SolidAtlas, AnyNumberOfThreadsMakesTheSameSpans) {
    const Mesh mesh = made::ball(5);
    // Blocks of one texel in several bands of rows, and blocks that are higher than a band.
    for (const auto& [kind, size] :
         {std::pair{AtlasKind::quad, 128u}, {AtlasKind::quad, 1024u}, {AtlasKind::area, 1024u}}) {
        const Atlas atlas = layout_atlas(mesh, made::neighbours_by_brute_force(mesh),
                                         {kind, Overscan::bilinear, size});
        const SolidAtlas many = rasterize(mesh, atlas, mesh.positions);
        const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
        const SolidAtlas one = rasterize(mesh, atlas, mesh.positions);
        EXPECT_EQ(many.row_begin, one.row_begin);
        EXPECT_EQ(many.turned, one.turned);
        const auto same = [](const Span& a, const Span& b) {
            return a.x == b.x && a.count == b.count && a.map == b.map;
        };
        EXPECT_TRUE(std::ranges::equal(many.spans, one.spans, same));
        for (std::size_t y = 0; y < size; ++y)
            EXPECT_TRUE(std::ranges::is_sorted(many.row(y), {}, &Span::x));
    }
}

TEST(SolidAtlas, UnitSpaceCentresTheBoxAndMakesItsLongestSideOne) {
    Mesh mesh = made::grid(4, 2);
    for (Vec3d& p : mesh.positions) p = 8.0 * p + Vec3d{1e6, -3.0, 0.5};
    const auto points = map_positions(mesh, solid_from_mesh(mesh, SolidSpace::unit));
    Mesh mapped = mesh;
    mapped.positions = points;
    const Box3 box = bounding_box(mapped);
    EXPECT_NEAR(box.longest_side(), 1.0, 1e-9);
    EXPECT_LT(glm::length(box.centre()), 1e-9);
    EXPECT_EQ(map_positions(mesh, solid_from_mesh(mesh, SolidSpace::object)), mesh.positions);
}

TEST(SolidAtlas, UnitSpaceOfOnePointIsFinite) {
    const Mesh mesh = made::mesh_of({{2, 3, 4}}, {{0, 0, 0}});
    const auto points = map_positions(mesh, solid_from_mesh(mesh, SolidSpace::unit));
    EXPECT_EQ(points[0], Vec3d(0.0));
}

}  // namespace
}  // namespace burl
