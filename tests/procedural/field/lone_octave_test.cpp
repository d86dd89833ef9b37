// A lone octave has the bits of the same octave by streams.
#include "procedural/field/lone_octave.h"

#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/procedural/support/random_batch.h"

namespace burl {
namespace {

/// Spans of 1 to 40 texels near the origin; the batch begins within the first and ends within the
/// last.
struct RandomSpans {
    std::array<std::vector<double>, 6> numbers;
    std::vector<std::uint32_t> counts;
    std::vector<double> before = std::vector<double>(batch_capacity + batch_padding, -0.0);
    SpanLines lines;

    RandomSpans(std::mt19937& random, double reach) {
        std::size_t texels = 0;
        while (texels < batch_capacity + 5) {
            counts.push_back(6 + std::uint32_t(random() % 40));
            texels += counts.back();
            const Vec3d start = test::random_vector(random, reach);
            const Vec3d step = test::random_vector(random, std::ldexp(1.0, -int(random() % 8)));
            for (int axis = 0; axis < 3; ++axis) {
                numbers[std::size_t(axis)].push_back(start[axis]);
                numbers[std::size_t(axis + 3)].push_back(step[axis]);
            }
        }
        lines.spans = counts.size();
        for (auto& array : numbers) array.resize(lines.spans + span_padding);
        counts.resize(lines.spans + span_padding);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            lines.start[axis] = numbers[axis].data();
            lines.step[axis] = numbers[axis + 3].data();
        }
        lines.counts = counts.data();
        lines.first = 5, lines.texels = batch_capacity;
        for (std::size_t j = 0; j < before.size(); j += 2) before[j] = 1.0 / double(j + 1);
        lines.needed = before.data();
    }
};

const Affine3 oblique{Mat3d(1.5, 0.25, 0, -0.75, 2, 0.5, 0, 0.125, 1), Vec3d(0.3, -7.0, 100.0)};

TEST(LoneOctave, HasTheBitsOfStreams) {
    std::mt19937 random(11);
    const auto stream = std::make_unique<LatticeStream>();
    for (int i = 0; i < 5; ++i) {
        const RandomSpans spans(random, 30.0);
        for (const auto& [kind, fade] : test::shared_noises) {
            const double scale = 0.7 * stream_unit(kind);
            alignas(64) float sums[batch_capacity + batch_padding] = {};
            std::vector<double> expected(batch_capacity + batch_padding), values = expected;
            fill_stream(oblique, 0, spans.lines, *stream);
            add_octave_direct(kind, fade, {77, 0, 1.0f}, *stream, batch_capacity, sums);
            add_sums_to(spans.lines.needed, scale, sums, batch_capacity, expected.data());
            ASSERT_TRUE(
                add_lone_octave({kind, fade, 77, oblique, scale}, spans.lines, values.data()));
            for (std::size_t j = 0; j < batch_capacity; ++j) {
                ASSERT_EQ(values[j], expected[j]) << j;
                ASSERT_EQ(std::signbit(values[j]), std::signbit(expected[j])) << j;
            }
        }
    }
}

TEST(LoneOctave, IsNotForLinesFarAway) {
    std::mt19937 random(12);
    std::vector<double> values(batch_capacity + batch_padding);
    for (const double far : {1e7, 1e300}) {
        const RandomSpans spans(random, far);
        EXPECT_FALSE(add_lone_octave({NoiseKind::value, Fade::smooth, 1, oblique, 1.0}, spans.lines,
                                     values.data()));
    }
}

TEST(LoneOctave, KnowsHowManyPlanesItsLinesCross) {
    std::mt19937 random(13);
    const auto stream = std::make_unique<LatticeStream>();
    RandomSpans spans(random, 30.0);
    spans.lines.first = 0;
    for (std::size_t i = spans.lines.texels = 0; i < 16; ++i) spans.lines.texels += spans.counts[i];
    spans.lines.spans = 16;
    const double planes = fill_stream(oblique, 0, spans.lines, *stream);
    EXPECT_NEAR(crossings_per_texel(oblique, spans.lines) * double(spans.lines.texels), planes,
                1e-9 * planes);
}

}  // namespace
}  // namespace burl
