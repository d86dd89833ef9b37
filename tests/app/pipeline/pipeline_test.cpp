// A pipeline repeats what a recipe changes and nothing else, and has the bytes of one that starts
// anew.
#include "app/pipeline/pipeline.h"
#include "app/recipe/edit/recipe_json.h"

#include <thread>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "atlas/solid/level.h"
#include "tests/app/support/sample_scene.h"

namespace burl {
namespace {

constexpr std::size_t plenty = std::size_t(1) << 28;

Recipe changed_recipe(const std::vector<std::string>& settings,
                      const std::string& preset = "marble") {
    std::vector<std::string> all{"atlas.size=64"};
    all.insert(all.end(), settings.begin(), settings.end());
    return load_recipe(preset, all);
}

template <class Pixel = Rgb8>
Image<Pixel> baked_anew(const Recipe& recipe) {
    Pipeline pipeline(cube_mesh());
    pipeline.set_recipe(recipe);
    return pipeline.synthesize<Pixel>();
}

constexpr std::array counted_stages{Stage::connectivity, Stage::layout, Stage::spans,
                                    Stage::synthesis};

/// Runs of the counted stages.
using Runs = std::array<std::uint64_t, 4>;

Runs runs_of(const Pipeline& pipeline) {
    Runs runs{};
    for (std::size_t k = 0; k < runs.size(); ++k)
        runs[k] = pipeline.records()[counted_stages[k]].runs;
    return runs;
}

const std::string amplitude = "texture.input.noise.0.amplitude=0.75";

TEST(Pipeline, RepeatsFromWhereARecipeChanges) {
    const std::vector<std::pair<std::string, Runs>> cases{
        {"name=other", {1, 1, 1, 1}},
        {"bump.input={\"node\":\"fbm\"}", {1, 1, 1, 1}},
        {"texture.stops.0.1=#102030", {1, 1, 1, 2}},
        {amplitude, {1, 1, 1, 2}},
        {"solid.scale=3", {1, 1, 1, 2}},
        {"filter.kind=exact", {1, 1, 1, 2}},
        {"solid.space=object", {1, 1, 2, 2}},
        {"atlas.kind=quad", {1, 2, 2, 2}},
        {"atlas.size=32", {1, 2, 2, 2}},
    };
    for (const auto& [setting, runs] : cases) {
        SCOPED_TRACE(setting);
        Pipeline pipeline(cube_mesh());
        pipeline.set_cache(plenty);
        pipeline.set_recipe(changed_recipe({}));
        EXPECT_EQ(pipeline.synthesize<Rgb8>(), baked_anew(changed_recipe({})));
        const Recipe changed = changed_recipe({setting});
        pipeline.set_recipe(changed);
        EXPECT_EQ(pipeline.synthesize<Rgb8>(), baked_anew(changed));
        EXPECT_EQ(runs_of(pipeline), runs);
        for (std::size_t k = 0; k < runs.size(); ++k)
            EXPECT_EQ(pipeline.records()[counted_stages[k]].kept, 2 - runs[k])
                << stage_names[unsigned(counted_stages[k])];
    }
}

TEST(Pipeline, ForbiddenToKeepStagesRepeatsThemAll) {
    Pipeline pipeline(cube_mesh());
    Skips skips;
    skips.forbid(Skip::stages);
    pipeline.set_skips(skips);
    pipeline.set_cache(plenty);
    for (int i = 0; i < 3; ++i) {
        pipeline.set_recipe(changed_recipe({}));
        EXPECT_EQ(pipeline.synthesize<Rgb8>(), baked_anew(changed_recipe({})));
    }
    EXPECT_EQ(runs_of(pipeline), (Runs{3, 3, 3, 3}));
}

TEST(Pipeline, CountsWhatAnEditSpares) {
    const auto work_of_edit = [](const std::string& setting) {
        Pipeline pipeline(cube_mesh());
        pipeline.set_cache(plenty);
        pipeline.set_recipe(changed_recipe({}));
        pipeline.synthesize<Rgb8>();
        pipeline.set_recipe(changed_recipe({setting}));
        pipeline.synthesize<Rgb8>();
        return pipeline.records()[Stage::synthesis].last.work;
    };
    const auto skipped = [](const SynthesisWork& work) {
        return work.octaves_skipped[unsigned(Skip::kept_terms)];
    };
    const SynthesisWork whole = work_of_edit("solid.scale=3.5");
    EXPECT_GT(whole.texels, 2000u);
    EXPECT_EQ(whole.octaves, 4 * whole.texels);
    EXPECT_EQ(skipped(whole), 0u);
    for (const std::string& edit : {std::string("texture.stops.0.1=#102030"), amplitude}) {
        const SynthesisWork work = work_of_edit(edit);
        EXPECT_EQ(work.texels, whole.texels) << edit;
        EXPECT_EQ(work.octaves, 0u) << edit;
        EXPECT_EQ(skipped(work), whole.octaves) << edit;
    }
}

TEST(Pipeline, CountsWhatARecipeSparesThatIsTheSame) {
    Pipeline pipeline(cube_mesh());
    pipeline.set_cache(plenty);
    for (int i = 0; i < 3; ++i) {
        pipeline.set_recipe(changed_recipe({}));
        pipeline.synthesize<Rgb8>();
        pipeline.synthesize<Rgb8>();  // asked for twice, spared once
    }
    const StageRecord& record = pipeline.records()[Stage::synthesis];
    EXPECT_EQ(record.runs, 1u);
    EXPECT_EQ(record.kept, 2u);
    EXPECT_EQ(record.spared.work.texels, 2 * record.done.work.texels);
    EXPECT_EQ(record.spared.work.octaves, 8 * record.done.work.texels);
    EXPECT_EQ(record.spared.bytes, 2u * 64 * 64 * 3);
}

/// Four terms, of which one's phase moves.
Recipe four_terms(double phase) {
    std::string terms;
    for (int i = 0; i < 4; ++i)
        terms += fmt::format(R"({}{{"amplitude": 0.25, "seed": {}, "phase": [{}, 0, 0]}})",
                             i ? ", " : "", i, i == 2 ? phase : 0.0);
    return changed_recipe({fmt::format("texture.input.noise=[{}]", terms)});
}

TEST(Pipeline, APhaseTakesOneTermAnew) {
    Pipeline pipeline(cube_mesh());
    pipeline.set_cache(plenty);
    for (const double phase : {0.0, 0.1, 0.2, 0.3}) {
        pipeline.set_recipe(four_terms(phase));
        EXPECT_EQ(pipeline.synthesize<Rgb8>(), baked_anew(four_terms(phase)));
        const SynthesisWork& work = pipeline.records()[Stage::synthesis].last.work;
        EXPECT_EQ(work.octaves, (phase == 0.0 ? 4 : 1) * work.texels) << phase;
    }
}

TEST(Pipeline, KeepsNothingOfASingleBake) {
    Pipeline pipeline(cube_mesh());
    pipeline.set_recipe(changed_recipe({}));
    const Image<Rgb8> image = pipeline.synthesize<Rgb8>();
    EXPECT_EQ(pipeline.synthesize<Rgb8>(), image);
    EXPECT_EQ(pipeline.stages().texture.cached_bytes(), 0u);
    EXPECT_EQ(pipeline.records()[Stage::synthesis].runs, 2u);
}

TEST(Pipeline, FollowsEditsOfEveryKindWithinAnyCache) {
    const std::vector<Recipe> recipes{
        changed_recipe({}),
        changed_recipe({"texture.wrap=clamp"}),
        changed_recipe({"texture.wrap=clamp", "filter.kind=exact"}),
        changed_recipe({"filter.kind=exact"}),
        changed_recipe({"filter.kind=trapezoid"}),
        changed_recipe({"filter.kind=trapezoid", amplitude}),
        changed_recipe({"filter.kind=trapezoid2", amplitude}),
        changed_recipe({"filter.kind=trapezoid2", amplitude, "texture.wrap=clamp"}),
        changed_recipe({"filter.kind=table-mip"}),
        changed_recipe({"filter.octaves=fade"}),
        changed_recipe({"filter.octaves=fade", "texture.wrap=clamp"}),
        changed_recipe({"filter.kind=supersample", "filter.samples=4"}),
        changed_recipe({"precision.kind=float64"}),
        changed_recipe({}, "stripes"),
        changed_recipe({}, "wrinkled"),
        changed_recipe({"texture.wrap=clamp"}, "wrinkled"),
        changed_recipe({amplitude}),
    };
    for (const std::size_t cache : {std::size_t(1), 64 * 64 * 14 * std::size_t(4) / 3, plenty}) {
        Pipeline pipeline(cube_mesh());
        pipeline.set_cache(cache);
        for (std::size_t i = 0; i < recipes.size(); ++i) {
            SCOPED_TRACE(i);
            pipeline.set_recipe(recipes[i]);
            EXPECT_EQ(pipeline.synthesize<Rgb8>(), baked_anew(recipes[i]));
            EXPECT_LE(pipeline.stages().texture.cached_bytes(), cache);
            if (i % 4 != 0) continue;
            EXPECT_EQ(pipeline.synthesize<RgbF>(), baked_anew<RgbF>(recipes[i]));
            EXPECT_EQ(pipeline.synthesize<Rgb16>(), baked_anew<Rgb16>(recipes[i]));
        }
    }
}

TEST(Pipeline, AFilteredTexturesColoursNeedNoField) {
    for (const std::string filter : {"exact", "table-sat", "trapezoid2"}) {
        Pipeline pipeline(cube_mesh());
        pipeline.set_cache(plenty);
        pipeline.set_recipe(changed_recipe({"filter.kind=" + filter}));
        pipeline.synthesize<Rgb8>();
        pipeline.set_recipe(changed_recipe({"filter.kind=" + filter, "texture.stops.0.1=#102030"}));
        pipeline.synthesize<Rgb8>();
        const SynthesisWork& work = pipeline.records()[Stage::synthesis].last.work;
        EXPECT_EQ(work.octaves, 0u) << filter;
        EXPECT_GT(work.texels, 0u) << filter;
    }
}

TEST(Pipeline, MakesALevelAlone) {
    for (const std::size_t cache : {std::size_t(0), plenty}) {
        Pipeline pipeline(cube_mesh());
        pipeline.set_cache(cache);
        for (const std::string& setting : {std::string("name=marble"), amplitude}) {
            const Recipe recipe = changed_recipe({setting});
            pipeline.set_recipe(recipe);
            for (const std::uint32_t level : {2u, 0u}) {
                const Image<Rgb8> expected =
                    fill_texture<Rgb8>(solid_level(pipeline.solid(), level), recipe, {});
                EXPECT_EQ(pipeline.synthesize<Rgb8>(level), expected);
                EXPECT_EQ(*pipeline.picture<Rgb8>(level), expected);
                EXPECT_EQ(expected.width(), 64u >> level);
            }
        }
    }
}

TEST(Pipeline, AStopLosesNothingThatWasKept) {
    Pipeline pipeline(cube_mesh());
    pipeline.set_cache(plenty);
    pipeline.set_recipe(four_terms(0.0));
    ASSERT_NE(pipeline.picture<Rgb8>(), nullptr);
    std::stop_source stop;
    stop.request_stop();
    pipeline.set_recipe(four_terms(0.5));
    EXPECT_EQ(pipeline.picture<Rgb8>(0, stop.get_token()), nullptr);
    EXPECT_EQ(pipeline.records()[Stage::synthesis].stopped, 1u);
    EXPECT_EQ(pipeline.records()[Stage::synthesis].runs, 1u);
    const Image<Rgb8>* picture = pipeline.picture<Rgb8>();
    ASSERT_NE(picture, nullptr);
    EXPECT_EQ(*picture, baked_anew(four_terms(0.5)));
    const SynthesisWork& work = pipeline.records()[Stage::synthesis].last.work;
    EXPECT_EQ(work.octaves, work.texels);
}

TEST(Pipeline, StopsWheneverAnotherThreadAsks) {
    const std::vector<Recipe> recipes{
        four_terms(0.0), four_terms(0.5), changed_recipe({}, "stripes"),
        changed_recipe({"filter.kind=exact"}), changed_recipe({"precision.kind=float64"})};
    std::vector<Image<Rgb8>> expected;
    for (const Recipe& recipe : recipes) expected.push_back(baked_anew(recipe));
    Pipeline pipeline(cube_mesh());
    pipeline.set_cache(plenty);
    for (std::size_t i = 0; i < 40; ++i) {
        const std::size_t k = i % recipes.size();
        pipeline.set_recipe(recipes[k]);
        std::stop_source stop;
        const std::jthread other([&] {
            std::this_thread::sleep_for(std::chrono::microseconds(40 * i));
            stop.request_stop();
        });
        const Image<Rgb8>* picture = pipeline.picture<Rgb8>(0, stop.get_token());
        if (picture) {
            EXPECT_EQ(*picture, expected[k]) << i;
        }
        if (i % 3 == 0) {
            EXPECT_EQ(*pipeline.picture<Rgb8>(), expected[k]) << i;
        }
    }
}

TEST(Pipeline, KeepsNormalsWhileTheBumpsStay) {
    const auto bumpy = [](const std::string& setting) {
        return changed_recipe({"bump.input={\"node\":\"fbm\"}", setting});
    };
    const auto anew = [](const Recipe& recipe) {
        Pipeline pipeline(cube_mesh());
        pipeline.set_recipe(recipe);
        return pipeline.normal_map<Rgb8>(40.0, true);
    };
    Pipeline pipeline(cube_mesh());
    pipeline.set_cache(plenty);
    const std::vector<std::pair<std::string, std::uint64_t>> runs{
        {"name=x", 1}, {amplitude, 1}, {"bump.height=0.02", 2}, {"solid.scale=2", 3}};
    for (const auto& [setting, count] : runs) {
        pipeline.set_recipe(bumpy(setting));
        EXPECT_EQ(pipeline.normal_map<Rgb8>(40.0, true), anew(bumpy(setting))) << setting;
        EXPECT_EQ(pipeline.records()[Stage::normals].runs, count) << setting;
    }
    pipeline.normal_map<Rgb8>(40.0, false);
    EXPECT_EQ(pipeline.records()[Stage::normals].runs, 4u);
    EXPECT_EQ(pipeline.normal_map<Rgb8>(40.0, true), anew(bumpy("solid.scale=2")));
}

}  // namespace
}  // namespace burl
