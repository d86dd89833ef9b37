#include "procedural/noise_kernels.h"

#include <memory>
#include <random>

#include <gtest/gtest.h>

#include "procedural/color_kernels.h"
#include "procedural/color_table.h"
#include "procedural/noise.h"

namespace burl {
namespace {

/// Random cells and places such that float64 holds their sum, so the reference sees the same point.
void randomize(LatticeBatch& batch, std::mt19937& random) {
    std::uniform_real_distribution<float> place(-0.5f, 0.5f);
    for (int axis = 0; axis < 3; ++axis)
        for (std::size_t j = 0; j < batch_capacity; ++j) {
            batch.cells[axis][j] = std::int32_t(random()) >> (8 + random() % 23);
            batch.places[axis][j] = random() % 8 ? place(random) : random() % 2 ? 0.5f : -0.5f;
        }
}

/// Largest |error| / (1 + |n|).
double largest_error(NoiseKind kind, Fade fade, int batches) {
    const auto batch = std::make_unique<LatticeBatch>();
    std::mt19937 random(11);
    double worst = 0.0;
    for (int i = 0; i < batches; ++i) {
        randomize(*batch, random);
        std::vector<double> sums(batch_capacity + batch_padding, 0.0);
        const std::uint32_t seed = std::uint32_t(random());
        add_noise(kind, fade, seed, 1.0, *batch, batch_capacity, sums.data());
        for (std::size_t j = 0; j < batch_capacity; ++j) {
            Vec3d p;
            for (int axis = 0; axis < 3; ++axis)
                p[axis] = batch->cells[axis][j] + 0.5 + double(batch->places[axis][j]);
            const double exact = evaluate_noise({.kind = kind, .fade = fade, .seed = seed}, p);
            worst = std::max(worst, std::abs(sums[j] - exact) / (1.0 + std::abs(exact)));
        }
    }
    return worst;
}

TEST(NoiseKernels, StayWithinTheirStatedErrors) {
    EXPECT_LT(largest_error(NoiseKind::value, Fade::linear, 400), 2.0e-7);
    EXPECT_LT(largest_error(NoiseKind::value, Fade::smooth, 400), 2.0e-7);
    EXPECT_LT(largest_error(NoiseKind::value, Fade::quintic, 400), 2.0e-7);
    EXPECT_LT(largest_error(NoiseKind::perlin, Fade::quintic, 400), 2.5e-7);
}

TEST(NoiseKernels, GiveTheBitsOfTheScalarFloatPath) {
    const auto batch = std::make_unique<LatticeBatch>();
    std::mt19937 random(12);
    for (int i = 0; i < 20; ++i) {
        randomize(*batch, random);
        const NoiseSpec noise{i % 4 == 3 ? NoiseKind::perlin : NoiseKind::value,
                              Fade(i % 3),
                              {},
                              0.6,
                              std::uint32_t(random())};
        std::vector<double> sums(batch_capacity + batch_padding, 0.0);
        add_noise(noise.kind, noise.fade, noise.seed, 1.0, *batch, batch_capacity, sums.data());
        for (std::size_t j = 0; j < batch_capacity; ++j) {
            Point<3> p;
            bool upper_face = false;  // belongs to the next cell for the scalar path
            for (std::size_t axis = 0; axis < 3; ++axis) {
                p[axis] = batch->cells[axis][j] + 0.5 + double(batch->places[axis][j]);
                upper_face = upper_face || batch->places[axis][j] == 0.5f;
            }
            if (upper_face) continue;
            ASSERT_EQ(sums[j], double(sample_noise<float>(noise, p).value)) << i << " " << j;
        }
    }
}

TEST(NoiseKernels, AddScaledNoiseToWhatIsThere) {
    const auto batch = std::make_unique<LatticeBatch>();
    std::mt19937 random(1);
    randomize(*batch, random);
    std::vector<double> once(batch_capacity + batch_padding, 0.0), twice = once;
    add_noise(NoiseKind::value, Fade::smooth, 3, 1.0, *batch, 100, once.data());
    add_noise(NoiseKind::value, Fade::smooth, 3, -2.5, *batch, 100, twice.data());
    add_noise(NoiseKind::value, Fade::smooth, 3, 4.0, *batch, 100, twice.data());
    for (std::size_t j = 0; j < 100; ++j) EXPECT_NEAR(twice[j], 1.5 * once[j], 1e-15);
}

TEST(NoiseKernels, SplitCoordinatesIntoCellAndPlace) {
    const auto batch = std::make_unique<LatticeBatch>();
    const std::vector<LatticeLine> lines{{{0.25, -0.25, 1e6 + 0.125}, {0.5, -0.75, 1000.0}, 0.0, 7},
                                         {{-3.0, 1e12, -5e9}, {1e-7, 0.3, 0.7}, 500.0, 900},
                                         {{1.5, 1.5, 1.5}, {0.0, 0.0, 0.0}, 3.0, 1}};
    split_lattice_lines(lines, *batch);
    std::size_t at = 0;
    for (const LatticeLine& line : lines)
        for (std::size_t j = 0; j < line.count; ++j, ++at)
            for (int axis = 0; axis < 3; ++axis) {
                const double x = line.start[axis] + (line.first + double(j)) * line.step[axis];
                const float place = batch->places[axis][at];
                ASSERT_LE(std::abs(place), 0.5f);
                // Cells are wrapped, so whole multiples of 2^32 may be missing.
                const double rest = x - (batch->cells[axis][at] + 0.5 + double(place));
                const double wrapped = rest - 0x1p32 * std::round(rest * 0x1p-32);
                ASSERT_NEAR(wrapped, 0.0, 0x1p-25 + 0x1p-51 * std::abs(x)) << at << " " << axis;
            }
}

TEST(NoiseKernels, FillParabolas) {
    std::vector<double> values(batch_capacity + batch_padding);
    fill_parabolas(std::vector<ParabolaLine>{{1.0, 2.0, 3.0, 0.0, 5}, {0.5, 0.25, -1.0, 10.0, 3}},
                   values.data());
    const std::vector<double> expected{
        1, 6, 17, 34, 57, 0.5 + 2.5 - 100, 0.5 + 2.75 - 121, 0.5 + 3 - 144};
    for (std::size_t j = 0; j < expected.size(); ++j) EXPECT_EQ(values[j], expected[j]);
}

TEST(NoiseKernels, IndexColorsAsTheMapDoes) {
    std::mt19937 random(1);
    std::vector<double> f{0.0,
                          1.0,
                          -1.0,
                          0.5,
                          -0.25,
                          2.75,
                          -1e-20,
                          1e300,
                          -1e300,
                          1e15,
                          -1e15,
                          0.9999999999999999,
                          std::numeric_limits<double>::infinity(),
                          -std::numeric_limits<double>::infinity(),
                          std::numeric_limits<double>::quiet_NaN()};
    std::uniform_real_distribution<double> anywhere(-4.0, 4.0);
    while (f.size() < 200) f.push_back(anywhere(random));
    const std::size_t count = f.size();
    f.resize(count + batch_padding);
    std::vector<std::int32_t> entries(count + batch_padding);
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
        index_colors(wrap, f.data(), count, 1000, entries.data());
        for (std::size_t j = 0; j < count; ++j)
            EXPECT_EQ(entries[j], std::int32_t(map_index(wrap, f[j]) * 1000.0)) << f[j];
    }
}

}  // namespace
}  // namespace burl
