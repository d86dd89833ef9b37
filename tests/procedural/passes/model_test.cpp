// Multipass noise on the host: against noise in float64, and the histograms that the papers tell
// of.
#include "tests/procedural/passes/model.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "procedural/noise/noise.h"
#include "procedural/noise/value_noise.h"

namespace burl {
namespace {

constexpr std::size_t side = 64;
const Affine3 oblique{Mat3d(0.17, 0.031, -0.05, -0.027, 0.21, 0.013, 0, 0, 1),
                      Vec3d(-4.3, 0.2, 2.7)};
const LatticeBox oblique_box{Vec3d(-6.1, 0.0, -0.7), Vec3d(6.8, 15.9, 3.9)};

MultipassOctave octave_of(Fade fade, std::uint32_t seed, int doublings, double scale) {
    MultipassOctave octave;
    octave.fade = fade, octave.seed = seed, octave.doublings = doublings, octave.scale = scale;
    octave.bits = lattice_bits(oblique_box, doublings);
    return octave;
}

Vec3d point_of(std::size_t texel) {
    return oblique({double(texel % side) + 0.5, double(texel / side) + 0.5, 0.0});
}

double noise_at(const MultipassOctave& octave, const Vec3d& p) {
    NoiseSpec spec;
    spec.fade = octave.fade, spec.seed = octave.seed;
    const double size = std::ldexp(1.0, octave.doublings);
    return noise_value<double, 3>(spec, {size * p.x, size * p.y, size * p.z});
}

/// Runs a plan over the oblique slice.
struct Slice {
    LatticeMap map = lattice_slice(side, side, oblique);
    MultipassPlan plan;
    MultipassModel model;
    Slice(const MultipassOptions& options, const std::vector<MultipassOctave>& octaves,
          Wrap wrap = Wrap::repeat, HalfRounding rounding = HalfRounding::nearest_even)
        : plan(plan_multipass(options, octaves, 0.25, wrap)), model(plan, {&map, 1}, rounding) {
        model.run();
    }
};

double distance_modulo_one(double a, double b) {
    const double d = std::abs(a - b);
    return std::min(d, 1.0 - d);
}

TEST(Multipass, Float32AgreesWithTheField) {
    for (const Fade fade : {Fade::linear, Fade::smooth}) {
        const std::vector octaves{octave_of(fade, 3, 2, -0.125), octave_of(fade, 2, 1, 0.25),
                                  octave_of(fade, 1, 0, 0.5)};
        const Slice run({}, octaves);
        const auto& index = run.model.image(PassImage::index);
        for (std::size_t i = 0; i < index.size(); ++i) {
            double f = 0.25;
            for (const MultipassOctave& octave : octaves)
                f += octave.scale * noise_at(octave, point_of(i));
            ASSERT_LE(distance_modulo_one(double(index[i][0]), f - std::floor(f)), 5e-7) << i;
        }
    }
}

TEST(Multipass, HashesAreTheHostsLatticeValues) {
    const MultipassOctave octave = octave_of(Fade::smooth, 7, 1, 1.0);
    const LatticeMap map = lattice_slice(side, side, oblique);
    const MultipassPlan plan = plan_multipass({}, {&octave, 1}, 0.0, Wrap::repeat);
    MultipassModel model(plan, {&map, 1});
    unsigned corner = 0;
    for (const Pass& pass : plan.passes) {
        model.run({&pass, 1});
        if (pass.kind != PassKind::hash) continue;
        for (std::size_t i = 0; i < side * side; ++i) {
            const Vec3d p = 2.0 * point_of(i);
            const auto cell = [&](int axis) {
                return std::uint32_t(std::int64_t(std::floor(p[axis]))) + (corner >> axis & 1);
            };
            ASSERT_EQ(double(model.image(PassImage::corner)[i][0]),
                      lattice_value(cell(0), cell(1), cell(2), 7));
        }
        ++corner;
    }
    EXPECT_EQ(corner, 8u);
}

/// A plan's 8-bit noise at p from 0 to 255: the host's lattice values at the weights that its
/// fractions stand for.
double fixed_noise_at(const MultipassOctave& octave, const Vec3d& p) {
    const double parts = std::ldexp(1.0, int(octave.bits.fraction()));
    double sum = 0.0;
    for (unsigned corner = 0; corner < 8; ++corner) {
        double weight = 1.0;
        std::array<std::uint32_t, 3> index;
        for (int axis = 0; axis < 3; ++axis) {
            const double x = std::ldexp(p[axis], octave.doublings), cell = std::floor(x);
            double w = std::floor((x - cell) * parts) / (parts - 1.0);
            if (octave.fade == Fade::smooth) w = w * w * (3.0 - 2.0 * w);
            const bool upper = (corner >> axis & 1) != 0;
            weight *= upper ? w : 1.0 - w;
            index[std::size_t(axis)] = std::uint32_t(std::int64_t(cell)) + (upper ? 1 : 0);
        }
        sum += weight * 0.5 * (1.0 + lattice_value(index, octave.seed));
    }
    return 255.0 * sum;
}

TEST(Multipass, EightBitsAreTheNoiseOfTheirFractions) {
    for (const Fade fade : {Fade::linear, Fade::smooth}) {
        const MultipassOctave octave = octave_of(fade, 5, 0, 1.0);
        ASSERT_EQ(octave.bits.integer, 4u);
        const Slice run({PassPrecision::fixed8, Randomizer::hash}, {octave});
        const auto& noise = run.model.image(PassImage::noise);
        double squares = 0.0;
        for (std::size_t i = 0; i < noise.size(); ++i) {
            const double error = double(noise[i][0]) - fixed_noise_at(octave, point_of(i));
            squares += error * error;
            // A lattice value is cut to 8 bits, and half a unit lost with each of a corner's three
            // weights, the first two halves weighted: (8 + 4 + 2) / 2 in all. The S-curve is a
            // multiple of 4 besides.
            ASSERT_LE(std::abs(error), fade == Fade::linear ? 8.0 : 20.0) << i;
        }
        EXPECT_LE(std::sqrt(squares / double(noise.size())), fade == Fade::linear ? 1.0 : 1.2);
    }
}

TEST(Multipass, HalfFloatsAreNearTheField) {
    const std::vector octaves{octave_of(Fade::smooth, 2, 1, 0.25),
                              octave_of(Fade::smooth, 1, 0, 0.5)};
    const Slice exact({}, octaves);
    for (const HalfRounding rounding : {HalfRounding::nearest_even, HalfRounding::toward_zero}) {
        const Slice run({PassPrecision::float16, Randomizer::hash}, octaves, Wrap::repeat,
                        rounding);
        double largest = 0.0;
        for (std::size_t i = 0; i < side * side; ++i)
            largest = std::max(
                largest, distance_modulo_one(double(run.model.image(PassImage::index)[i][0]),
                                             double(exact.model.image(PassImage::index)[i][0])));
        EXPECT_LE(largest, rounding == HalfRounding::nearest_even ? 0.0025 : 0.005);
        EXPECT_GT(largest, 0.0002) << "nothing was rounded";
    }
}

/// Numbers of a corner at the points of a block of the lattice, -1 to 1.
std::vector<double> corner_numbers(const MultipassOptions& options) {
    constexpr std::size_t width = 16;
    std::vector<double> numbers;
    for (std::uint32_t seed = 0; seed < 4; ++seed)
        for (std::size_t z = 0; z < width; ++z) {
            const LatticeMap map =
                lattice_slice(width, width, {Mat3d(1.0), Vec3d(0.0, 0.0, double(z) + 0.5)});
            MultipassOctave octave;
            octave.seed = seed;
            const MultipassPlan plan = plan_multipass(options, {&octave, 1}, 0.0, Wrap::repeat);
            MultipassModel model(plan, {&map, 1});
            for (const Pass& pass : plan.passes) {
                if (pass.kind == PassKind::weigh) break;
                model.run({&pass, 1});
            }
            for (const PassTexel& texel : model.image(PassImage::corner))
                numbers.push_back(options.precision == PassPrecision::fixed8
                                      ? double(texel[0]) / 127.5 - 1.0
                                      : double(texel[0]));
        }
    return numbers;
}

struct Moments {
    double mean = 0.0, variance = 0.0, kurtosis = 0.0;
};

Moments moments_of(const std::vector<double>& numbers) {
    Moments m;
    const double n = double(numbers.size());
    for (const double x : numbers) m.mean += x / n;
    for (const double x : numbers) m.variance += (x - m.mean) * (x - m.mean) / n;
    for (const double x : numbers) m.kurtosis += std::pow(x - m.mean, 4) / n;
    m.kurtosis /= m.variance * m.variance;
    return m;
}

/// Largest difference of the distribution from the uniform one.
double distance_from_white(std::vector<double> numbers) {
    std::ranges::sort(numbers);
    double largest = 0.0;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        largest = std::max(largest, std::abs(0.5 * (numbers[i] + 1.0) -
                                             (double(i) + 0.5) / double(numbers.size())));
    return largest;
}

TEST(Multipass, NumbersOfHashesAndTablesAreWhite) {
    EXPECT_LE(distance_from_white(corner_numbers({})), 0.015);
    EXPECT_LE(distance_from_white(corner_numbers({PassPrecision::fixed8, Randomizer::hash})),
              0.015);
    for (const PassPrecision precision : {PassPrecision::float32, PassPrecision::fixed8}) {
        const std::vector<double> numbers = corner_numbers({precision, Randomizer::table});
        EXPECT_LE(distance_from_white(numbers), 0.06);
        EXPECT_NEAR(moments_of(numbers).variance, 1.0 / 3.0, 0.03);
    }
}

TEST(Multipass, NumbersOfBitsAreGaussianUnlessEqualized) {
    const Moments gaussian = moments_of(corner_numbers({PassPrecision::fixed8, Randomizer::bits}));
    EXPECT_LT(gaussian.variance, 0.1);
    EXPECT_GT(gaussian.kurtosis, 2.2);
    EXPECT_LT(gaussian.kurtosis, 3.8);
    const std::vector<double> white =
        corner_numbers({PassPrecision::fixed8, Randomizer::bits, true});
    EXPECT_LE(distance_from_white(white), 0.03);
    EXPECT_NEAR(moments_of(white).variance, 1.0 / 3.0, 0.02);
}

TEST(Multipass, BitsGiveWhatTheRandomizerSays) {
    MultipassOctave octave = octave_of(Fade::smooth, 9, 0, 1.0);
    const LatticeMap map = lattice_slice(side, side, oblique);
    const MultipassPlan plan =
        plan_multipass({PassPrecision::fixed8, Randomizer::bits}, {&octave, 1}, 0.0, Wrap::repeat);
    MultipassModel model(plan, {&map, 1});
    const BitRandomizer randomizer = bit_randomizer(9, octave.bits.integer);
    unsigned weighed = 0;
    for (const Pass& pass : plan.passes) {
        if (pass.kind == PassKind::weigh && weighed++ % 3 == 0)
            for (std::size_t i = 0; i < side * side; ++i) {
                const Vec3d p = point_of(i);
                std::array<std::uint32_t, 3> cell;
                for (unsigned axis = 0; axis < 3; ++axis)
                    cell[axis] = (std::uint32_t(std::int64_t(std::floor(p[int(axis)]))) -
                                  octave.bits.base[axis] + (weighed / 3 >> axis & 1)) &
                                 15;
                ASSERT_EQ(model.image(PassImage::corner)[i][0], float(randomizer(cell)));
            }
        model.run({&pass, 1});
    }
    EXPECT_EQ(weighed, 24u);
}

TEST(Multipass, InterpolationNarrowsTheHistogram) {
    const Affine3 wide{Mat3d(3.7, 0.4, 0.3, -0.6, 4.1, 0.9, 0, 0, 1), Vec3d(0.0)};
    const LatticeMap map = lattice_slice(256, 64, wide);
    const MultipassOctave octave = octave_of(Fade::smooth, 1, 0, 1.0);
    const MultipassPlan plan = plan_multipass({}, {&octave, 1}, 0.0, Wrap::repeat);
    MultipassModel model(plan, {&map, 1});
    model.run();
    std::vector<double> numbers;
    for (const PassTexel& texel : model.image(PassImage::noise))
        numbers.push_back(double(texel[0]));
    // Per axis the mean of w^2 + (1-w)^2 is 26/35.
    EXPECT_NEAR(moments_of(numbers).variance, std::pow(26.0 / 35.0, 3) / 3.0, 0.01);
}

std::size_t passes_of(PassPrecision precision, Randomizer randomizer, Fade fade) {
    MultipassOctave octave;
    octave.fade = fade;
    return passes_of_octave({precision, randomizer}, octave);
}

TEST(Multipass, PassesAreAsDocumented) {
    using enum PassPrecision;
    EXPECT_EQ(passes_of(float32, Randomizer::hash, Fade::linear), 59u);
    EXPECT_EQ(passes_of(float32, Randomizer::hash, Fade::smooth), 63u) << "four extra passes";
    EXPECT_EQ(passes_of(float32, Randomizer::table, Fade::linear), 91u);
    EXPECT_EQ(passes_of(fixed8, Randomizer::hash, Fade::linear), 62u);
    EXPECT_EQ(passes_of(fixed8, Randomizer::table, Fade::linear), 94u);
    EXPECT_EQ(passes_of(fixed8, Randomizer::bits, Fade::linear), 360u);
}

TEST(Multipass, PassesOfTheRegisterCombiners) {
    const MultipassOctave octave;
    const MultipassPlan plan =
        plan_multipass({PassPrecision::fixed8, Randomizer::bits}, {&octave, 1}, 0, {});
    const auto count = [&](PassKind kind, PassImage target) {
        return std::ranges::count_if(plan.passes, [&](const Pass& pass) {
            return pass.kind == kind && pass.target == target;
        });
    };
    using enum PassImage;
    EXPECT_EQ(count(PassKind::blend_bit, mixed), 8 * 12);
    EXPECT_EQ(count(PassKind::shift_left, part_s) + count(PassKind::shift_left, part_t) +
                  count(PassKind::shift_left, part_r),
              8 * 9);
    EXPECT_EQ(count(PassKind::blend_bit, corner), 8 * 8);
    EXPECT_EQ(count(PassKind::shift_left, mixed), 8 * 7);
}

TEST(LatticeBits, HoldTheRange) {
    const LatticeBox paper{Vec3d(0.0), Vec3d(15.9375, 15.9375, 0.0)};
    EXPECT_EQ(lattice_bits(paper, 0).integer, 4u);
    EXPECT_EQ(lattice_bits(paper, 1).integer, 5u);
    EXPECT_FALSE(lattice_bits(paper, 3).repeats);
    EXPECT_TRUE(lattice_bits(paper, 4).repeats);
    EXPECT_EQ(lattice_bits(paper, 9).integer, 7u) << "of more cells than 128";
    EXPECT_EQ(lattice_bits({Vec3d(0.25), Vec3d(0.5)}, 0).integer, 1u);
    const LatticeBits below = lattice_bits({Vec3d(-3.5, 7.0, 0.0), Vec3d(4.0, 7.0, 0.0)}, 0);
    EXPECT_EQ(below.integer, 4u) << "nine cells";
    EXPECT_EQ(below.base, (std::array<std::uint32_t, 3>{0u - 4u, 7u, 0u}));
    const double nan = std::nan("");
    EXPECT_EQ(lattice_bits({Vec3d(nan), Vec3d(1e300)}, 0).integer, 1u);
}

TEST(HalfFloat, IsTheNeighbourAsked) {
    for (std::uint32_t half = 0; half < 0x7bff; ++half) {  // every positive one but the last
        const std::uint32_t exponent = half >> 10, fraction = half & 1023;
        const double spacing = std::ldexp(1.0, int(std::max(exponent, 1u)) - 25);
        const double low =
            exponent == 0 ? fraction * spacing : (1024.0 + double(fraction)) * spacing;
        const auto nearest = [](double x) {
            return double(half_rounded(float(x), HalfRounding::nearest_even));
        };
        ASSERT_EQ(nearest(low), low);
        ASSERT_EQ(nearest(low + 0.375 * spacing), low);
        ASSERT_EQ(nearest(low + 0.5 * spacing), half % 2 == 0 ? low : low + spacing);
        ASSERT_EQ(nearest(-(low + 0.625 * spacing)), -(low + spacing));
        ASSERT_EQ(double(half_rounded(float(low + 0.875 * spacing), HalfRounding::toward_zero)),
                  low);
    }
}

TEST(Multipass, SaysWhatItHasNoFormFor) {
    NoiseTerm term;
    const auto problem = [&](const MultipassOptions& options) {
        Texture texture;
        texture.noise = {term};
        return no_multipass_form(expand_octaves(texture), options);
    };
    EXPECT_EQ(problem({}), "");
    EXPECT_NE(problem({PassPrecision::float32, Randomizer::bits}), "");
    EXPECT_NE(problem({PassPrecision::fixed8, Randomizer::table, true}), "");
    EXPECT_EQ(problem({PassPrecision::fixed8, Randomizer::bits, true}), "");
    term.fade = Fade::quintic;
    EXPECT_NE(problem({}), "");
    term = {};
    term.kind = NoiseKind::perlin;
    EXPECT_NE(problem({}), "");
    term = {};
    term.shape = OctaveShape::ridged;
    EXPECT_NE(problem({}), "");
}

}  // namespace
}  // namespace burl
