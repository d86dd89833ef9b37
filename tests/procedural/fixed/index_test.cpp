// A colour map's index in fixed point against float64: how far it is off, and that a colour read
// with such an index is the map's wherever it is not left undecided.
#include "procedural/fixed/index.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "procedural/fixed/colors.h"

namespace burl {
namespace {

NoiseTerm term_of(NoiseKind kind, double amplitude, std::uint32_t octaves) {
    NoiseTerm term;
    term.kind = kind, term.amplitude = amplitude, term.octaves = octaves;
    return term;
}

Texture texture_of(Wrap wrap, std::vector<NoiseTerm> noise) {
    Texture texture;
    texture.noise = std::move(noise);
    texture.colors.wrap = wrap;
    texture.colors.stops = {{0.0, {0, 0, 0}}, {1.0, {255, 255, 255}}};
    return texture;
}

/// What shaders/maps/fixed_index.glsl does with a group's sum.
std::int32_t added(const FixedTerm& term, float sum) {
    const std::int64_t product = std::int64_t(sum * term.whole) * term.factor;
    return std::int32_t(std::uint32_t(product >> 32) << term.shift);
}

/// Of index a - b, units modulo 2^32 where it repeats.
double difference(const FixedIndex& index, std::uint32_t a, double b) {
    if (!index.repeats) return double(std::int32_t(a)) - b;
    return std::remainder(double(a) - b, 0x1p32);
}

TEST(FixedIndexTest, IsOffByNoMoreThanItsError) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp})
        for (const double amplitude : {0.5, -0.3137, 1e-6}) {
            const Texture texture = texture_of(wrap, {term_of(NoiseKind::value, amplitude, 5),
                                                      term_of(NoiseKind::perlin, 0.2, 2)});
            const auto index = fixed_index(texture);
            ASSERT_TRUE(index);
            ASSERT_EQ(index->groups.size(), 2u);
            double offsets = 0.0, largest = 0.0;
            for (const Octave& octave : expand_octaves(texture)) offsets += octave.offset;
            for (int i = 0; i < 1000; ++i) {
                const double q = 3.0 * unit(random);
                double f = q + offsets;
                std::uint32_t fixed = *fixed_base(*index, q) + index->constant;
                for (std::size_t g = 0; g < 2; ++g) {
                    const OctaveGroup& group = index->groups[g];
                    double weights = 0.0;
                    for (const StreamOctave& octave : group.octaves)
                        weights += std::abs(double(octave.weight));
                    const double noise = weights * (g == 1 ? 2.0 : 1.0) * unit(random);
                    const auto sum = float(noise / stream_unit(group.kind));
                    f += group.scale * stream_unit(group.kind) * double(sum);
                    fixed += std::uint32_t(added(index->terms[g], sum));
                }
                const double exact = std::ldexp(f, index->fraction_bits);
                if (!index->repeats && (q < index->lowest || q > index->highest)) continue;
                largest = std::max(largest, std::abs(difference(*index, fixed, exact)));
            }
            EXPECT_LE(largest, index->error) << amplitude;
            EXPECT_GT(largest, 0.0);
        }
}

TEST(FixedIndexTest, QuadricsThatAloneDecideAClampedIndexKeepDeciding) {
    const auto index = fixed_index(texture_of(Wrap::clamp, {term_of(NoiseKind::value, 0.7, 3)}));
    ASSERT_TRUE(index);
    for (const double q : {-50000.0, 50000.0}) {
        const auto base = fixed_base(*index, q);
        ASSERT_TRUE(base);
        for (const float sum : {-0x1.cp34f, 0x1.cp34f}) {
            const auto fixed = std::int32_t(*base + index->constant) + added(index->terms[0], sum);
            EXPECT_EQ(fixed > 0, q > 0.0);
            EXPECT_GT(std::abs(double(fixed)), std::ldexp(0.999, index->fraction_bits));
        }
    }
}

TEST(FixedIndexTest, WhatHasNoHashOrNoPrecisionIsRefused) {
    const auto refused = [](const NoiseTerm& term) {
        return !fixed_index(texture_of(Wrap::repeat, {term}));
    };
    NoiseTerm timed = term_of(NoiseKind::value, 0.5, 1);
    timed.time = 1.5;
    EXPECT_TRUE(refused(term_of(NoiseKind::simplex, 0.5, 1)));
    EXPECT_TRUE(refused(term_of(NoiseKind::worley, 0.5, 1)));
    EXPECT_TRUE(refused(timed));
    EXPECT_TRUE(refused(term_of(NoiseKind::value, 1e5, 1)));
    EXPECT_FALSE(refused(term_of(NoiseKind::value, 0.5, 1)));
    const auto index = fixed_index(texture_of(Wrap::repeat, {}));
    ASSERT_TRUE(index);
    EXPECT_FALSE(fixed_base(*index, 1e9));
    EXPECT_FALSE(fixed_base(*index, std::nan("")));
    EXPECT_NE(*fixed_base(*index, 0.5), no_base);
}

std::uint32_t code_of(const Rgb8& color) {
    return std::uint32_t(color.r) | std::uint32_t(color.g) << 8 | std::uint32_t(color.b) << 16;
}

/// What shaders/maps/fixed_index.glsl finds for steps of the index; none: undecided.
std::optional<std::uint32_t> read(const FixedColors& colors, std::int64_t steps,
                                  std::uint32_t tolerance) {
    const glm::uvec4& entry = colors.entries[std::size_t(steps >> 15)];
    const std::uint32_t place = std::uint32_t(steps & 0x7fff) + FixedColors::margin;
    const std::uint32_t changes[] = {entry.w & 0xffff, entry.w >> 16};
    for (const std::uint32_t change : changes)
        if (place - change + tolerance <= 2 * tolerance) return std::nullopt;
    const std::uint32_t code = place >= changes[1]   ? entry.z
                               : place >= changes[0] ? entry.y
                                                     : entry.x;
    if (code >= undecided_code) return std::nullopt;
    return code;
}

class FixedColorsOf : public testing::TestWithParam<Wrap> {};
INSTANTIATE_TEST_SUITE_P(Wraps, FixedColorsOf, testing::Values(Wrap::repeat, Wrap::clamp));

TEST_P(FixedColorsOf, HoldWhatTheMapHasWhereTheyDecide) {
    ColorMap map{GetParam(),
                 {{0.0, {10, 20, 30}},
                  {0.3, {200, 30, 30}},
                  {0.3, {5, 5, 5}},
                  {0.7, {90, 255, 0}},
                  {1.0, {90, 255, 0}},
                  {1.0, {0, 0, 255}}}};
    const ColorTable8 table(map);
    const auto colors = fixed_colors(table);
    ASSERT_TRUE(colors);
    const bool repeats = GetParam() == Wrap::repeat;
    const double scale = std::ldexp(1.0, colors->step_bits());
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<double> places;
    for (int i = 0; i < 20000; ++i) places.push_back(unit(random));
    for (const ColorTable8::Step& step : table.steps())
        if (step.index <= 1.0)
            for (const double steps : {-9.0, -5.0, -1.0, 0.0, 1.0, 5.0, 9.0})
                places.push_back(step.index + steps / scale);
    if (!repeats) places.push_back(1.0 + 64.0 / scale);
    std::size_t undecided = 0, wrong = 0;
    for (const double t : places)
        for (const std::int64_t error : {-4, 0, 4}) {  // of an index that is off
            auto steps = std::int64_t(std::floor(t * scale)) + error;
            if (repeats)
                steps &= std::int64_t(scale) - 1;
            else
                steps = std::max<std::int64_t>(0, steps);
            const auto code = read(*colors, steps, 6);
            undecided += code ? 0 : 1;
            wrong += code && *code != code_of(table(t)) ? 1 : 0;
        }
    EXPECT_EQ(wrong, 0u);
    EXPECT_GT(undecided, 0u);
    EXPECT_LT(undecided, places.size());
}

TEST(FixedColorsTest, MapsThatChangeTooFastHaveNone) {
    ColorMap map{Wrap::clamp, {}};
    for (int i = 0; i < 400; ++i)
        map.stops.push_back({0.5 + 2.5e-5 * i, i % 2 == 0 ? Rgb8{0, 255, 7} : Rgb8{255, 0, 130}});
    EXPECT_FALSE(fixed_colors(ColorTable8(map)));
}

}  // namespace
}  // namespace burl
