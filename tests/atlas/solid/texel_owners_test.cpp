// Which triangle a texel shows, where a map shows several.
#include "atlas/solid/texel_owners.h"

#include <gtest/gtest.h>

#include "atlas/build/mesh_atlas.h"
#include "atlas/solid/level.h"
#include "tests/atlas/support/made_meshes.h"

namespace burl {
namespace {

/// A flat sheet of 6 x 6 squares, a planar patch of many triangles.
Mesh level_sheet() {
    Mesh mesh = made::grid(6, 6);
    for (Vec3d& p : mesh.positions) p.z = 0.0;
    return mesh;
}

/// Weights of a triangle's corners at a point of the plane z = 0.
Vec3d corner_weights(const Mesh& mesh, std::uint32_t triangle, const Vec3d& p) {
    const auto& [i, j, k] = mesh.triangles[triangle];
    const Vec3d a = mesh.positions[i], u = mesh.positions[j] - a, v = mesh.positions[k] - a;
    const double area = u.x * v.y - u.y * v.x;
    const double of_b = ((p - a).x * v.y - (p - a).y * v.x) / area;
    const double of_c = (u.x * (p - a).y - u.y * (p - a).x) / area;
    return {1.0 - of_b - of_c, of_b, of_c};
}

double least(const Vec3d& v) {
    return std::min({v.x, v.y, v.z});
}

TEST(TexelOwners, OnAFlatPatchAreTheTrianglesThatTheTexelsPointsLieIn) {
    const Mesh input = level_sheet();
    for (const AtlasKind kind : {AtlasKind::patch, AtlasKind::quad, AtlasKind::length})
        for (const std::uint32_t level : {0u, 1u}) {
            AtlasOptions options;
            options.kind = kind, options.size = 128;
            const MeshAtlas atlas = build_atlas(input, build_connectivity(input), options);
            const Mesh& mesh = atlas.mesh(input);
            const SolidAtlas solid = solid_level(rasterize(input, atlas, mesh.positions), level);
            const TexelOwners owners(solid, atlas.atlas(), OwnerReach::gutters);
            std::size_t inside = 0, texels = 0;
            for (std::uint32_t y = 0; y < solid.size; ++y)
                for (const Span& span : solid.row(y))
                    for (std::uint32_t x = span.x; x < span.x + span.count; ++x) {
                        const Vec3d p = solid.maps[span.map](x, y);
                        const double within =
                            least(corner_weights(mesh, owners(x, y, span.map), p));
                        ++texels;
                        if (glm::min(p.x, p.y) < 0.01 || glm::max(p.x, p.y) > 0.99) continue;
                        // Beyond it by a gutter's width, where the neighbour is in another chart.
                        ASSERT_GT(within, -1.5) << to_string(kind) << " " << x << " " << y;
                        inside += within > -1e-9;
                    }
            EXPECT_GT(double(inside), 0.7 * double(texels)) << to_string(kind);
        }
}

TEST(TexelOwners, GuttersBelongToTheNearestTriangleOfTheirOwnChart) {
    const Mesh input = level_sheet();
    AtlasOptions options;
    options.size = 512;  // gutters of four texels
    const MeshAtlas atlas = build_atlas(input, build_connectivity(input), options);
    const SolidAtlas solid = rasterize(input, atlas, atlas.mesh(input).positions);
    ASSERT_FALSE(solid.turned.empty());
    const TexelOwners owners(solid, atlas.atlas(), OwnerReach::gutters);
    for (std::uint32_t y = 0; y < solid.size; ++y)
        for (const Span& span : solid.row(y))
            for (std::uint32_t x = span.x; x < span.x + span.count; ++x) {
                const std::uint32_t owner = owners(x, y, span.map);
                ASSERT_EQ(atlas.atlas().charts[owner],
                          atlas.atlas().charts[solid.triangle_of(span.map)]);
                // No farther than a gutter's diagonal from the triangle's place.
                Vec2d low(1e9), high(-1e9);
                for (const Vec2d& corner : atlas.atlas().corners[owner])
                    low = glm::min(low, corner), high = glm::max(high, corner);
                const Vec2d at(x + 0.5, y + 0.5);
                ASSERT_LT(glm::length(at - glm::clamp(at, low, high)), 6.0) << x << " " << y;
            }
}

}  // namespace
}  // namespace burl
