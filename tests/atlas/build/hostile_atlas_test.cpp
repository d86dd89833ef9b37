// Odd meshes in textures too small for them: an atlas there always is, no texel has two owners, no
// triangle is turned over or lies on another, and those without area in the texture are counted.
#include <cmath>
#include <filesystem>
#include <numbers>

#include <gtest/gtest.h>

#include "atlas/build/mesh_atlas.h"
#include "atlas/measure/atlas_measures.h"
#include "atlas/patch/atlas.h"
#include "atlas/read/read_mesh.h"
#include "tests/atlas/support/made_patches.h"
#include "tests/paths.h"

namespace burl {
namespace {

/// A flat fan of more than a turn round its first point.
Mesh spiral(int count, double step) {
    std::vector<Vec3d> points{{0.0, 0.0, 0.0}};
    std::vector<Triangle> triangles;
    for (int i = 0; i <= count; ++i) {
        points.emplace_back(std::cos(step * i), std::sin(step * i), 0.0);
        if (i > 0) triangles.push_back({0, std::uint32_t(i), std::uint32_t(i) + 1});
    }
    return made::mesh_of(points, triangles);
}

/// Two flat plates with a hole like a star, whose border is longer than the plate's own.
Mesh plates_with_stars() {
    constexpr std::uint32_t sides = 64;
    std::vector<Vec3d> points;
    std::vector<Triangle> triangles;
    for (const double height : {0.0, 1.0}) {
        const auto first = std::uint32_t(points.size());
        for (std::uint32_t i = 0; i < sides; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / sides;
            const Vec3d out(std::cos(angle), std::sin(angle), height);
            const double inner = i % 2 == 0 ? 0.9 : 0.1;
            points.push_back(out);
            points.emplace_back(inner * out.x, inner * out.y, height);
            const std::uint32_t here = first + 2 * i, next = first + 2 * ((i + 1) % sides);
            triangles.push_back({here, next, here + 1});
            triangles.push_back({here + 1, next, next + 1});
        }
    }
    return made::mesh_of(points, triangles);
}

std::vector<made::Named> hostile_meshes() {
    std::vector<made::Named> meshes = made::all();
    meshes.push_back({"tube", made::tube(12, 6, 3.0)});
    meshes.push_back({"ring", made::ring(12, 8)});
    meshes.push_back({"box", made::box(3)});
    meshes.push_back({"many pieces", made::soup(300, 5)});
    meshes.push_back({"spiral", spiral(10, 0.7)});
    meshes.push_back({"two turns", spiral(8, 0.5 * std::numbers::pi)});
    meshes.push_back({"plates with stars", plates_with_stars()});
    meshes.push_back({"patch-overlap.obj", read_mesh(test::case_file("patch-overlap.obj"))});
    const std::filesystem::path nasty = test::source_folder() + "/assets/meshes/nasty";
    for (const auto& file : std::filesystem::directory_iterator(nasty))
        meshes.push_back({file.path().filename().string(), read_mesh(file.path().string())});
    return meshes;
}

/// How many texels have an owner; fails where one has two.
std::size_t owned_texels(const SolidAtlas& solid) {
    std::size_t owned = 0;
    for (std::size_t y = 0; y < solid.size; ++y) {
        std::uint32_t next = 0;
        for (const Span& span : solid.row(y)) {
            EXPECT_GE(span.x, next);
            EXPECT_LE(span.x + span.count, solid.size);
            EXPECT_LT(span.map, solid.maps.size());
            next = span.x + span.count;
            owned += span.count;
        }
    }
    return owned;
}

/// Triangles whose place says that they may have no area there.
std::size_t counted_without_area(const MeshAtlas& atlas) {
    if (const PatchAtlas* patches = atlas.patches()) return patches->unmapped;
    const Atlas& own = atlas.atlas();
    if (own.options.kind == AtlasKind::chart)
        return std::size_t(std::ranges::count_if(
            own.corners, [](const auto& c) { return c[0] == c[1] && c[0] == c[2]; }));
    return own.notes.minimal_cells + own.notes.shared_triangles;
}

void expect_sound(const Mesh& mesh, const MeshAtlas& made, std::uint32_t size) {
    const Atlas& atlas = made.atlas();
    const Mesh& surface = made.mesh(mesh);
    ASSERT_EQ(atlas.options.size, size);
    ASSERT_EQ(atlas.corners.size(), surface.triangles.size());
    for (const auto& corners : atlas.corners)
        for (const Vec2d& corner : corners) EXPECT_TRUE(std::isfinite(corner.x + corner.y));
    const std::size_t owned = owned_texels(rasterize(mesh, made, surface.positions));
    const bool fills =
        made.patches() || atlas.options.kind == AtlasKind::chart || std::has_single_bit(size);
    EXPECT_GT(owned, 0u);
    EXPECT_TRUE(!fills || owned == std::size_t{size} * size);
    const TexelMetrics texels = measure_texels(atlas);
    EXPECT_EQ(texels.overlapped, 0u);
    EXPECT_EQ(texels.outside, 0u);
    const ShapeMetrics shape = measure_shape(surface, atlas, atlas.charts, atlas.chart_count);
    EXPECT_EQ(shape.flipped, 0u);
    EXPECT_LE(shape.vanished, counted_without_area(made));
}

/// A triangle on a line may have got an area by rounding alone, and lose it with the mesh's own
/// points.
TEST(HostileAtlas, PlanesThatLoseTheirHeightKeepTheirPlaces) {
    const Patch bent =
        made::whole(made::mesh_of({{0, 0, 0}, {2, 0, 0}, {1, 1e-7, 0}}, {{0, 1, 2}}));
    MappedPatch mapped;
    mapped.patch = bent;
    mapped.planar = map_planar(bent);
    ASSERT_TRUE(mapped.planar);
    mapped.uv = mapped.planar->uv;
    PatchMaps maps;
    maps.patches.push_back(mapped);
    to_mesh_frame(maps, made::mesh_of({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}, {{0, 1, 2}}));
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(maps.patches[0].uv[i].x, mapped.uv[i].x, 1e-6);
        EXPECT_NEAR(maps.patches[0].uv[i].y, mapped.uv[i].y, 1e-6);
    }
}

TEST(HostileAtlas, EveryMeshHasAnAtlasOfEverySize) {
    for (const auto& [name, mesh] : hostile_meshes()) {
        const Connectivity connectivity = build_connectivity(mesh);
        for (const AtlasKind kind : {AtlasKind::patch, AtlasKind::chart, AtlasKind::quad})
            for (const std::uint32_t size : {1u, 2u, 3u, 5u, 8u, 17u, 64u}) {
                if (!made::allowed(kind, size)) continue;
                SCOPED_TRACE(name + ' ' + std::string(to_string(kind)) + ' ' +
                             std::to_string(size));
                AtlasOptions options;
                options.kind = kind;
                options.size = size;
                options.tries = 1;
                expect_sound(mesh, build_atlas(mesh, connectivity, options), size);
            }
    }
}

}  // namespace
}  // namespace burl
