// Sets of texels against one flag a texel.
#include "atlas/solid/texel_set.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <utility>

#include "atlas/base/image.h"
#include "atlas/base/mip_chain.h"

namespace burl {
namespace {

using Texels = std::set<std::pair<std::uint32_t, std::uint32_t>>;

Texels texels_of(const TexelSet& set) {
    Texels texels;
    for (std::uint32_t y = 0; y < set.size(); ++y)
        for (std::uint32_t x = 0; x < set.size(); ++x)
            if (set.contains(x, y)) texels.insert({x, y});
    return texels;
}

struct Made {
    TexelSet set;
    Texels texels;
};

/// Runs of all lengths and single texels.
Made random_set(std::uint32_t size, int runs, std::uint32_t seed) {
    std::mt19937 random(seed);
    Made made{TexelSet(size), {}};
    for (int i = 0; i < runs; ++i) {
        const std::uint32_t y = std::uint32_t(random()) % size, x = std::uint32_t(random()) % size;
        const std::uint32_t last = x + std::uint32_t(random()) % (size - x + 1);
        made.set.insert({x, last}, y);
        for (std::uint32_t k = x; k < last; ++k) made.texels.insert({k, y});
        const std::uint32_t one = std::uint32_t(random()) % size;
        made.set.insert(one, x);
        made.texels.insert({one, x});
    }
    return made;
}

TEST(TexelSet, HoldsWhatWasPutIn) {
    for (const std::uint32_t size : {1u, 31u, 32u, 33u, 100u}) {
        const Made made = random_set(size, 20, size);
        EXPECT_EQ(texels_of(made.set), made.texels);
        EXPECT_EQ(made.set.count(), made.texels.size());
        Texels tiles;
        for (const auto& [x, y] : made.texels) tiles.insert({x / 32, y / 32});
        EXPECT_EQ(made.set.count_tiles(), tiles.size());
        EXPECT_EQ(TexelSet(size).count_tiles(), 0u);
    }
}

TEST(TexelSet, RunsAreThoseOfItsTexelsWithinARange) {
    const Made made = random_set(100, 60, 5);
    for (std::uint32_t y = 0; y < 100; ++y)
        for (const TexelRange xs : {TexelRange{0, 100}, TexelRange{13, 77}, TexelRange{64, 64}}) {
            Texels seen;
            std::uint32_t end = 0;
            made.set.for_each_run(y, xs, [&](std::uint32_t first, std::uint32_t last) {
                EXPECT_LT(first, last);
                EXPECT_TRUE(seen.empty() || first > end) << "two runs that touch";
                end = last;
                for (std::uint32_t x = first; x < last; ++x) seen.insert({x, y});
            });
            Texels expected;
            for (const auto& [x, row] : made.texels)
                if (row == y && x >= xs.first && x < xs.last) expected.insert({x, y});
            EXPECT_EQ(seen, expected);
        }
}

TEST(TexelSet, JoinsAnother) {
    Made a = random_set(70, 5, 1);
    const Made b = random_set(70, 5, 2);
    a.set |= b.set;
    a.texels.insert(b.texels.begin(), b.texels.end());
    EXPECT_EQ(texels_of(a.set), a.texels);
}

TEST(TexelSet, WholeCellsHoldTheirTexels) {
    for (const std::uint32_t size : {7u, 64u, 75u})
        for (const std::uint32_t side : {1u, 2u, 4u, 8u, 16u, 32u}) {
            const Made made = random_set(size, 3, size + side);
            Texels cells, expected;
            for (const auto& [x, y] : made.texels) cells.insert({x / side, y / side});
            for (std::uint32_t y = 0; y < size; ++y)
                for (std::uint32_t x = 0; x < size; ++x)
                    if (cells.contains({x / side, y / side})) expected.insert({x, y});
            EXPECT_EQ(texels_of(made.set.whole_cells(side)), expected) << size << " " << side;
        }
}

/// A texel lies beneath the set where a light in it alone shows in one of the set's.
TEST(TexelSet, BeneathIsAllThatAMeanTakes) {
    for (const std::uint32_t size : {16u, 21u, 3u}) {
        const Made made = random_set(size / 2, 2, size);
        Texels expected;
        for (std::uint32_t y = 0; y < size; ++y)
            for (std::uint32_t x = 0; x < size; ++x) {
                Image<float> light(size, size, 0.0f);
                light(x, y) = 1.0f;
                const Image<float> half = halve(light);
                for (const auto& [i, j] : made.texels)
                    if (half(i, j) > 0.0f) expected.insert({x, y});
            }
        EXPECT_EQ(texels_of(made.set.beneath(size)), expected) << size;
    }
}

}  // namespace
}  // namespace burl
