// Sums in one pass have the bits of sums octave by octave.
#include "procedural/kernels/stream_kernels.h"

#include <array>
#include <cstring>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/procedural/support/only_target.h"

namespace burl {
namespace {

TEST(KeptSums, HaveTheBitsOfSumsOctaveByOctave) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> any(-8e6f, 8e6f);
    constexpr std::size_t most = 5, room = batch_capacity + batch_padding;
    alignas(64) static float noise[most][room];
    for (auto& octave : noise)
        for (float& n : octave) n = any(random);
    noise[0][0] = noise[1][0] = -0.0f;
    for (const std::size_t octaves : {0, 1, 2, 5})
        for (const std::size_t count : {0, 1, 3, 7, 16, 17, 100, 1023, 1024}) {
            std::vector<KeptSummand> summands;
            alignas(64) float sums[room] = {};
            std::vector<double> before(count), expected;
            for (double& value : before) value = double(any(random)) * 1e-7;
            expected = before;
            expected.resize(count + batch_padding);
            for (std::size_t k = 0; k < octaves; ++k) {
                const float weight = 0.7f / float(k + 1);
                summands.push_back({weight, noise[k]});
                add_scaled(weight, noise[k], count, sums);
            }
            add_sums(1.2e-7, sums, count, expected.data());
            on_every_target([&] {
                std::vector<double> values = before;
                values.push_back(77.0);
                add_kept_sums(summands, 1.2e-7, count, values.data());
                EXPECT_EQ(std::memcmp(values.data(), expected.data(), count * sizeof(double)), 0)
                    << octaves << " " << count;
                EXPECT_EQ(values.back(), 77.0) << "nothing beyond";
            });
        }
}

}  // namespace
}  // namespace burl
