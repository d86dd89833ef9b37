#include "procedural/bresenham/noise.h"

#include <random>

#include <gtest/gtest.h>

#include "procedural/noise/noise.h"

namespace burl {
namespace {

using enum ForwardPrecision;
constexpr ForwardPrecision precisions[] = {float32, float64, fixed64};
constexpr Fade fades[] = {Fade::linear, Fade::smooth, Fade::quintic};
constexpr std::int64_t never = std::int64_t(1) << 62;

std::vector<double> forward(const NoiseSpec& noise, const LatticeLine& line,
                            const ForwardOptions& options = {}) {
    std::vector<double> n(line.count, 0.0);
    add_forward_noise(noise, 1.0, line, options, n.data());
    return n;
}

/// Largest error against the float64 reference at the same points.
double largest_error(const NoiseSpec& noise, const LatticeLine& line,
                     const ForwardOptions& options) {
    const std::vector<double> n = forward(noise, line, options);
    double worst = 0.0;
    for (std::size_t j = 0; j < line.count; ++j) {
        const double exact =
            evaluate_noise(noise, line.start + (line.first + double(j)) * line.step);
        worst = std::max(worst, std::abs(n[j] - exact));
    }
    return worst;
}

Vec3d random_vector(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    return {unit(random), unit(random), unit(random)};
}

/// forward_noise.h states these for every step and length.
double stated_error(ForwardPrecision precision) {
    return precision == float32 ? 2.5e-6 : precision == float64 ? 4e-12 : 2.5e-8;
}

TEST(ForwardNoise, StaysWithinItsStatedErrorsAtEveryStep) {
    std::mt19937 random(1);
    for (const Fade fade : fades)
        for (const ForwardPrecision precision : precisions)
            for (int power = 14; power >= -3; --power)
                for (int i = 0; i < 4; ++i) {
                    const Vec3d step =
                        std::ldexp(1.0, -power) * glm::normalize(random_vector(random));
                    const NoiseSpec noise{.fade = fade, .seed = std::uint32_t(random())};
                    const LatticeLine line{20.0 * random_vector(random), step, 0.0, 1024};
                    EXPECT_LE(largest_error(noise, line, {.precision = precision}),
                              stated_error(precision))
                        << int(fade) << " " << int(precision) << " 2^-" << power;
                }
}

TEST(ForwardNoise, StaysWithinItsStatedErrorsInItsLongestRuns) {
    // Runs of 19 to 64 texels in cells of up to 128: there rounding of degree 15 grows most.
    std::mt19937 random(7);
    double worst = 0.0;
    for (int i = 0; i < 2000; ++i) {
        Vec3d step = 0.9 * random_vector(random);
        step[int(random() % 3)] = random() % 2 ? 1.0 : -1.0;
        step *= std::ldexp(1.0 + 0.5 * random_vector(random).x, -5 - i % 2);
        const NoiseSpec noise{.fade = Fade::quintic, .seed = std::uint32_t(random())};
        const LatticeLine line{20.0 * random_vector(random), step, 0.0, 256};
        worst = std::max(worst, largest_error(noise, line, {.precision = float32}));
    }
    EXPECT_LE(worst, stated_error(float32));
    EXPECT_GT(worst, 0.2 * stated_error(float32)) << "these are not the worst lines";
}

/// One set of differences for n texels in a single cell, nearly from face to face.
double error_in_one_cell(Fade fade, ForwardPrecision precision, std::size_t texels) {
    std::mt19937 random(2);
    double worst = 0.0;
    for (int i = 0; i < (texels < 1000 ? 60 : 20); ++i) {
        Vec3d from = Vec3d(0.5) + 0.499 * random_vector(random);
        Vec3d to = Vec3d(0.5) + 0.499 * random_vector(random);
        const int axis = int(random() % 3);
        from[axis] = 0.001;
        to[axis] = 0.999;
        if (i % 2) std::swap(from, to);
        const LatticeLine line{from, (to - from) / double(texels - 1), 0.0, texels};
        worst = std::max(worst, largest_error({.fade = fade, .seed = std::uint32_t(random())}, line,
                                              {precision, never}));
    }
    return worst;
}

TEST(ForwardNoise, ErrsWithTheLengthOfARunAsStated) {
    // docs/reference/bresenham.md; 0: not stated, the differences no longer hold it.
    constexpr std::size_t lengths[] = {16, 64, 256, 1024, 4096};
    struct Stated {
        Fade fade;
        ForwardPrecision precision;
        double errors[5];
    };
    const Stated table[] = {
        {Fade::linear, float32, {6e-7, 3e-6, 2e-5, 5e-5, 3e-4}},
        {Fade::linear, float64, {2e-15, 1e-14, 3e-14, 1e-13, 6e-13}},
        {Fade::linear, fixed64, {2e-15, 4e-14, 3e-12, 2e-10, 1e-8}},
        {Fade::smooth, float32, {2e-6, 6e-6, 2e-5, 5e-5, 2e-4}},
        {Fade::smooth, float64, {2e-14, 2e-14, 3e-14, 8e-14, 6e-13}},
        {Fade::smooth, fixed64, {3e-14, 3e-8, 1e-2, 0, 0}},
        {Fade::quintic, float32, {5e-6, 5e-5, 2e-4, 2e-3, 4e-3}},
        {Fade::quintic, float64, {3e-13, 6e-13, 1e-12, 2e-12, 2e-11}},
        {Fade::quintic, fixed64, {3e-13, 2e-4, 0, 0, 0}},
    };
    for (const auto& [fade, precision, errors] : table)
        for (std::size_t k = 0; k < 5; ++k)
            if (errors[k] > 0.0) {
                EXPECT_LE(error_in_one_cell(fade, precision, lengths[k]), errors[k])
                    << int(fade) << " " << int(precision) << " " << lengths[k];
            }
}

TEST(ForwardNoise, DoesNotDependOnWhereTheLineIsCut) {
    std::mt19937 random(3);
    for (int i = 0; i < 90; ++i) {
        const NoiseSpec noise{.fade = fades[i % 3], .seed = 5};
        const ForwardOptions options{precisions[i / 3 % 3], i % 5 == 0 ? 7 : 0};
        const LatticeLine line{9.0 * random_vector(random),
                               std::ldexp(1.0, -int(random() % 12)) * random_vector(random), 0.0,
                               500};
        const std::vector<double> whole = forward(noise, line, options);
        for (std::size_t first = 0; first < line.count;) {
            const std::size_t count = std::min<std::size_t>(1 + random() % 90, line.count - first);
            const std::vector<double> part =
                forward(noise, {line.start, line.step, double(first), count}, options);
            for (std::size_t j = 0; j < count; ++j) ASSERT_EQ(part[j], whole[first + j]);
            first += count;
        }
    }
}

TEST(ForwardNoise, StandsLinesThatArePointsPlanesAndAxes) {
    for (const Fade fade : fades)
        for (const ForwardPrecision precision : precisions) {
            const NoiseSpec noise{.fade = fade, .seed = 11};
            const ForwardOptions options{precision, 0};
            const double bound = stated_error(precision);
            for (const LatticeLine& line :
                 {LatticeLine{{1.25, -2.5, 3.0}, {0.0, 0.0, 0.0}, 0.0, 200},
                  LatticeLine{{0.0, 0.0, 0.0}, {0.0, -1.0 / 64, 0.0}, 0.0, 300},
                  LatticeLine{{4.0, -4.0, 0.5}, {1.0 / 32, -1.0 / 32, 0.0}, 0.0, 300},
                  LatticeLine{{-3.0, 5.0, 7.0}, {-1.0, 2.0, 0.0}, 0.0, 50},
                  LatticeLine{{0.3, 0.2, 0.1}, {1000.25, -999.5, 1e6}, 0.0, 50},
                  LatticeLine{{2.0, 3.0, 4.0}, {-1e-20, 1e-300, -5e-324}, 0.0, 200},
                  LatticeLine{{1.0, 1.0, 1.0}, {0.5, 0.5, 0.5}, 3.0, 1}})
                EXPECT_LE(largest_error(noise, line, options), bound) << line.step.x;
            EXPECT_EQ(forward(noise, {{1, 2, 3}, {4, 5, 6}, 0.0, 0}, options).size(), 0u);
        }
}

TEST(ForwardNoise, IsAsGoodFarFromTheOrigin) {
    // Coordinates that float64 holds exactly, so that both see the same points.
    for (const Fade fade : fades)
        for (const double far : {-1e6, 1e9, -3e9}) {
            const LatticeLine line{
                {far + 0.25, 0.5 - far, far}, {0x1p-8, -0x1p-9, 0x1p-10}, 0.0, 600};
            EXPECT_LE(largest_error({.fade = fade}, line, {}), stated_error(float64));
        }
}

TEST(ForwardNoise, KeepsPeriods) {
    const NoiseSpec noise{.fade = Fade::smooth, .period = {3, 2, 5, 0}};
    const LatticeLine line{{-7.3, 0.4, 9.9}, {0.03, -0.05, 0.02}, 0.0, 400};
    EXPECT_LE(largest_error(noise, line, {}), stated_error(float64));
}

TEST(ForwardNoise, AddsScaledNoiseToWhatIsThere) {
    const LatticeLine line{{0.1, 0.2, 0.3}, {0.01, 0.02, 0.04}, 0.0, 100};
    const std::vector<double> n = forward({}, line);
    std::vector<double> sums(line.count, 2.0);
    add_forward_noise({}, -3.0, line, {}, sums.data());
    for (std::size_t j = 0; j < line.count; ++j) EXPECT_EQ(sums[j], 2.0 + -3.0 * n[j]);
}

TEST(ForwardNoise, CountsWhatItDid) {
    std::vector<double> n(256, 0.0);
    // Eight cells of 32 texels along x.
    const LatticeLine line{{0.0, 0.5, 0.5}, {1.0 / 32, 0.0, 0.0}, 0.0, 256};
    EXPECT_EQ(add_forward_noise({.fade = Fade::linear}, 1.0, line, {}, n.data()),
              (ForwardCounts{8, 8, 0}));
    EXPECT_EQ(add_forward_noise({.fade = Fade::linear}, 1.0, line, {float64, 10}, n.data()),
              (ForwardCounts{8, 32, 0}));
    // Two texels in every cell are no use to ten differences.
    EXPECT_EQ(
        add_forward_noise({}, 1.0, {{0.0, 0.5, 0.5}, {0.5, 0.0, 0.0}, 0.0, 256}, {}, n.data()),
        (ForwardCounts{128, 0, 256}));
}

TEST(ForwardNoise, SaysWhatHasNoPolynomial) {
    EXPECT_EQ(no_forward_form(NoiseSpec{}), "");
    EXPECT_NE(no_forward_form(NoiseSpec{.kind = NoiseKind::perlin}), "");
    EXPECT_NE(no_forward_form(NoiseSpec{.time = 1.0}), "");
}

}  // namespace
}  // namespace burl
