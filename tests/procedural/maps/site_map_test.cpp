// Site maps against the lattice maps that they rearrange, and single texels against whole pictures.
#include "procedural/maps/site_map.h"

#include <bit>
#include <set>

#include <gtest/gtest.h>

#include "procedural/fill/pieces.h"
#include "procedural/fill/sparse.h"
#include "procedural/fill/synthesize.h"
#include "procedural/maps/lattice_map.h"
#include "procedural/numbers/lattice_hash.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

Texture site_map_texture_of(NoiseKind kind) {
    Texture texture;
    texture.quadric = {0.5, 0, 0.25, 1, -0.75, 0, 2, 0.5, -1, 0.125};
    NoiseTerm term;
    term.kind = kind, term.octaves = 3, term.frequency = Vec3d(7.0, 3.0, 5.0);
    texture.noise.push_back(term);
    texture.colors.stops = {{0.0, {255, 0, 0}}, {0.5, {0, 255, 0}}, {1.0, {255, 0, 0}}};
    return texture;
}

SolidAtlas site_map_atlas_of(std::uint32_t size) {
    SyntheticAtlas atlas;
    atlas.size = size, atlas.block = 13;
    return atlas.make(4);
}

TEST(SiteOrderTest, HasAPlaceForEveryTexel) {
    const SiteOrder order(70, 65);
    EXPECT_EQ(order.texels(), 4u * 4096u);
    std::set<std::size_t> places;
    for (std::uint32_t y = 0; y < 65; ++y)
        for (std::uint32_t x = 0; x < 70; ++x) places.insert(order(x, y));
    EXPECT_EQ(places.size(), 70u * 65u);
    EXPECT_LT(*places.rbegin(), order.texels());
    EXPECT_EQ(order(5, 0), 17u);  // blocks of 4 x 4
    EXPECT_EQ(order(64, 2), 4096u + 8u);
}

TEST(SiteMapTest, HoldsTheLatticeMapsNumbers) {
    const SolidAtlas solid = site_map_atlas_of(80);
    const Texture texture = site_map_texture_of(NoiseKind::value);
    const auto index = fixed_index(texture);
    ASSERT_TRUE(index);
    const LatticeStreamKey key = stream_key(index->groups[0]);
    const TexelArea area{3, 5, 75, 60};
    const LatticeMap map = fill_lattice_map(solid, solid.maps, key, texture.quadric, area, 1);
    const auto sites = fill_site_map(solid, solid.maps, key, area, 0);
    const auto bases = fill_base_map(solid, solid.maps, texture.quadric, *index, area, 0);
    ASSERT_TRUE(bases);
    const SiteOrder order(area.width, area.height);
    std::size_t gaps = 0;
    for (std::uint32_t y = 0; y < area.height; ++y)
        for (std::uint32_t x = 0; x < area.width; ++x) {
            const MapTexel &cell = map.cells(x, y), &place = map.places(x, y);
            const MapTexel& site = sites[order(x, y)];
            ASSERT_EQ(glm::uvec3(site.y, site.z, site.w), glm::uvec3(place));
            // Before it is mixed the hash of a corner is this.
            ASSERT_EQ(LatticeHash::mix(site.x), LatticeHash::bits(cell.x, cell.y, cell.z, 0));
            const std::uint32_t base = (*bases)[order(x, y)];
            const std::uint64_t q = std::uint64_t(cell.w) << 32 | place.w;
            gaps += base == no_base ? 1 : 0;
            ASSERT_EQ(base == no_base, q == no_quadric);
            if (base == no_base) continue;
            ASSERT_EQ(base, *fixed_base(*index, std::bit_cast<double>(q)));
        }
    EXPECT_GT(gaps, 0u);
    EXPECT_LT(gaps, std::size_t(area.width) * area.height);
}

class SparseTexelsOf : public testing::TestWithParam<NoiseKind> {};
INSTANTIATE_TEST_SUITE_P(Noises, SparseTexelsOf,
                         testing::Values(NoiseKind::value, NoiseKind::perlin, NoiseKind::worley));

TEST_P(SparseTexelsOf, AreThoseOfTheWholePicture) {
    const SolidAtlas solid = site_map_atlas_of(64);
    const Texture texture = site_map_texture_of(GetParam());
    const Affine3 move{Mat3d(0.75), Vec3d(0.25, -1, 3)};
    const Image<Rgb8> whole = synthesize_rgb8(solid, texture, move, 1, {}, Kernel::direct);
    std::vector<glm::uvec2> texels;
    for (std::uint32_t i = 0; i < 64 * 64; i += 3) texels.emplace_back(i % 64, i / 64);
    Image<Rgb8> image(64, 64);
    synthesize_sparse(solid, moved_maps(solid.maps, move, 1), texture, ColorTable8(texture.colors),
                      texels, image);
    for (const glm::uvec2& at : texels) ASSERT_EQ(image(at.x, at.y), whole(at.x, at.y));
    EXPECT_EQ(image(1, 0), Rgb8{});
}

}  // namespace
}  // namespace burl
