// The simplex kernel against float64: anywhere, on the borders of simplices, with both radii.
#include "procedural/kernels/simplex_kernel.h"

#include <memory>
#include <random>

#include <gtest/gtest.h>

#include "procedural/field/octave_streams.h"
#include "procedural/noise/noise.h"
#include "procedural/noise/simplex_hash.h"

namespace burl {
namespace {

TEST(SimplexHashTables, GiveTheGradientsOfAllHashes) {
    for (std::uint32_t h = 0; h < 64; ++h) {
        const auto g = SimplexShape<3>::gradient<float>(h);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::uint32_t top = simplex_code(h) << 8 * axis & 0xff000000u;
            EXPECT_EQ(std::bit_cast<float>(top), 2.0f * g[axis]) << h;
        }
    }
}

TEST(SimplexHashTables, SumThePatternsOfAllBits) {
    std::mt19937 random(1);
    for (int n = 0; n < 2000; ++n) {
        std::array<std::uint32_t, 3> corner;
        for (std::uint32_t& i : corner) i = std::uint32_t(random() & 255);
        std::uint32_t sum = 0;
        for (std::size_t bit = 0; bit < 8; ++bit) {
            std::size_t pattern = 0;
            for (std::size_t axis = 0; axis < 3; ++axis)
                if (corner[axis] >> bit & 1)
                    pattern |= pattern_bits(axis, bit / 4)[std::size_t(1) << bit % 4];
            sum += pattern_table()[pattern];
        }
        EXPECT_EQ(sum, bit_pattern_sum(corner[0], corner[1], corner[2]));
    }
}

/// Multiples of 2^-bits, bits at most 29, within 384 cells of 0 after `doublings`.
void fill_randomly(std::mt19937_64& random, int bits, int doublings, LatticeStream& stream) {
    for (int axis = 0; axis < 3; ++axis)
        for (std::size_t j = 0; j < batch_capacity; ++j) {
            const std::int64_t cells = std::int64_t(random() % 768) - 384;
            const std::uint64_t place = random() >> (64 - bits) << (32 - bits);
            const auto x = std::int64_t(std::uint64_t(cells) << 32 | place);
            stream.set(axis, j, std::uint64_t(x >> doublings) >> 3 << 3);
        }
}

struct SimplexErrors {
    double value = 0.0;
    std::size_t borders = 0;  ///< texels that lie in the border of two simplices
};

/// At texels that are multiples of 2^-bits.
SimplexErrors largest_errors(double radius2, int bits, int batches) {
    const auto stream = std::make_unique<LatticeStream>();
    alignas(64) float sums[batch_capacity + batch_padding];
    std::mt19937_64 random(12);
    SimplexErrors worst;
    for (int i = 0; i < batches; ++i) {
        const int doublings = bits < 20 ? 0 : i % 4;
        fill_randomly(random, bits, doublings, *stream);
        const auto seed = std::uint32_t(i % 2 ? random() : 0);
        const NoiseSpec noise{.kind = NoiseKind::simplex, .radius2 = radius2, .seed = seed};
        std::fill(std::begin(sums), std::end(sums), 0.0f);
        simplex_kernel(false)({seed, doublings, 1.0f, radius2}, *stream, nullptr, batch_capacity,
                              sums, nullptr);
        for (std::size_t j = 0; j < batch_capacity; ++j) {
            Point<3> p;
            for (int axis = 0; axis < 3; ++axis)
                p[std::size_t(axis)] =
                    std::ldexp(double(std::int64_t(stream->at(axis, j))), doublings - 32);
            const double skewed = (4.0 * p[0] + p[1] + p[2]) / 3.0;
            worst.borders += p[0] - p[1] == std::round(p[0] - p[1]) || skewed == std::round(skewed);
            const double exact = sample_noise<double>(noise, p).value;
            const double n = double(sums[j]) * stream_unit(NoiseKind::simplex);
            worst.value = std::max(worst.value, std::abs(n - exact));
        }
    }
    return worst;
}

TEST(SimplexKernel, StaysWithinItsStatedError) {
    EXPECT_LT(largest_errors(0.6, 29, 100).value, 3e-7);
    EXPECT_LT(largest_errors(0.5, 29, 100).value, 1.2e-7);
}

TEST(SimplexKernel, PicksTheSimplexOfExactArithmeticOnBorders) {
    // There the noise of radius^2 0.6 jumps by up to 2e-3.
    for (const int bits : {1, 2, 3, 5}) {
        const SimplexErrors errors = largest_errors(0.6, bits, 20);
        EXPECT_LT(errors.value, 3e-7) << bits;
        EXPECT_GT(errors.borders, 300u) << bits;
    }
}

/// A texel, in units of 2^-29 cells, whose skewed coordinate along x, rounded down, lies `below`
/// units below a whole number; with others where no such x was found.
std::array<std::int64_t, 3> near_border(std::mt19937_64& random, std::int64_t below) {
    constexpr std::int64_t cell = std::int64_t(1) << 29;
    std::array<std::int64_t, 3> texel{};
    for (std::int64_t& x : texel) x = std::int64_t(random() % std::uint64_t(300 * cell));
    const auto skewed = [&](std::int64_t x) { return x + (x + texel[1] + texel[2]) / 3; };
    // Four thirds of a unit for each unit of x.
    const std::int64_t aim = (skewed(texel[0]) / cell + 1) * cell - below;
    texel[0] += (aim - skewed(texel[0])) * 3 / 4;
    while (skewed(texel[0]) < aim) ++texel[0];
    return skewed(texel[0]) == aim ? texel : near_border(random, below);
}

TEST(SimplexKernel, PicksTheSimplexOfExactArithmeticBesideBorders) {
    // A place that is off by a unit of 2^-29 cells lies in the next simplex.
    const auto stream = std::make_unique<LatticeStream>();
    std::mt19937_64 random(5);
    const NoiseSpec noise{.kind = NoiseKind::simplex, .radius2 = 0.6, .seed = 9};
    for (const std::int64_t below : {0, 1, 2}) {
        alignas(64) float sums[batch_capacity + batch_padding] = {};
        for (std::size_t j = 0; j < batch_capacity; ++j) {
            const auto texel = near_border(random, below);
            for (int axis = 0; axis < 3; ++axis)
                stream->set(axis, j, std::uint64_t(texel[(std::size_t(axis) + j) % 3]) << 3);
        }
        simplex_kernel(false)({9, 0, 1.0f, 0.6}, *stream, nullptr, batch_capacity, sums, nullptr);
        for (std::size_t j = 0; j < batch_capacity; ++j) {
            Point<3> p;
            for (int axis = 0; axis < 3; ++axis)
                p[std::size_t(axis)] = std::ldexp(double(std::int64_t(stream->at(axis, j))), -32);
            ASSERT_NEAR(double(sums[j]) * stream_unit(NoiseKind::simplex),
                        sample_noise<double>(noise, p).value, 3e-7)
                << below << " " << j;
        }
    }
}

TEST(SimplexKernel, GivesGradientsWithTheBitsOfValuesAlone) {
    const auto stream = std::make_unique<LatticeStream>();
    std::mt19937_64 random(13);
    for (int i = 0; i < 60; ++i) {
        alignas(64) float alone[batch_capacity + batch_padding] = {}, sums[std::size(alone)] = {};
        GradientSums gradients{};
        const int doublings = i % 3, bits = i % 4 == 3 ? 3 : 29;
        if (bits == 3 && doublings > 0) continue;
        fill_randomly(random, bits, doublings, *stream);
        const NoiseSpec noise{.kind = NoiseKind::simplex,
                              .radius2 = i % 2 ? 0.6 : 0.5,
                              .seed = std::uint32_t(random())};
        const StreamOctave octave{noise.seed, doublings, 1.0f, noise.radius2};
        simplex_kernel(false)(octave, *stream, nullptr, batch_capacity, alone, nullptr);
        simplex_kernel(true)(octave, *stream, nullptr, batch_capacity, sums, &gradients);
        for (std::size_t j = 0; j < batch_capacity; ++j) {
            Point<3> p;
            for (int axis = 0; axis < 3; ++axis)
                p[std::size_t(axis)] =
                    std::ldexp(double(std::int64_t(stream->at(axis, j))), doublings - 32);
            const auto exact = sample_noise<double>(noise, p);
            ASSERT_EQ(sums[j], alone[j]);
            for (std::size_t axis = 0; axis < 3; ++axis)
                ASSERT_NEAR(std::ldexp(double(gradients.along[axis][j]) * stream_unit(noise.kind),
                                       -doublings),
                            exact.gradient[axis], 2e-6);
        }
    }
}

TEST(SimplexKernel, CutsPlacesTo29Bits) {
    const auto stream = std::make_unique<LatticeStream>(), cut = std::make_unique<LatticeStream>();
    alignas(64) float sums[2][batch_capacity + batch_padding] = {};
    std::mt19937_64 random(3);
    fill_randomly(random, 29, 0, *cut);
    for (int axis = 0; axis < 3; ++axis)
        for (std::size_t j = 0; j < batch_capacity; ++j)
            stream->set(axis, j, cut->at(axis, j) | (random() & 7));
    simplex_kernel(false)({0, 0, 1.0f, 0.6}, *stream, nullptr, batch_capacity, sums[0], nullptr);
    simplex_kernel(false)({0, 0, 1.0f, 0.6}, *cut, nullptr, batch_capacity, sums[1], nullptr);
    for (std::size_t j = 0; j < batch_capacity; ++j) ASSERT_EQ(sums[0][j], sums[1][j]);
}

TEST(SimplexKernel, WeighsOctaves) {
    const auto stream = std::make_unique<LatticeStream>();
    alignas(64) float once[batch_capacity + batch_padding] = {}, twice[std::size(once)] = {};
    std::mt19937_64 random(4);
    fill_randomly(random, 29, 0, *stream);
    simplex_kernel(false)({3, 0, 1.0f, 0.6}, *stream, nullptr, 500, once, nullptr);
    simplex_kernel(false)({3, 0, 0.75f, 0.6}, *stream, nullptr, 500, twice, nullptr);
    simplex_kernel(false)({3, 0, -0.25f, 0.6}, *stream, nullptr, 500, twice, nullptr);
    for (std::size_t j = 0; j < 500; ++j) EXPECT_NEAR(twice[j], 0.5f * once[j], 1e-7);
}

/// Sums of octaves far and near, and with steps for which lines are worked out texel by texel.
TEST(SimplexOctaves, SumAsTheReferenceDoes) {
    const auto buffers = std::make_unique<StreamBuffers>();
    std::mt19937 random(8);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto vector = [&] { return Vec3d{unit(random), unit(random), unit(random)}; };
    for (int i = 0; i < 48; ++i) {
        Texture texture;
        NoiseTerm& term = texture.noise.emplace_back();
        term.kind = NoiseKind::simplex;
        term.radius2 = i % 2 ? 0.5 : 0.6;
        term.seed = std::uint32_t(random());
        term.octaves = i % 3 == 2 ? 24 : 4;
        const std::vector<Octave> octaves = expand_octaves(texture);
        double amplitudes = 0.0;
        for (const Octave& octave : octaves) amplitudes += std::abs(octave.scale);
        const double reach = std::ldexp(1.0, term.octaves > 4 ? 8 : i % 6 * 8),
                     step = i % 4 == 3 ? 1e4 : 0.1;
        Piece piece;
        piece.solid = {reach * vector(), step * vector(), 0.0, 100};
        piece.length = 100.0;
        std::vector<double> values(batch_capacity + batch_padding, 0.0);
        OctaveStreams(octaves, Kernel(i % 3)).add({&piece, 1}, 100, *buffers, values.data());
        const double size = reach + 100.0 * step;
        for (std::size_t j = 0; j < 100; ++j) {
            const double exact =
                evaluate_field({}, octaves, piece.solid.start + double(j) * piece.solid.step);
            const double bound = 2.5e-7 * (std::abs(exact) + amplitudes) +
                                 4.0 * 0x1p-52 * size * amplitudes * term.octaves;
            ASSERT_NEAR(values[j], exact, bound) << i << " " << j;
        }
    }
}

}  // namespace
}  // namespace burl
