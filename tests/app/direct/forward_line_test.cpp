// The line of "Bresenham Noise", figures 9 to 11, and its plots.
#include "app/direct/forward_line.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/recipe.h"
#include "procedural/noise/noise.h"

namespace burl {
namespace {

std::vector<Octave> octaves_of(const char* preset) {
    return expand_octaves(*plain_texture(load_recipe(preset).texture));
}

/// Noise from 0 to 1, as the paper's.
TEST(ForwardLine, HasTheNoiseOfEveryTexel) {
    const std::vector<Octave> octaves = octaves_of("bresenham-marble");
    ASSERT_EQ(octaves.size(), 4u);
    const std::vector<double> values = noise_on_line(octaves, CubeMethod::pixelwise);
    ASSERT_EQ(values.size(), 256u);
    for (std::size_t j = 0; j < values.size(); ++j) {
        double sum = 0.0;
        for (const int octave : {0, 1, 2, 3}) {
            const NoiseSpec& noise = octaves[std::size_t(octave)].noise;
            const double place = double(j) / 128.0 * std::ldexp(1.0, octave);
            sum += std::ldexp(0.5 + 0.5 * evaluate_noise(noise, Vec3d(place)), -octave);
        }
        ASSERT_NEAR(values[j], sum, 1e-12) << j;
    }
}

TEST(ForwardLine, EntersCellsWhereTheirPlanesAre) {
    const std::vector<Octave> octaves = octaves_of("bresenham-marble");
    EXPECT_EQ(cell_entries(octaves[0]), (std::vector<std::size_t>{0, 128}));
    const std::vector<std::size_t> fine = cell_entries(octaves[3]);
    ASSERT_EQ(fine.size(), 16u);
    for (std::size_t i = 0; i < fine.size(); ++i) EXPECT_EQ(fine[i], 16 * i);
    // 10 cells across s and t, whose planes lie 25.6 texels apart, and one more plane of r at s
    // = 1.
    const std::vector<std::size_t> wood = cell_entries(octaves_of("bresenham-wood")[0]);
    EXPECT_EQ(wood, (std::vector<std::size_t>{0, 26, 52, 77, 103, 128, 154, 180, 205, 231}));
}

/// The paper says: "At the first pixel of the each cell, there is no difference at all.
/// However, as scan line proceed the cell, the difference is getting bigger."
TEST(ForwardLine, DiffersNotAtFirstAndThenMoreAndMore) {
    for (const std::size_t number : {0u, 3u}) {
        const std::vector<Octave> octave{octaves_of("bresenham-marble")[number]};
        const std::vector<double> exact = noise_on_line(octave, CubeMethod::pixelwise);
        const std::vector<double> forward = noise_on_line(octave, CubeMethod::forward);
        const std::size_t length = number == 0 ? 128 : 16;
        double first = 0.0, half = 0.0, last = 0.0;
        for (std::size_t j = 0; j < exact.size(); ++j) {
            double& largest = j % length == 0 ? first : j % length < length / 2 ? half : last;
            largest = std::max(largest, std::abs(forward[j] - exact[j]));
        }
        EXPECT_LT(first, 1e-9) << number;
        EXPECT_GT(half, first) << number;
        EXPECT_GT(last, 2.0 * half) << number;
        EXPECT_LT(last, 1e-5) << number;
    }
}

TEST(LinePlot, PutsValuesAtTheirHeight) {
    LinePlot plot(2.0);
    std::vector<double> ramp(line_texels), steps(line_texels);
    for (std::size_t j = 0; j < line_texels; ++j) {
        ramp[j] = 2.0 - 4.0 * double(j) / 255.0;
        steps[j] = j < 100 ? -1.0 : 1.0;
    }
    plot.add_broad(ramp);
    plot.add_thin(steps);
    const Rgb8 black{0, 0, 0}, white{255, 255, 255};
    const auto at = [&](std::size_t texel, std::size_t row) {
        return plot.picture()(LinePlot::left + texel, row);
    };
    EXPECT_EQ(at(50, 80), black);  // half of the way from the middle, row 55, to row 105
    EXPECT_EQ(at(200, 30), black);
    EXPECT_EQ(at(50, 79), white);
    EXPECT_EQ(at(100, 40), black);  // the stroke from one to the other
    EXPECT_NE(at(0, 5), white);
    EXPECT_NE(at(255, 105), white);
    EXPECT_EQ(at(255, 60), white);
    EXPECT_NE(at(50, 55), white);  // zero
    EXPECT_EQ(plot.picture()(LinePlot::left - 1, 55), white);
}

TEST(LinePlot, KeepsValuesBeyondItsEndsInside) {
    LinePlot plot(1.0);
    const std::vector<double> far(line_texels, 7.0), below(line_texels, -1e9);
    plot.add_broad(far);
    plot.add_broad(below);
    EXPECT_NE(plot.picture()(LinePlot::left, 5), (Rgb8{255, 255, 255}));
    EXPECT_NE(plot.picture()(LinePlot::left, 105), (Rgb8{255, 255, 255}));
}

}  // namespace
}  // namespace burl
