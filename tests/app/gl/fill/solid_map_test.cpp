// The solid map on the graphics processor: every texel's owner is the host's and its point is that
// texel's, however far from the origin the mesh lies.
#include "app/gl/fill/solid_map.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <gtest/gtest.h>

#include "atlas/build/mesh_atlas.h"
#include "tests/app/gl/device/fixture.h"
#include "tests/app/support/sample_scene.h"

namespace burl {
namespace {

using GlSolidMapTest = GlTest;

/// Of a sphere of radius 1, by patches, its box's corner `distance` from the origin on every axis.
SolidAtlas sphere_atlas(double distance, AtlasKind kind) {
    const Mesh mesh = sphere_mesh(8, 12);
    AtlasOptions options;
    options.kind = kind;
    options.size = 128;
    const MeshAtlas atlas = build_atlas(mesh, build_connectivity(mesh), options);
    return rasterize(mesh, atlas, map_positions(atlas.mesh(mesh), {Mat3d(1.0), Vec3d(distance)}));
}

TEST_F(GlSolidMapTest, HasTheHostsOwnersAndPointsWhereverTheMeshLies) {
    for (const AtlasKind kind : {AtlasKind::patch, AtlasKind::quad, AtlasKind::area})
        for (const double distance : {0.0, 2e6})
            for (const MapFill fill : {MapFill::gpu, MapFill::host}) {
                const SolidAtlas solid = sphere_atlas(distance, kind);
                const Affine3 map{Mat3d(0.5), Vec3d(0, 0, 1)};  // to the unit box's size
                const GlSolidMap solid_map =
                    make_solid_map(context->gl(), solid, map, solid_base(solid, map),
                                   {{0, 0}, {int(solid.size), int(solid.size)}}, 1, fill);
                const auto local = solid_map.target().read<float>(0);
                const auto owners = solid_map.target().read<std::uint32_t>(1);
                std::vector<std::uint32_t> expected(owners.size(), no_owner);
                double error = 0.0;
                for (std::size_t y = 0; y < solid.size; ++y)
                    for (const Span& span : solid.row(y))
                        for (std::size_t x = span.x; x < span.x + span.count; ++x) {
                            const std::size_t at = y * solid.size + x;
                            expected[at] = span.map;
                            const Vec3d p =
                                map(solid.maps[span.map](std::int64_t(x), std::int64_t(y)));
                            for (int axis = 0; axis < 3; ++axis)
                                error = std::max(
                                    error,
                                    std::abs(solid_map.base()[axis] +
                                             double(local[4 * at + std::size_t(axis)]) - p[axis]));
                        }
                EXPECT_EQ(owners, expected) << to_string(kind) << ' ' << distance;
                EXPECT_LE(error, 5e-8) << to_string(kind);
                EXPECT_GT(error, 0.0);
            }
}

/// Without its odd rows: an atlas of this sphere has no gaps of its own.
SolidAtlas even_rows(const SolidAtlas& whole) {
    SolidAtlas solid = whole;
    solid.spans.clear();
    for (std::size_t y = 0; y < whole.size; ++y) {
        solid.row_begin[y] = solid.spans.size();
        if (y % 2 == 0) std::ranges::copy(whole.row(y), std::back_inserter(solid.spans));
    }
    solid.row_begin[whole.size] = solid.spans.size();
    return solid;
}

TEST_F(GlSolidMapTest, LeavesGapsEmpty) {
    const SolidAtlas solid = even_rows(sphere_atlas(0.0, AtlasKind::patch));
    for (const MapFill fill : {MapFill::gpu, MapFill::host}) {
        const GlSolidMap map =
            make_solid_map(context->gl(), solid, {}, Vec3d(0.5),
                           {{0, 0}, {int(solid.size), int(solid.size)}}, 1, fill);
        const auto local = map.target().read<float>(0);
        const auto owners = map.target().read<std::uint32_t>(1);
        ASSERT_EQ(owners.size(), std::size_t(solid.size) * solid.size);
        for (std::size_t i = 0; i < owners.size(); ++i) {
            const bool gap = i / solid.size % 2 == 1;
            ASSERT_EQ(owners[i] == no_owner, gap);
            ASSERT_EQ(local[4 * i + 3], gap ? 0.0f : 1.0f);
            for (std::size_t c = 0; c < 3; ++c) ASSERT_TRUE(!gap || local[4 * i + c] == 0.0f);
        }
    }
}

}  // namespace
}  // namespace burl
