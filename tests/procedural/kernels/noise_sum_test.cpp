#include "procedural/kernels/noise_sum.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "procedural/graph/value_program.h"
#include "procedural/noise/noise.h"
#include "procedural/numbers/simd_target.h"
#include "tests/procedural/support/only_target.h"

namespace burl {
namespace {

using Array = ValueProgram::Scratch::Array;

/// The sum in float64, by definition.
double defined(const NoiseSum& sum, const Vec3d& p) {
    double total = sum.offset;
    NoiseSpec noise = sum.noise;
    for (const SumOctave& octave : sum.octaves) {
        noise.seed = octave.seed;
        total += octave.weight * shaped(sum.shape, evaluate_noise(noise, octave.frequency * p));
    }
    return total;
}

struct Points {
    Array axes[3];
    Vec3d at(std::size_t j) const {
        return {axes[0].values[j], axes[1].values[j], axes[2].values[j]};
    }
    PointArrays arrays() const { return {axes[0].values, axes[1].values, axes[2].values}; }
};

/// Around the origin and far out, on lattice planes and beside them.
Points random_points(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    Points points;
    for (Array& axis : points.axes)
        for (double& x : axis.values) {
            const double part = unit(random);
            x = std::ldexp(part, int(random() % 30));
            if (random() % 8 == 0) x = std::nextafter(std::round(x), random() % 2 ? 1e9 : -1e9);
            if (random() % 16 == 0) x = std::round(x);
        }
    return points;
}

NoiseSum reference_sum_of(NoiseKind kind, OctaveShape shape, std::size_t octaves, double lacunarity,
                          double gain) {
    NoiseSum sum{{.kind = kind}, shape, {}, 0.125};
    double frequency = 0.7, weight = 1.0;
    for (std::size_t k = 0; k < octaves; ++k) {
        sum.octaves.push_back({std::uint32_t(11 + k), frequency, weight});
        frequency *= lacunarity;
        weight *= gain;
    }
    return sum;
}

double weights_of(const NoiseSum& sum) {
    double weights = 0.0;
    for (const SumOctave& octave : sum.octaves) weights += std::abs(octave.weight);
    return weights;
}

/// Largest error over its bound. Coordinates in float64 lose 2^-52 of their size, and noise grows
/// by at most 4 per cell.
double worst_share(const NoiseSum& sum, double bound) {
    std::mt19937 random(5);
    double worst = 0.0;
    for (int round = 0; round < 8; ++round) {
        const Points points = random_points(random);
        Array out;
        add_up(sum, points.arrays(), value_batch, out.values);
        for (std::size_t j = 0; j < value_batch; ++j) {
            double allowed = bound * weights_of(sum);
            for (const SumOctave& octave : sum.octaves)
                for (int axis = 0; axis < 3; ++axis)
                    allowed += 4 * 0x1p-52 *
                               std::abs(octave.weight * octave.frequency * points.at(j)[axis]);
            worst = std::max(worst, std::abs(out.values[j] - defined(sum, points.at(j))) / allowed);
        }
    }
    return worst;
}

TEST(NoiseSum, StaysWithinItsStatedError) {
    using enum NoiseKind;
    for (const NoiseKind kind : {value, perlin, perlin1985, perlin2002, simplex, worley, cell})
        for (const auto& [octaves, lacunarity, gain] : {std::tuple{1, 2.0, 0.5},
                                                        {8, 2.0, 0.5},
                                                        {12, 2.0, 0.9},
                                                        {5, 1.9, 0.6},
                                                        {24, 2.0, 0.5}})
            for (const OctaveShape shape : {OctaveShape::plain, OctaveShape::absolute}) {
                const bool table = kind == perlin1985 || kind == perlin2002;
                if (kind == cell && shape == OctaveShape::plain) continue;  // it jumps
                if (kind == simplex || kind == cell) continue;              // the former jumps, too
                const NoiseSum sum =
                    reference_sum_of(kind, shape, std::size_t(octaves), lacunarity, gain);
                EXPECT_LT(worst_share(sum, table ? 8e-7 : 5e-7), 1.0)
                    << int(kind) << " " << octaves << " " << int(shape);
            }
}

TEST(NoiseSum, RidgesErrByTwiceAsMuch) {
    for (const NoiseKind kind : {NoiseKind::value, NoiseKind::perlin})
        EXPECT_LT(worst_share(reference_sum_of(kind, OctaveShape::ridged, 6, 2.0, 0.5), 1e-6), 1.0);
}

TEST(NoiseSum, FadesOfValueNoiseAreTheirOwn) {
    for (const Fade fade : {Fade::linear, Fade::smooth, Fade::quintic}) {
        NoiseSum sum = reference_sum_of(NoiseKind::value, OctaveShape::plain, 3, 2.0, 0.5);
        sum.noise.fade = fade;
        EXPECT_LT(worst_share(sum, 5e-7), 1.0);
    }
}

TEST(NoiseSum, TimeAndPeriodsArePointByPoint) {
    NoiseSum sum = reference_sum_of(NoiseKind::perlin, OctaveShape::plain, 3, 2.0, 0.5);
    sum.noise.time = 0.3;
    EXPECT_FALSE(has_point_kernel(sum.noise));
    EXPECT_LT(worst_share(sum, 8e-7), 1.0);
    NoiseSpec periodic{.kind = NoiseKind::value, .period = {3, 0, 0, 0}};
    EXPECT_FALSE(has_point_kernel(periodic));
    EXPECT_TRUE(has_point_kernel({.kind = NoiseKind::perlin1985}));
}

struct Slopes {
    alignas(64) float value[value_batch + batch_padding];
    alignas(64) float slope[3][value_batch + batch_padding];
    SlopeArrays arrays() { return {value, {slope[0], slope[1], slope[2]}}; }
};

/// The sum and its gradient in float64, with a share of each octave.
NoiseSample<double, 3> defined_slopes(const NoiseSum& sum, const Vec3d& p, double kept,
                                      double mean) {
    NoiseSample<double, 3> total{sum.offset, {}};
    NoiseSpec noise = sum.noise;
    for (std::size_t k = 0; k < sum.octaves.size(); ++k) {
        const auto& [seed, frequency, weight] = sum.octaves[k];
        noise.seed = seed;
        const Vec3d q = frequency * p;
        const auto n = shaped(sum.shape, sample_noise<double, 3>(noise, {q.x, q.y, q.z}));
        const double x = std::clamp((kept - double(k) - 0.3) / 0.4, 0.0, 1.0);
        const double share = x * x * (3.0 - 2.0 * x);
        total.value += weight * (share * n.value + (1.0 - share) * mean);
        for (std::size_t axis = 0; axis < 3; ++axis)
            total.gradient[axis] += weight * share * frequency * n.gradient[axis];
    }
    return total;
}

TEST(NoiseSum, SlopesStayWithinTheirStatedError) {
    using enum NoiseKind;
    std::mt19937 random(4);
    std::uniform_real_distribution<double> place(-40.0, 40.0);
    for (const NoiseKind kind : {value, perlin, perlin1985, perlin2002, worley})
        for (const OctaveShape shape :
             {OctaveShape::plain, OctaveShape::absolute, OctaveShape::ridged})
            for (const bool fading : {false, true}) {
                const NoiseSum sum = reference_sum_of(kind, shape, 9, 2.0, 0.6);
                double steepness = 0.0;
                for (const SumOctave& octave : sum.octaves)
                    steepness += std::abs(octave.weight * octave.frequency);
                Points points;
                Slopes out;
                alignas(64) float kept[value_batch + batch_padding];
                for (std::size_t j = 0; j < value_batch; ++j) {
                    for (Array& axis : points.axes) axis.values[j] = place(random);
                    kept[j] = 9.0f * float(j) / float(value_batch);
                }
                add_up_slopes(sum, points.arrays(), value_batch, {fading ? kept : nullptr, 0.25},
                              out.arrays());
                int steep = 0;
                for (std::size_t j = 0; j < value_batch; ++j) {
                    const auto exact =
                        defined_slopes(sum, points.at(j), fading ? double(kept[j]) : 9.0, 0.25);
                    EXPECT_NEAR(out.value[j], exact.value, 1.5e-6 * weights_of(sum));
                    double away = 0.0;
                    for (std::size_t axis = 0; axis < 3; ++axis)
                        away = std::max(
                            away, std::abs(double(out.slope[axis][j]) - exact.gradient[axis]));
                    // Beyond the bound only where a kink lies within rounding.
                    steep += away > (shape == OctaveShape::ridged ? 1e-5 : 4e-6) * steepness;
                }
                EXPECT_LE(steep, kind == worley || shape != OctaveShape::plain ? 2 : 0)
                    << int(kind) << " " << int(shape) << " " << fading;
            }
}

TEST(NoiseSum, SlopesHaveTheSameBitsOnEveryInstructionSet) {
    std::mt19937 random(6);
    const Points points = random_points(random);
    alignas(64) float kept[value_batch + batch_padding];
    for (std::size_t j = 0; j < value_batch; ++j) kept[j] = float(j % 11);
    using enum NoiseKind;
    for (const NoiseKind kind : {value, perlin, perlin1985, perlin2002}) {
        const NoiseSum sum = reference_sum_of(kind, OctaveShape::ridged, 10, 2.0, 0.6);
        const auto run = [&](Slopes& out) {
            add_up_slopes(sum, points.arrays(), value_batch, {kept, 0.5}, out.arrays());
        };
        Slopes expected, out;
        run(expected);
        on_every_target([&] {
            run(out);
            for (std::size_t j = 0; j < value_batch; ++j) {
                ASSERT_EQ(out.value[j], expected.value[j]) << simd_level() << " " << int(kind);
                for (int axis = 0; axis < 3; ++axis)
                    ASSERT_EQ(out.slope[axis][j], expected.slope[axis][j]) << simd_level();
            }
        });
    }
}

TEST(NoiseSum, CoordinatesThatLeaveTheLatticeCountAsNothing) {
    // At 2^45 the octaves from 2^6 on have left it, on that axis alone.
    NoiseSum sum = reference_sum_of(NoiseKind::value, OctaveShape::plain, 8, 2.0, 0.5);
    for (SumOctave& octave : sum.octaves) octave.frequency /= 0.7;
    Points points;
    const double out_there[] = {0x1p45, -0x1p45, 0x1p51, 1e300, NAN, INFINITY, 0x1p46};
    for (std::size_t j = 0; j < std::size(out_there); ++j) {
        points.axes[0].values[j] = out_there[j];
        points.axes[1].values[j] = 0.3 + double(j);
        points.axes[2].values[j] = -7.8;
    }
    Array out;
    add_up(sum, points.arrays(), std::size(out_there), out.values);
    for (std::size_t j = 0; j < std::size(out_there); ++j)
        EXPECT_NEAR(out.values[j], defined(sum, points.at(j)), 1e-6) << out_there[j];
}

TEST(NoiseSum, GivesTheSameBitsOnEveryInstructionSetAndInEveryBatch) {
    using enum NoiseKind;
    std::mt19937 random(9);
    Points points = random_points(random);
    points.axes[1].values[77] = 0x1p50;
    for (const NoiseKind kind : {value, perlin, perlin1985, perlin2002, worley}) {
        const NoiseSum sum = reference_sum_of(kind, OctaveShape::absolute, 10, 2.0, 0.6);
        Array all;
        add_up(sum, points.arrays(), value_batch, all.values);
        on_every_target([&] {
            Array out;
            add_up(sum, points.arrays(), value_batch, out.values);
            for (std::size_t j = 0; j < value_batch; ++j)
                ASSERT_EQ(out.values[j], all.values[j]) << simd_level() << " " << int(kind);
            Points one;
            for (std::size_t axis = 0; axis < 3; ++axis)
                one.axes[axis].values[0] = points.axes[axis].values[78];
            add_up(sum, one.arrays(), 1, out.values);
            EXPECT_EQ(out.values[0], all.values[78]);
        });
    }
}

}  // namespace
}  // namespace burl
