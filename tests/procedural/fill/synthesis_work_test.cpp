// Counts of what syntheses do: whole numbers, known beforehand from the atlas and the texture.
#include <gtest/gtest.h>

#include <numeric>

#include "atlas/base/json.h"
#include "procedural/fill/graph.h"
#include "procedural/fill/synthesize.h"
#include "procedural/graph/json.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

constexpr Affine3 identity{Mat3d(1.0), Vec3d(0.0)};

Texture two_terms() {
    Texture texture;
    NoiseTerm smooth, distances;
    smooth.octaves = 3;
    distances.kind = NoiseKind::worley, distances.octaves = 2;  // no kernel knows it
    texture.noise = {smooth, distances};
    texture.colors.stops = {{0.0, {0, 0, 0}}, {1.0, {255, 255, 255}}};
    return texture;
}

std::uint64_t texels_in_spans(const SolidAtlas& solid) {
    return std::accumulate(solid.spans.begin(), solid.spans.end(), std::uint64_t(0),
                           [](std::uint64_t sum, const Span& span) { return sum + span.count; });
}

/// With blocks that nobody owns.
SolidAtlas atlas_with_gaps() {
    return SyntheticAtlas{64, 16, 0.0, 0.02, true}.make(3);
}

TEST(SynthesisWork, CountsTexelsAndOctaves) {
    const SolidAtlas solid = atlas_with_gaps();
    const std::uint64_t texels = texels_in_spans(solid);
    ASSERT_LT(texels, 64u * 64u);
    for (const int threads : {1, 3})
        for (const FilterKind kind :
             {FilterKind::none, FilterKind::exact, FilterKind::supersample}) {
            SynthesisWork work;
            const Filter filter{kind, 4};
            synthesize_model<Rgb8>(solid, two_terms(), identity, threads, filter, Kernel::automatic,
                                   {{}, &work});
            EXPECT_EQ(work.texels, texels);
            EXPECT_EQ(work.octaves, 5 * texels * (kind == FilterKind::supersample ? 4 : 1));
            EXPECT_EQ(work.texels_skipped[unsigned(Skip::unread_texels)], 64 * 64 - texels);
        }
}

TEST(SynthesisWork, CountsOctavesThatTexelsCannotShow) {
    Texture texture = two_terms();
    for (NoiseTerm& term : texture.noise) term.frequency = Vec3d(1.0), term.octaves = 8;
    const SolidAtlas solid = atlas_with_gaps();
    const Filter filter{FilterKind::none, 1, true};
    SynthesisWork limited, all;
    Economy economy{{}, &all};
    economy.skips.forbid(Skip::band_limit);
    const auto image = synthesize_model<Rgb16>(solid, texture, identity, 2, filter,
                                               Kernel::automatic, {{}, &limited});
    EXPECT_EQ(
        synthesize_model<Rgb16>(solid, texture, identity, 2, filter, Kernel::automatic, economy),
        image);
    EXPECT_EQ(all.octaves, 16 * texels_in_spans(solid));
    const std::uint64_t skipped = limited.octaves_skipped[unsigned(Skip::band_limit)];
    EXPECT_EQ(limited.octaves + skipped, all.octaves);
    EXPECT_GT(skipped, all.octaves / 8);
    EXPECT_LT(skipped, all.octaves / 2);
}

TEST(SynthesisWork, CountsTermsWithoutAmplitude) {
    const SolidAtlas solid = atlas_with_gaps();
    Texture texture = two_terms();
    texture.noise[1].gain = 0.0;  // its second octave
    NoiseTerm silent;
    silent.amplitude = 0.0, silent.octaves = 4;
    texture.noise.insert(texture.noise.begin() + 1, silent);
    Texture idle = texture;
    idle.noise.erase(idle.noise.begin() + 1);
    const std::uint64_t texels = texels_in_spans(solid);
    for (const FilterKind kind : {FilterKind::none, FilterKind::exact, FilterKind::supersample}) {
        const std::uint64_t samples = kind == FilterKind::supersample ? 4 : 1;
        SynthesisWork some, all;
        Economy economy{{}, &all, {}};
        economy.skips.forbid(Skip::zero_terms);
        const Filter filter{kind, 4};
        const auto image = synthesize_model<RgbF>(solid, texture, identity, 2, filter,
                                                  Kernel::automatic, {{}, &some, {}});
        EXPECT_EQ(
            synthesize_model<RgbF>(solid, texture, identity, 2, filter, Kernel::automatic, economy),
            image);
        EXPECT_EQ(synthesize_model<RgbF>(solid, idle, identity, 2, filter), image);
        EXPECT_EQ(some.octaves, 4 * texels * samples);
        EXPECT_EQ(some.octaves_skipped[unsigned(Skip::zero_terms)], 5 * texels * samples);
        EXPECT_EQ(all.octaves, 9 * texels * samples);
    }
}

TEST(SynthesisWork, PaintsTexelsThatNobodyReadsOneByOneIfAsked) {
    const SolidAtlas solid = atlas_with_gaps();
    SynthesisWork work;
    Economy economy{{}, &work, {}};
    economy.skips.forbid(Skip::unread_texels);
    EXPECT_EQ(
        synthesize_model<Rgb8>(solid, two_terms(), identity, 2, {}, Kernel::automatic, economy),
        synthesize_model<Rgb8>(solid, two_terms(), identity, 2));
    EXPECT_EQ(work.texels, 64u * 64u);
    EXPECT_EQ(work.texels_skipped, SynthesisWork{}.texels_skipped);
}

TEST(SynthesisWork, CountsTheOctavesOfGraphs) {
    const TextureGraph graph = graph_from_json(nlohmann::ordered_json::parse(
        R"({"node": "mix", "a": {"node": "fbm", "octaves": 5},
            "b": {"node": "wrinkled", "octaves": 3}, "amount": {"node": "fbm", "octaves": 5}})"));
    const SolidAtlas solid = atlas_with_gaps();
    const std::uint64_t texels = texels_in_spans(solid);
    SynthesisWork work;
    synthesize_graph<Rgb8>(solid, graph, identity, {}, 2, PrecisionKind::float32, {{}, &work});
    EXPECT_EQ(work.texels, texels);
    EXPECT_EQ(work.octaves, 8 * texels);  // equal subtrees count once
    EXPECT_EQ(work.texels_skipped[unsigned(Skip::unread_texels)], 64 * 64 - texels);
}

}  // namespace
}  // namespace burl
