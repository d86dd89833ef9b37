// Point maps hold the places at which octaves without a stream are evaluated; solid maps every
// texel's point and owner.
#include "procedural/maps/point_map.h"

#include <bit>
#include <cmath>

#include <gtest/gtest.h>

#include "procedural/fill/pieces.h"
#include "procedural/fill/synthesize.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

TexelArea whole(const SolidAtlas& solid) {
    return {0, 0, solid.size, solid.size};
}

double number(std::uint32_t lower, std::uint32_t upper) {
    return std::bit_cast<double>(std::uint64_t(upper) << 32 | lower);
}

Vec3d point_at(const PointMap& map, std::size_t x, std::size_t y) {
    const MapTexel xy = map.xy(x, y), z = map.z_owner(x, y);
    return {number(xy.x, xy.y), number(xy.z, xy.w), number(z.x, z.y)};
}

std::size_t texels_of(const SolidAtlas& solid) {
    std::size_t count = 0;
    for (const Span& span : solid.spans) count += span.count;
    return count;
}

TEST(PointMap, GivesTheHostsFieldOfOctavesWithoutStreams) {
    for (const double frequency : {3.0, 1e7, 2e15}) {
        const SolidAtlas solid = SyntheticAtlas{}.make(5);
        Texture texture;
        NoiseTerm term;
        term.kind = NoiseKind::worley;
        term.frequency = Vec3d(frequency, 2.0 * frequency, 0.5 * frequency);
        texture.noise.push_back(term);
        const std::vector<Octave> octaves = expand_octaves(texture);
        ASSERT_EQ(octaves.size(), 1u);
        const Affine3 move{Mat3d(0.75), Vec3d(0.25, -1, 3)};
        const PointMap map = fill_point_map(solid, moved_maps(solid.maps, move, 1),
                                            octaves[0].lattice_from_solid, true, whole(solid), 2);
        const Image<float> field = synthesize_field(solid, texture, move, 1);
        for (std::size_t y = 0; y < solid.size; ++y)
            for (const Span& span : solid.row(y))
                for (std::size_t x = span.x; x < span.x + span.count; ++x) {
                    const Vec3d p = point_at(map, x, y);
                    const float n = noise_value<float, 3>(octaves[0].noise, {p.x, p.y, p.z});
                    const double f = octaves[0].offset + octaves[0].scale * double(n);
                    ASSERT_EQ(float(f), field(x, y)) << frequency << ' ' << x << ' ' << y;
                    ASSERT_EQ(map.z_owner(x, y).z, span.map);
                }
    }
}

TEST(PointMap, MarksGapsAndCutsParts) {
    const SolidAtlas solid = SyntheticAtlas{}.make(5);
    const Affine3 map{Mat3d(2.0), Vec3d(1.0)};
    const PointMap all = fill_point_map(solid, solid.maps, map, false, whole(solid), 1);
    std::size_t gaps = 0;
    for (std::size_t y = 0; y < solid.size; ++y)
        for (std::size_t x = 0; x < solid.size; ++x) {
            const bool gap = all.z_owner(x, y).z == no_owner;
            EXPECT_EQ(gap, std::isnan(point_at(all, x, y).x));
            gaps += gap;
        }
    EXPECT_EQ(gaps, std::size_t(solid.size) * solid.size - texels_of(solid));
    EXPECT_GT(gaps, 0u);
    const PointMap part = fill_point_map(solid, solid.maps, map, false, {7, 9, 31, 20}, 1);
    for (std::size_t y = 0; y < 20; ++y)
        for (std::size_t x = 0; x < 31; ++x) {
            ASSERT_EQ(part.xy(x, y), all.xy(x + 7, y + 9));
            ASSERT_EQ(part.z_owner(x, y), all.z_owner(x + 7, y + 9));
        }
}

TEST(SolidMap, HoldsEveryTexelsPointAndOwnerWhereverTheSolidLies) {
    for (const double offset : {0.0, 1e6}) {
        SyntheticAtlas atlas;
        atlas.offset = offset;
        const SolidAtlas solid = atlas.make(11);
        const Affine3 map{Mat3d(0.5, 0, 0.1, 0, 0.25, 0, 0, 0, -0.5), Vec3d(1, 2, 3)};
        const Vec3d base = solid_base(solid, map);
        const SolidMap local = fill_solid_map(solid, map, base, whole(solid), 1);
        std::size_t owned = 0;
        for (std::size_t y = 0; y < solid.size; ++y)
            for (const Span& span : solid.row(y))
                for (std::size_t x = span.x; x < span.x + span.count; ++x) {
                    const Vec3d p = map(solid.maps[span.map](std::int64_t(x), std::int64_t(y)));
                    const Vec4f& texel = local.local(x, y);
                    for (int axis = 0; axis < 3; ++axis)
                        ASSERT_NEAR(base[axis] + double(texel[axis]), p[axis], 1e-7);
                    ASSERT_EQ(texel.w, 1.0f);
                    ASSERT_EQ(local.owners(x, y), span.map);
                    ++owned;
                }
        std::size_t gaps = 0;
        for (const std::uint32_t owner : local.owners.pixels()) gaps += owner == no_owner;
        EXPECT_EQ(owned + gaps, local.owners.pixels().size());
        EXPECT_GT(gaps, 0u);
    }
}

}  // namespace
}  // namespace burl
