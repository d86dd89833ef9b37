#include "procedural/noise_kernels.h"

#include <random>

#include <gtest/gtest.h>

#include "procedural/color_kernels.h"
#include "procedural/color_table.h"

namespace burl {
namespace {

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
