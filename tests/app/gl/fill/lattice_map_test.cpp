// Lattice maps as textures: whoever fills them, they hold the bits that the host works with.
#include "app/gl/fill/lattice_map.h"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/gl/fill/spans.h"
#include "app/surface/sample_meshes.h"
#include "atlas/build/mesh_atlas.h"
#include "procedural/fill/pieces.h"
#include "procedural/kernels/simplex_kernel.h"
#include "procedural/maps/lattice_map.h"
#include "procedural/maps/point_map.h"
#include "tests/app/gl/device/fixture.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

using GlLatticeMapTest = GlTest;

const Quadric quadric{1.5, -2, 0.25, 3, -0.75, 1, 2, 0.5, -1, 7};
const Affine3 lattice{Mat3d(7, 1, -2, 0, 5, 3, 1, 1, -6), Vec3d(3, -8, 0.5)};

GlTile whole(const SolidAtlas& solid) {
    return {{0, 0}, {int(solid.size), int(solid.size)}};
}

SolidAtlas sample_atlas(const char* name, AtlasKind kind, std::uint32_t size) {
    const Mesh mesh = sample_mesh(std::string("sample:") + name);
    AtlasOptions options;
    options.kind = kind;
    options.size = size;
    const MeshAtlas atlas = build_atlas(mesh, build_connectivity(mesh), options);
    const Affine3 map = solid_from_mesh(mesh, SolidSpace::unit);
    return rasterize(mesh, atlas, map_positions(atlas.mesh(mesh), map));
}

/// Texels of a target that differ from the host's.
std::size_t differences(const GlTarget& target, std::size_t number,
                        const Image<MapTexel>& expected) {
    const auto texels = target.read<std::uint32_t>(number);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < expected.pixels().size(); ++i) {
        const auto* t = &texels[4 * i];
        wrong += MapTexel(t[0], t[1], t[2], t[3]) != expected.pixels()[i];
    }
    return wrong;
}

/// The number of texels of both textures that differ from the host's fill.
std::size_t differences(const GlContext& context, MapFill fill, const SolidAtlas& solid,
                        const Affine3& move, const std::optional<LatticeStreamKey>& stream,
                        const std::optional<Quadric>& q, const GlTile& tile) {
    const std::vector<TexelMap> maps = moved_maps(solid.maps, move, 1);
    const LatticeMap expected = fill_lattice_map(solid, maps, stream, q, area_of(tile), 1);
    const GlLatticeMapper mapper(context.gl(), solid, maps, 1, fill);
    EXPECT_EQ(mapper.draws(), fill == MapFill::gpu);
    const GlLatticeMap map = mapper.make(stream, q, tile);
    EXPECT_EQ(map.size(), tile.size);
    return differences(map.target(), 0, expected.cells) +
           differences(map.target(), 1, expected.places);
}

TEST_F(GlLatticeMapTest, HoldsTheHostsNumbersForEveryKindOfAtlas) {
    const Affine3 move{Mat3d(0.75), Vec3d(0.25, -1, 3)};
    const LatticeStreamKey stream{lattice, 5, 0.0};
    struct Case {
        const char* mesh;
        AtlasKind kind;
        std::uint32_t size;
    };
    for (const auto& [mesh, kind, size] :
         {Case{"teapot", AtlasKind::patch, 256}, Case{"cube", AtlasKind::uniform, 64},
          Case{"torus", AtlasKind::area, 256}, Case{"cube", AtlasKind::length, 64},
          Case{"teapot", AtlasKind::quad, 256}, Case{"torus", AtlasKind::patch, 64}}) {
        const SolidAtlas solid = sample_atlas(mesh, kind, size);
        for (const MapFill fill : {MapFill::gpu, MapFill::host})
            EXPECT_EQ(differences(*context, fill, solid, move, stream, quadric, whole(solid)), 0u)
                << mesh << ' ' << to_string(kind) << ' ' << size;
    }
}

TEST_F(GlLatticeMapTest, HoldsTheHostsNumbersFarOutAndOnSteepLines) {
    for (const double period : {0.0, double(simplex_period)})
        for (const double frequency : {1e-3, 1.0, 1e5, 1e7, 1e12, 1e15, 1e300})
            for (const double offset : {0.0, 1e6}) {
                SyntheticAtlas atlas;
                atlas.block = 9;
                atlas.offset = offset;
                const SolidAtlas solid = atlas.make(6);
                const LatticeStreamKey stream{
                    {frequency * lattice.linear, lattice.offset}, 4, period};
                EXPECT_EQ(differences(*context, MapFill::gpu, solid, Affine3{}, stream, quadric,
                                      whole(solid)),
                          0u)
                    << period << ' ' << frequency << ' ' << offset;
            }
}

TEST_F(GlLatticeMapTest, CarriesWhereAPlaceRoundsToACell) {
    SolidAtlas solid;
    solid.size = 4;
    solid.maps = {{Vec3d(-1e-20, 3.0 - 1e-15, -5), Vec3d(1e6), Vec3d(0.0), 0, 0}};
    solid.spans = {{0, 4, 0}};
    solid.row_begin = {0, 1, 1, 1, 1};
    const LatticeStreamKey stream{Affine3{}, 0, 0.0};
    const LatticeMap map =
        fill_lattice_map(solid, solid.maps, stream, quadric, area_of(whole(solid)), 1);
    ASSERT_EQ(map.cells(0, 0).x, 0u);  // not the cell that it lies in, -1
    EXPECT_EQ(differences(*context, MapFill::gpu, solid, Affine3{}, stream, quadric, whole(solid)),
              0u);
}

TEST_F(GlLatticeMapTest, DrawsTilesOfAnySize) {
    SyntheticAtlas atlas;
    atlas.size = 100;
    atlas.block = 17;
    const SolidAtlas solid = atlas.make(7);
    const LatticeStreamKey stream{lattice, 0, 0.0};
    for (const GlTile& tile : {GlTile{{0, 0}, {100, 100}}, GlTile{{0, 31}, {100, 40}},
                               GlTile{{13, 57}, {61, 29}}, GlTile{{99, 99}, {1, 1}}})
        for (const MapFill fill : {MapFill::gpu, MapFill::host})
            EXPECT_EQ(differences(*context, fill, solid, Affine3{}, stream, quadric, tile), 0u)
                << tile.origin.x << ' ' << tile.origin.y;
}

TEST_F(GlLatticeMapTest, DrawsPartsOfTheLargestAtlas) {
    SyntheticAtlas atlas;
    atlas.size = max_atlas_size;
    atlas.block = 999;
    const SolidAtlas solid = atlas.make(13);
    const LatticeStreamKey stream{lattice, 0, 0.0};
    for (const GlTile& tile : {GlTile{{0, 8190}, {16384, 3}}, GlTile{{16001, 16370}, {383, 14}}})
        EXPECT_EQ(differences(*context, MapFill::gpu, solid, Affine3{}, stream, quadric, tile), 0u)
            << tile.origin.x;
}

TEST_F(GlLatticeMapTest, HoldsTheHostsPoints) {
    SyntheticAtlas atlas;
    atlas.size = 70;
    const SolidAtlas solid = atlas.make(12);
    const Affine3 move{Mat3d(0.75), Vec3d(0.25, -1, 3)};
    const GlTile tile{{3, 9}, {60, 50}};
    const std::vector<TexelMap> maps = moved_maps(solid.maps, move, 1);
    for (const double frequency : {0.1, 1e6, 1e15})
        for (const MapFill fill : {MapFill::gpu, MapFill::host})
            for (const bool in_lattice : {false, true}) {
                const Affine3 map{frequency * lattice.linear, lattice.offset};
                const PointMap expected =
                    fill_point_map(solid, maps, map, in_lattice, area_of(tile), 1);
                const GlLatticeMapper mapper(context->gl(), solid, maps, 1, fill);
                const GlPointMap points = mapper.make_points(map, in_lattice, tile);
                EXPECT_EQ(differences(points.target(), 0, expected.xy), 0u) << frequency;
                EXPECT_EQ(differences(points.target(), 1, expected.z_owner), 0u) << frequency;
            }
}

TEST_F(GlLatticeMapTest, NeedsNeitherStreamNorQuadric) {
    const SolidAtlas solid = SyntheticAtlas{}.make(9);
    for (const MapFill fill : {MapFill::gpu, MapFill::host}) {
        EXPECT_EQ(
            differences(*context, fill, solid, Affine3{}, std::nullopt, quadric, whole(solid)), 0u);
        EXPECT_EQ(differences(*context, fill, solid, Affine3{}, LatticeStreamKey{lattice, 0, 0.0},
                              std::nullopt, whole(solid)),
                  0u);
    }
}

}  // namespace
}  // namespace burl
