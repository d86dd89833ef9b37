// Whatever is left out, nobody sees it: textures with every skip, without one of them and without
// any have the same bytes, for all presets and a thousand recipes at random.
#include "procedural/batch/economy.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/presets.h"

#include <filesystem>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/options/command_options.h"
#include "app/pipeline/pipeline.h"
#include "procedural/cache/synthesis.h"
#include "procedural/fill/synthesize.h"
#include "tests/app/support/sample_scene.h"
#include "tests/paths.h"
#include "tests/procedural/support/synthetic_atlas.h"
#include "tests/stability/cases.h"

namespace burl {
namespace {

constexpr std::size_t large_cache = std::size_t(1) << 26;

Skips without(Skip skip) {
    Skips skips;
    skips.forbid(skip);
    return skips;
}

Skips without_any() {
    Skips skips;
    for (std::size_t k = 0; k < skip_names.size(); ++k) skips.forbid(Skip(k));
    return skips;
}

std::vector<std::string> preset_names() {
    std::vector<std::string> names;
    for (const auto& file :
         std::filesystem::directory_iterator(test::source_folder() + "/assets/recipes/papers"))
        names.push_back(file.path().stem().string());
    std::ranges::sort(names);
    return names;
}

class PresetEconomy : public testing::TestWithParam<std::string> {};

TEST_P(PresetEconomy, ShowsInNoByte) {
    for (const char* filter : {"none", "exact"}) {
        SCOPED_TRACE(filter);
        const Recipe recipe =
            load_recipe(GetParam(), {"atlas.size=64", fmt::format("filter.kind={}", filter)});
        Pipeline pipeline(cube_mesh());
        pipeline.set_recipe(recipe);
        pipeline.set_skips(without_any());
        const Image<Rgb8> expected = pipeline.synthesize<Rgb8>();
        pipeline.set_skips({});
        EXPECT_EQ(pipeline.synthesize<Rgb8>(), expected) << "with all";
        for (std::size_t k = 0; k < skip_names.size(); ++k) {
            pipeline.set_skips(without(Skip(k)));
            EXPECT_EQ(pipeline.synthesize<Rgb8>(), expected) << "without " << skip_names[k];
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, PresetEconomy, testing::ValuesIn(preset_names()),
                         [](const auto& preset) {
                             std::string name = preset.param;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

/// Terms of every noise, some without weight, under maps with wide runs of one colour.
Texture random_texture(Chance& chance, const std::vector<NamedTerm>& kinds) {
    Texture texture;
    Quadric& q = texture.quadric;
    for (double* c : {&q.a, &q.b, &q.e, &q.g, &q.i, &q.j})
        if (chance.bits() % 3 == 0) *c = chance.signed_unit();
    const std::size_t terms = chance.bits() % 4;
    for (std::size_t i = 0; i < terms; ++i) {
        NoiseTerm term = kinds[chance.bits() % kinds.size()].term;
        if (term.kind == NoiseKind::worley && chance.bits() % 4) term = kinds[0].term;  // slow
        if (chance.bits() % 2) term.range = NoiseRange(chance.bits() % 2);
        const double frequency = chance.bits() % 4 ? 4.0 : 60.0;
        term.frequency = frequency * chance.vector();
        term.phase = 10.0 * chance.vector();
        term.seed = chance.bits();
        if (term.octaves > 1) term.octaves = 1 + chance.bits() % 6;
        term.lacunarity = chance.pick(std::array{2.0, 2.0, 1.9});
        term.gain = chance.pick(std::array{0.5, 0.5, 0.7, 0.0});
        const double amplitude = chance.pick(std::array{0.0, 0.25, 1.0, 1.0});
        term.amplitude = amplitude * chance.signed_unit();
        texture.noise.push_back(term);
    }
    texture.colors.wrap = chance.bits() % 2 ? Wrap::clamp : Wrap::repeat;
    const std::size_t stops = 1 + chance.bits() % 5;
    Rgb8 color{};
    for (std::size_t i = 0; i < stops; ++i) {
        if (i == 0 || chance.bits() % 2)
            color = {std::uint8_t(chance.bits()), std::uint8_t(chance.bits()), 77};
        texture.colors.stops.push_back({double(i + 1) / double(stops + 1), color});
    }
    return texture;
}

Filter random_filter(Chance& chance) {
    if (chance.bits() % 2) return {FilterKind::none, 4, chance.bits() % 4 == 0};
    if (chance.bits() % 16 == 0) return {FilterKind::table_mip, 4, false};  // slow to set up
    constexpr std::array kinds{FilterKind::exact, FilterKind::trapezoid, FilterKind::trapezoid2,
                               FilterKind::supersample};
    return {kinds[chance.bits() % kinds.size()], 4, chance.bits() % 3 == 0};
}

TEST(Economy, ShowsInNoByteOfAThousandRecipesAtRandom) {
    const std::vector<NamedTerm> kinds = named_terms();
    const SolidAtlas solid = SyntheticAtlas{20, 7, 3.0, 0.05, true}.make(5);
    CachedSynthesis kept(solid, {}, large_cache);
    SynthesisWork with, bare;
    const auto compare = [&]<class Pixel>(std::uint32_t seed, Image<Pixel> image) {
        SCOPED_TRACE(seed);
        Chance chance(seed);
        const Texture texture = random_texture(chance, kinds);
        const Filter filter = random_filter(chance);
        const auto made = [&](const Skips& skips, SynthesisWork* work = nullptr) {
            return synthesize_model<Pixel>(solid, texture, {}, 1, filter, Kernel::automatic,
                                           {skips, work});
        };
        const Image<Pixel> expected = made(without_any(), &bare);
        ASSERT_EQ(made({}, &with), expected);
        ASSERT_EQ(made(without(Skip(seed % skip_names.size()))), expected);
        kept.synthesize(texture, 1, image, filter);
        ASSERT_EQ(image, expected);
    };
    // (8-bit colours need a table each, which takes most of the time.)
    for (std::uint32_t seed = 0; seed < 1000; ++seed) {
        if (seed % 10 == 0)
            compare(seed, Image<Rgb8>());
        else
            compare(seed, Image<RgbF>());
        if (HasFatalFailure()) return;
    }
    EXPECT_LT(with.octaves, bare.octaves);
    EXPECT_GT(with.texels, 0u);
}

TEST(Economy, AddsUpWhateverTheThreads) {
    const std::vector<NamedTerm> kinds = named_terms();
    const SolidAtlas solid = SyntheticAtlas{100, 7, 3.0, 0.05, true}.make(5);
    for (std::uint32_t seed = 0; seed < 10; ++seed) {
        Chance chance(seed);
        const Texture texture = random_texture(chance, kinds);
        const Filter filter = random_filter(chance);
        SynthesisWork one, many;
        synthesize_model<Rgb8>(solid, texture, {}, 1, filter, Kernel::automatic, {{}, &one});
        synthesize_model<Rgb8>(solid, texture, {}, 0, filter, Kernel::automatic, {{}, &many});
        EXPECT_EQ(one.texels, many.texels) << seed;
    }
}

TEST(EconomyOptions, NameTheSkips) {
    EconomyOptions options;
    EXPECT_EQ(options.skips(), Skips{});
    options.forbidden = {"zero-terms"};
    EXPECT_EQ(options.skips(), without(Skip::zero_terms));
    options.forbidden = {"stages", "all"};
    EXPECT_EQ(options.skips(), without_any());
}

TEST(EconomyOptions, KeepNothingForASingleTexture) {
    EconomyOptions options;
    EXPECT_EQ(options.cache_bytes(false), 0u);
    EXPECT_EQ(options.cache_bytes(true), std::size_t(1) << 30);
    options.cache_megabytes = 0.5;
    EXPECT_EQ(options.cache_bytes(false), std::size_t(1) << 19);
    EXPECT_EQ(options.cache_bytes(true), std::size_t(1) << 19);
}

}  // namespace
}  // namespace burl
