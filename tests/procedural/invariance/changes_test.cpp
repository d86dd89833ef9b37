// What a bake owes to its mesh alone: each change of the mesh that says nothing new of it, against
// the table of docs/reference/invariance.md. Bounds are a few times what was measured.
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <fmt/format.h>

#include "atlas/mesh/mesh_builder.h"
#include "atlas/mesh/polygon_soup.h"
#include "tests/procedural/invariance/made_bakes.h"
#include "tests/procedural/support/only_target.h"

namespace burl {
namespace {

using test::made_bake;
using test::MadeBake;
using test::mapped_mesh;
using test::same_bytes;

constexpr AtlasKind all_kinds[] = {AtlasKind::uniform, AtlasKind::area,  AtlasKind::length,
                                   AtlasKind::quad,    AtlasKind::patch, AtlasKind::chart,
                                   AtlasKind::uv};

/// A ball in single precision, as files have them: many of its places in the unit frame are ties.
Mesh ball_of_floats() {
    Mesh mesh = made::ball(4);
    for (Vec3d& p : mesh.positions) p = Vec3d(Vec3f(p));
    return mesh;
}

/// Meshes of which no triangle lies on another, and then `nasty`, which has such.
std::vector<made::Named> changed_meshes(AtlasKind kind, bool with_copies) {
    std::vector<made::Named> meshes{{"ball", made::ball(3)},
                                    {"floats", ball_of_floats()},
                                    {"ring", made::ring(24, 12)},
                                    {"box", made::box(4)},
                                    {"grid", made::grid(9, 7)}};
    if (with_copies) meshes.push_back({"nasty", made::nasty()});
    if (kind == AtlasKind::uv)
        for (made::Named& one : meshes) one.mesh = test::with_own_places(one.mesh);
    return meshes;
}

/// Calls check(kind, mesh, its bake) for all kinds and meshes.
template <class Check>
void for_all_bakes(bool with_copies, const Check& check) {
    for (const AtlasKind kind : all_kinds)
        for (const auto& [name, mesh] : changed_meshes(kind, with_copies)) {
            SCOPED_TRACE(fmt::format("{} {}", to_string(kind), name));
            check(kind, mesh, made_bake(mesh, kind));
        }
}

void expect_same_atlas(const MadeBake& a, const MadeBake& b) {
    EXPECT_TRUE(same_bytes(a.atlas.atlas().corners, b.atlas.atlas().corners));
    EXPECT_EQ(a.atlas.atlas().charts, b.atlas.atlas().charts);
    EXPECT_EQ(a.atlas.mesh(a.mesh).triangles, b.atlas.mesh(b.mesh).triangles);
}

void expect_same_bytes(const MadeBake& a, const MadeBake& b) {
    expect_same_atlas(a, b);
    EXPECT_TRUE(same_bytes(a.solid.spans, b.solid.spans));
    ASSERT_EQ(a.solid.maps.size(), b.solid.maps.size());
    for (std::size_t i = 0; i < a.solid.maps.size(); ++i) {
        EXPECT_EQ(a.solid.maps[i].origin, b.solid.maps[i].origin);
        EXPECT_EQ(a.solid.maps[i].step_x, b.solid.maps[i].step_x);
        EXPECT_EQ(a.solid.maps[i].step_y, b.solid.maps[i].step_y);
    }
    EXPECT_EQ(a.texture, b.texture);
    EXPECT_EQ(a.levels, b.levels);
}

/// How far two bakes of the same triangles are apart, at most.
struct Apart {
    double places = 0.0;    ///< places of 2,000 points of the surface, texels
    double points = 0.0;    ///< points that texels show, sides of the unit box
    std::size_t shown = 0;  ///< texels that show something in one of them only
    int codes = 0;          ///< components of the texture, 8-bit codes
};

Apart apart(const MadeBake& a, const MadeBake& b) {
    Apart apart;
    const auto at = area_uniform_points(a.mesh, 2000, 1);
    const auto places = test::shown_places(a, at), others = test::shown_places(b, at);
    for (std::size_t i = 0; i < places.size(); ++i)
        apart.places = std::max(apart.places, glm::distance(places[i], others[i]));
    const auto points = test::shown_points(a.solid), seen = test::shown_points(b.solid);
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (std::isnan(points[i].x) && std::isnan(seen[i].x)) continue;
        apart.shown += std::isnan(points[i].x) != std::isnan(seen[i].x);
        apart.points = std::max(apart.points, glm::distance(points[i], seen[i]));
        const Rgb8 &p = a.texture.pixels()[i], &q = b.texture.pixels()[i];
        apart.codes =
            std::max({apart.codes, std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
    }
    return apart;
}

AtlasMetrics metrics_of(const MadeBake& bake) {
    return measure(bake.atlas.mesh(bake.mesh), bake.atlas.atlas(), bake.solid);
}

/// The turn by `a` radians about z, then about x.
Mat3d turn(double a) {
    const double c = std::cos(a), s = std::sin(a);
    return Mat3d(c, s, 0, -s, c, 0, 0, 0, 1) * Mat3d(1, 0, 0, 0, c, s, 0, -s, c);
}

TEST(Invariance, ScalesByPowersOfTwoChangeNoByte) {
    for_all_bakes(true, [](AtlasKind kind, const Mesh& mesh, const MadeBake& bake) {
        for (const double scale : {0x1p-20, 2.0, 0x1p30})
            expect_same_bytes(bake, made_bake(mapped_mesh(mesh, Mat3d(scale), {}), kind));
    });
}

TEST(Invariance, OtherScalesAndMovesRound) {
    for_all_bakes(false, [](AtlasKind kind, const Mesh& mesh, const MadeBake& bake) {
        if (kind == AtlasKind::quad) return;
        const auto check = [&](double scale, const Vec3d& by) {
            SCOPED_TRACE(fmt::format("{} {}", scale, by.x));
            const Apart far = apart(bake, made_bake(mapped_mesh(mesh, Mat3d(scale), by), kind));
            // A point that far away has a last place of 2^-52 of the distance.
            const double rounding = 1e-14 + 0x1p-50 * glm::length(by);
            EXPECT_LT(far.places, 1e-12 + 100 * rounding);
            // Beside a chart of uv the nearest of two points of its border may be the other one.
            EXPECT_LT(far.points, kind == AtlasKind::uv ? 1e-3 : rounding);
            EXPECT_EQ(far.shown, 0u);
            EXPECT_LE(far.codes, 1);
        };
        for (const double scale : {3.7, 1e-6, 7.7e5}) check(scale, {});
        for (const Vec3d& by : {Vec3d(3, -2, 0.25), Vec3d(1000.1, -1000.3, 5.7), Vec3d(1e6)})
            check(1.0, by);
    });
}

TEST(Invariance, StripsAndUvDoNotSeeTurns) {
    for (const AtlasKind kind :
         {AtlasKind::uniform, AtlasKind::area, AtlasKind::length, AtlasKind::uv})
        for (const auto& [name, mesh] : changed_meshes(kind, true))
            for (const double angle : {0.7, 2.0}) {
                SCOPED_TRACE(fmt::format("{} {} {}", to_string(kind), name, angle));
                const Affine3 there{Mat3d(1.0), Vec3d(0.0)};
                const Affine3 back{glm::transpose(turn(angle)), Vec3d(0.0)};
                const MadeBake bake = made_bake(mesh, kind, &there);
                const MadeBake turned = made_bake(mapped_mesh(mesh, turn(angle), {}), kind, &back);
                const Apart far = apart(bake, turned);
                EXPECT_EQ(far.places, 0.0);
                EXPECT_LT(far.points, kind == AtlasKind::uv ? 2e-3 : 1e-14);
                EXPECT_LE(far.codes, 1);
            }
}

/// The largest change of an atlas's relative scale that a rearrangement was seen to bring, and a
/// half more: of the charts' own luck in packing above all.
double allowed_change(AtlasKind kind) {
    return kind == AtlasKind::chart ? 0.08 : kind == AtlasKind::quad ? 0.03 : 0.015;
}

void expect_as_good(AtlasKind kind, const MadeBake& a, const MadeBake& b) {
    const AtlasMetrics one = metrics_of(a), other = metrics_of(b);
    EXPECT_NEAR(one.relative_scale, other.relative_scale, allowed_change(kind));
    EXPECT_NEAR(one.coverage, other.coverage, 1.5 * allowed_change(kind));
    EXPECT_EQ(one.zero_area, other.zero_area);
}

TEST(Invariance, RearrangedAtlasesAreAsGood) {
    for_all_bakes(true, [](AtlasKind kind, const Mesh& mesh, const MadeBake& bake) {
        for (const double angle : {std::numbers::pi / 2, 0.7, 2.0})
            expect_as_good(kind, bake, made_bake(mapped_mesh(mesh, turn(angle), {}), kind));
        for (const std::uint32_t seed : {1u, 2u, 3u})
            expect_as_good(kind, bake,
                           made_bake(test::with_faces_in_another_order(mesh, seed), kind));
        for (const double by : {3.7, 1e6})  // quad decides between equals by the last bits
            expect_as_good(kind, bake, made_bake(mapped_mesh(mesh, Mat3d(by), Vec3d(by)), kind));
    });
}

/// The mesh as a file with its points in another order would be read.
Mesh read_in_another_order(const Mesh& mesh, std::uint32_t seed) {
    std::vector<std::uint32_t> order(mesh.positions.size());
    std::iota(order.begin(), order.end(), 0u);
    std::mt19937 random(seed);
    if (seed > 0)
        for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    PolygonSoup soup;
    soup.points.resize(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) soup.points[order[i]] = mesh.positions[i];
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t p : t) soup.corners.push_back(order[p]);
    soup.uvs.values = mesh.corners.uvs;
    for (std::uint32_t c = 0; c < soup.uvs.values.size(); ++c) soup.uvs.of_corner.push_back(c);
    return build_mesh(std::move(soup), "mesh.obj");
}

TEST(Invariance, OrderOfPointsIsForgottenWhenAFileIsRead) {
    for (const auto& [name, mesh] : changed_meshes(AtlasKind::uv, true)) {
        const Mesh read = read_in_another_order(mesh, 0);
        for (const std::uint32_t seed : {1u, 2u, 3u}) {
            const Mesh other = read_in_another_order(mesh, seed);
            EXPECT_TRUE(same_bytes(other.positions, read.positions)) << name;
            EXPECT_TRUE(same_bytes(other.triangles, read.triangles)) << name;
            EXPECT_TRUE(same_bytes(other.corners.uvs, read.corners.uvs)) << name;
        }
    }
}

TEST(Invariance, ThreadsChangeNoByte) {
    const tbb::global_control more(tbb::global_control::max_allowed_parallelism, 8);
    for_all_bakes(true, [](AtlasKind kind, const Mesh& mesh, const MadeBake& bake) {
        for (const int threads : {1, 3, 8}) {
            tbb::task_arena arena(threads);
            arena.execute([&] { expect_same_bytes(bake, made_bake(mesh, kind)); });
        }
    });
}

TEST(Invariance, InstructionSetsChangeNoByte) {
    const Mesh mesh = made::ball(3);
    for (const AtlasKind kind :
         {AtlasKind::area, AtlasKind::quad, AtlasKind::patch, AtlasKind::chart}) {
        const MadeBake bake = made_bake(mesh, kind);
        on_every_target([&] { expect_same_bytes(bake, made_bake(mesh, kind)); });
    }
}

}  // namespace
}  // namespace burl
