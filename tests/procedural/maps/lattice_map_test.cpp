// Lattice maps hold the numbers host synthesis works with: noise evaluated from them is the host's
// field, bit for bit, and their coordinates are those of the points that texels show.
#include "procedural/maps/lattice_map.h"

#include <bit>
#include <cmath>
#include <memory>
#include <random>

#include <gtest/gtest.h>

#include "procedural/fill/pieces.h"
#include "procedural/fill/synthesize.h"
#include "procedural/kernels/simplex_kernel.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

const Quadric quadric{1.5, -2, 0.25, 3, -0.75, 1, 2, 0.5, -1, 7};

Texture texture_of(NoiseKind kind, double frequency) {
    Texture texture;
    texture.quadric = quadric;
    NoiseTerm term;
    term.kind = kind;
    term.seed = 5;
    term.octaves = 4;
    term.frequency = frequency * Vec3d(1.0, 0.5, 1.75);
    term.range = NoiseRange::bipolar;
    texture.noise.push_back(term);
    return texture;
}

double quadric_at(const LatticeMap& map, std::size_t x, std::size_t y) {
    return std::bit_cast<double>(std::uint64_t(map.cells(x, y).w) << 32 | map.places(x, y).w);
}

/// A row's field from its map, as a shader evaluates it.
std::vector<double> field_of(const LatticeMap& map, const OctaveGroup& group, std::size_t y) {
    const std::size_t count = map.cells.width();
    const auto stream = std::make_unique<LatticeStream>();
    alignas(64) float sums[batch_capacity + batch_padding] = {};
    std::vector<double> field(count);
    for (std::size_t x = 0; x < count; ++x) {
        for (int axis = 0; axis < 3; ++axis) {
            stream->cells[axis][x] = map.cells(x, y)[axis];
            stream->places[axis][x] = map.places(x, y)[axis];
        }
        field[x] = quadric_at(map, x, y);
    }
    for (std::size_t k = group.octaves.size(); k-- > 0;)
        if (group.kind == NoiseKind::simplex)
            simplex_kernel(false)(group.octaves[k], *stream, nullptr, count, sums, nullptr);
        else
            direct_kernel(group.kind, group.fade)(group.octaves[k], *stream, nullptr, count, sums,
                                                  nullptr);
    add_sums(group.scale * stream_unit(group.kind), sums, count, field.data());
    return field;
}

class LatticeMapOf : public testing::TestWithParam<NoiseKind> {};
INSTANTIATE_TEST_SUITE_P(Noises, LatticeMapOf,
                         testing::Values(NoiseKind::value, NoiseKind::perlin, NoiseKind::simplex));

TEST_P(LatticeMapOf, GivesTheHostsField) {
    const Affine3 move{Mat3d(0.75), Vec3d(0.25, -1, 3)};
    for (const double frequency : {0.75, 40.0, 1e7, 3e15}) {
        SyntheticAtlas atlas;
        atlas.block = 13;
        atlas.offset = frequency == 40.0 ? 1e6 : 0.0;
        const SolidAtlas solid = atlas.make(3);
        const Texture texture = texture_of(GetParam(), frequency);
        const std::vector<OctaveGroup> groups = group_octaves(expand_octaves(texture));
        ASSERT_EQ(groups.size(), 1u);
        const LatticeMap map =
            fill_lattice_map(solid, moved_maps(solid.maps, move, 1), stream_key(groups[0]),
                             texture.quadric, {0, 0, solid.size, solid.size}, 1);
        const Image<float> field = synthesize_field(solid, texture, move, 1, Kernel::direct);
        for (std::size_t y = 0; y < solid.size; ++y) {
            const std::vector<double> row = field_of(map, groups[0], y);
            for (const Span& span : solid.row(y))
                for (std::size_t x = span.x; x < span.x + span.count; ++x)
                    ASSERT_EQ(float(row[x]), field(x, y)) << frequency << ' ' << x << ' ' << y;
        }
    }
}

TEST(LatticeMap, HoldsThePlacesThatTexelsShow) {
    SyntheticAtlas atlas;
    atlas.offset = 1000.0;
    const SolidAtlas solid = atlas.make(8);
    const Affine3 lattice{Mat3d(7, 1, -2, 0, 5, 3, 1, 1, -6), Vec3d(3, -8, 0.5)};
    const LatticeMap map = fill_lattice_map(solid, solid.maps, LatticeStreamKey{lattice, 0, 0.0},
                                            quadric, {0, 0, solid.size, solid.size}, 2);
    for (std::size_t y = 0; y < solid.size; ++y)
        for (const Span& span : solid.row(y))
            for (std::size_t x = span.x; x < span.x + span.count; ++x) {
                const Vec3d s = solid.maps[span.map](std::int64_t(x), std::int64_t(y));
                const Vec3d p = lattice(s);
                for (int axis = 0; axis < 3; ++axis) {
                    const auto cell = std::int32_t(map.cells(x, y)[axis]);
                    const double place = std::ldexp(double(map.places(x, y)[axis]), -32);
                    ASSERT_NEAR(double(cell) + place, p[axis], 0x1p-32 + 1e-11);
                }
                const double q = evaluate_quadric(quadric, s);
                ASSERT_NEAR(quadric_at(map, x, y), q, 1e-12 * std::abs(q) + 1e-6);
            }
}

TEST(LatticeMap, MarksGaps) {
    const SolidAtlas solid = SyntheticAtlas{}.make(2);
    const LatticeMap map = fill_lattice_map(solid, solid.maps, std::nullopt, std::nullopt,
                                            {0, 0, solid.size, solid.size}, 1);
    std::size_t gaps = 0;
    for (std::size_t y = 0; y < solid.size; ++y) {
        std::vector<bool> owned(solid.size);
        for (const Span& span : solid.row(y))
            for (std::size_t x = span.x; x < span.x + span.count; ++x) owned[x] = true;
        for (std::size_t x = 0; x < solid.size; ++x) {
            const auto half = owned[x] ? 0u : std::uint32_t(no_quadric >> 32);
            ASSERT_EQ(map.cells(x, y), MapTexel(0, 0, 0, half));
            ASSERT_EQ(map.places(x, y), MapTexel(0));
            gaps += !owned[x];
        }
    }
    EXPECT_GT(gaps, 0u);
    EXPECT_TRUE(std::isnan(std::bit_cast<double>(no_quadric)));
}

TEST(LatticeMap, OfAPartIsThatPartOfTheWhole) {
    const SolidAtlas solid = SyntheticAtlas{}.make(4);
    const LatticeStreamKey stream{{Mat3d(9.0), Vec3d(1.0)}, 3, double(simplex_period)};
    const auto map_of = [&](const TexelArea& area, int threads) {
        return fill_lattice_map(solid, solid.maps, stream, quadric, area, threads);
    };
    const LatticeMap whole = map_of({0, 0, solid.size, solid.size}, 1);
    for (const TexelArea& area : {TexelArea{0, 17, 64, 9}, {5, 3, 40, 61}, {63, 63, 1, 1}})
        for (const int threads : {1, 2}) {
            const LatticeMap part = map_of(area, threads);
            ASSERT_EQ(part.cells.width(), area.width);
            ASSERT_EQ(part.places.height(), area.height);
            for (std::size_t y = 0; y < area.height; ++y)
                for (std::size_t x = 0; x < area.width; ++x) {
                    ASSERT_EQ(part.cells(x, y), whole.cells(area.x + x, area.y + y));
                    ASSERT_EQ(part.places(x, y), whole.places(area.x + x, area.y + y));
                }
        }
}

TEST(OctaveGroups, JoinOctavesThatDouble) {
    Texture texture = texture_of(NoiseKind::value, 2.0);
    texture.noise.push_back(texture.noise[0]);
    texture.noise[1].lacunarity = 2.5;
    texture.noise[1].octaves = 2;
    texture.noise.push_back(texture.noise[0]);
    texture.noise[2].kind = NoiseKind::worley;
    const std::vector<Octave> octaves = expand_octaves(texture);
    const std::vector<OctaveGroup> groups = group_octaves(octaves);
    ASSERT_EQ(groups.size(), 3u);
    ASSERT_EQ(groups[0].octaves.size(), 4u);
    EXPECT_EQ(groups[0].finest(), 3);
    EXPECT_EQ(groups[0].octaves[2].weight, 0.25f);
    EXPECT_EQ(groups[1].octaves.size(), 1u);
    EXPECT_EQ(groups[2].octaves.size(), 1u);
    EXPECT_EQ(groups[2].lattice_from_solid, octaves[5].lattice_from_solid);
    EXPECT_EQ(groups[0].period(), 0.0);
    texture.noise[0].kind = NoiseKind::simplex;
    EXPECT_EQ(group_octaves(expand_octaves(texture))[0].period(), double(simplex_period));
}

}  // namespace
}  // namespace burl
