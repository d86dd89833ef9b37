// What lookups mark against lookups themselves: a texel that changes a lookup must be marked.
#include "app/gl/draw/view_texels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace burl {
namespace {

LookupSample sample_at(double u, double v, double footprint, int triangle = 1) {
    return {float(u), float(v), float(footprint * footprint), float(triangle)};
}

ViewTexels marked(const TextureLookup& lookup, const std::vector<LookupSample>& samples) {
    Image<LookupSample> image(samples.size(), 1);
    std::ranges::copy(samples, image.row(0).begin());
    ViewTexels texels(lookup.size);
    add_lookups(image, lookup, texels);
    return texels;
}

std::vector<std::uint64_t> counts(const ViewTexels& texels) {
    std::vector<std::uint64_t> counts;
    for (const TexelSet& level : texels.levels) counts.push_back(level.count());
    return counts;
}

TextureLookup lookup(std::uint32_t size, TextureFilter filter,
                     TextureWrap wrap = TextureWrap::clamp) {
    return {size, filter, wrap, wrap};
}

TEST(ViewTexels, HasAllLevels) {
    std::vector<std::uint32_t> sizes;
    for (const TexelSet& level : ViewTexels(24).levels) sizes.push_back(level.size());
    EXPECT_EQ(sizes, (std::vector<std::uint32_t>{24, 12, 6, 3, 1}));
}

TEST(ViewTexels, NearestReadsTheTexelOfThePlace) {
    const ViewTexels texels =
        marked(lookup(16, TextureFilter::nearest), {sample_at(3.5 / 16, 7.4 / 16, 5.0)});
    EXPECT_EQ(counts(texels), (std::vector<std::uint64_t>{1, 0, 0, 0, 0}));
    EXPECT_TRUE(texels.levels[0].contains(3, 7));
}

TEST(ViewTexels, LinearReadsFour) {
    const ViewTexels texels =
        marked(lookup(16, TextureFilter::linear), {sample_at(3.2 / 16, 7.8 / 16, 5.0)});
    EXPECT_EQ(counts(texels), (std::vector<std::uint64_t>{4, 0, 0, 0, 0}));
    for (const std::uint32_t x : {2u, 3u})
        for (const std::uint32_t y : {7u, 8u}) EXPECT_TRUE(texels.levels[0].contains(x, y));
}

/// On a border both sides count: nobody knows to which OpenGL rounds.
TEST(ViewTexels, BordersReadBothSides) {
    EXPECT_EQ(marked(lookup(16, TextureFilter::nearest), {sample_at(0.25, 0.5, 1)}).levels[0],
              marked(lookup(16, TextureFilter::linear), {sample_at(0.25, 0.5, 1)}).levels[0]);
}

TEST(ViewTexels, WrapsAtTheEdge) {
    const auto columns = [](TextureWrap wrap) {
        const ViewTexels texels = marked(lookup(8, TextureFilter::linear, wrap),
                                         {sample_at(-0.2 / 8, 4.2 / 8, 1), sample_at(1.1, 0.5, 1)});
        std::string text;
        for (std::uint32_t x = 0; x < 8; ++x) text += texels.levels[0].contains(x, 4) ? 'x' : '.';
        return text;
    };
    EXPECT_EQ(columns(TextureWrap::clamp), "x......x");
    EXPECT_EQ(columns(TextureWrap::repeat), "xx.....x");
    EXPECT_EQ(columns(TextureWrap::mirror), "x.....xx");
}

TEST(ViewTexels, WithoutSlackOnlyWhatCounts) {
    Image<LookupSample> image(1, 1, sample_at(4.5 / 16, 4.5 / 16, 1.0));
    ViewTexels texels(16);
    add_lookups(image, lookup(16, TextureFilter::mip), texels, no_slack);
    EXPECT_EQ(counts(texels), (std::vector<std::uint64_t>{1, 0, 0, 0, 0}));
    EXPECT_TRUE(texels.levels[0].contains(4, 4));
    image(0, 0) = sample_at(4.75 / 16, 4.5 / 16, std::sqrt(2.0));
    add_lookups(image, lookup(16, TextureFilter::mip), texels, no_slack);
    EXPECT_EQ(counts(texels), (std::vector<std::uint64_t>{2, 4, 0, 0, 0}));
}

TEST(ViewTexels, TrilinearReadsTwoLevels) {
    const auto levels = [](double footprint) {
        const ViewTexels texels =
            marked(lookup(64, TextureFilter::mip), {sample_at(0.51, 0.51, footprint)});
        std::string text;
        for (const TexelSet& level : texels.levels) text += level.count() > 0 ? 'x' : '.';
        return text;
    };
    EXPECT_EQ(levels(0.1), "x......");
    EXPECT_EQ(levels(std::exp2(2.5)), "..xx...");
    EXPECT_EQ(levels(std::exp2(2.01)), ".xxx...") << "nobody knows how 2 is rounded";
    EXPECT_EQ(levels(1e6), "......x");
    EXPECT_EQ(levels(std::nan("")), "......x");
}

TEST(ViewTexels, BlocksKeepLookupsInside) {
    TextureLookup in_blocks = lookup(64, TextureFilter::mip);
    in_blocks.blocks = {Vec4f(0, 0, 1, 1), Vec4f(0.25f, 0.25f, 0.5f, 0.5f)};
    const ViewTexels texels = marked(in_blocks, {sample_at(0.499, 0.251, std::exp2(1.5), 2)});
    EXPECT_EQ(texels.levels[0].count() + texels.levels[3].count(), 0u);
    for (const std::size_t l : {1u, 2u}) {
        const TexelSet& level = texels.levels[l];
        EXPECT_GT(level.count(), 0u);
        // The lookup is clamped to the last texel's centre: slack reaches one texel further.
        const std::uint32_t last = level.size() / 2 - 1, first = level.size() / 4;
        EXPECT_TRUE(level.contains(last, first));
        for (std::uint32_t y = 0; y < level.size(); ++y)
            for (std::uint32_t x = 0; x < level.size(); ++x)
                EXPECT_TRUE(!level.contains(x, y) || (x + 2 >= last && y <= first + 2));
    }
}

TEST(ViewTexels, SamplesThatSeeNothingMarkNothing) {
    const ViewTexels texels = marked(lookup(16, TextureFilter::mip), {sample_at(0.5, 0.5, 1, 0)});
    for (const std::uint64_t count : counts(texels)) EXPECT_EQ(count, 0u);
    EXPECT_EQ(texels.count_tiles(), 0u);
}

TEST(ViewTexels, BeneathHoldsWhatMeansAreOf) {
    ViewTexels texels(32);
    texels.levels[2].insert(1, 2);
    texels.levels[0].insert(30, 0);
    EXPECT_EQ(texels.count_tiles(), 2u);
    const std::vector<TexelSet> averaged = texels.beneath([](std::uint32_t) { return 0u; });
    EXPECT_EQ(averaged[0].count(), 17u);
    EXPECT_EQ(averaged[2].count(), 0u);
    EXPECT_TRUE(averaged[0].contains(30, 0));
    for (std::uint32_t y = 8; y < 12; ++y)
        for (std::uint32_t x = 4; x < 8; ++x) EXPECT_TRUE(averaged[0].contains(x, y));
    const std::vector<TexelSet> direct =
        texels.beneath([](std::uint32_t l) { return l > 0 ? l - 1 : 0; });
    EXPECT_EQ(direct[0].count(), 1u);
    EXPECT_EQ(direct[1].count(), 4u);
    EXPECT_TRUE(direct[1].contains(3, 5));
    EXPECT_EQ(direct[2].count(), 0u);
}

TEST(ViewTexels, DoNotDependOnThreadsOrOrder) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    Image<LookupSample> samples(100, 90), turned(100, 90);
    for (std::size_t i = 0; i < 9000; ++i) {
        const auto u = unit(random), v = unit(random);
        const LookupSample sample = sample_at(u, v, 20.0 * unit(random));
        samples(i % 100, i / 100) = sample;
        turned(99 - i % 100, 89 - i / 100) = sample;
    }
    const TextureLookup way = lookup(256, TextureFilter::mip);
    ViewTexels one(256), other(256);
    add_lookups(samples, way, one);
    add_lookups(turned, way, other);
    EXPECT_EQ(one.levels, other.levels);
    EXPECT_GT(one.levels[1].count(), 1000u);
}

}  // namespace
}  // namespace burl
