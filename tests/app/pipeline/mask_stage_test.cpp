// Images of masks are made once, kept as long as they may be, and read by textures, levels, bands,
// materials and bumps; what has no texels refuses masks.
#include <set>
#include <stop_token>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "app/export/emit.h"
#include "app/measure/evaluate_points.h"
#include "app/measure/texture_error.h"
#include "app/pipeline/pipeline.h"
#include "app/pipeline/texture_color.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/error.h"
#include "tests/app/pipeline/mask_cases.h"

namespace burl {
namespace {

using testing::HasSubstr;
using Settings = std::vector<std::string>;

const char* const worn = R"({"node": "mix", "a": {"node": "fbm"}, "b": "#ff8040", "amount":
    {"node": "add", "a": {"node": "curvature", "radius": 0.1}, "b": {"node": "occlusion"}}})";

TEST(MaskStage, ThreadsDoNotMatter) {
    const auto with_threads = [](int threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                        std::size_t(threads));
        Pipeline pipeline(ring_and_plate());
        pipeline.set_threads(threads);
        pipeline.set_recipe(mask_recipe(worn));
        return pipeline.synthesize<Rgb16>();
    };
    EXPECT_EQ(with_threads(1), with_threads(4));
}

TEST(MaskStage, LengthsBeyondReasonGiveNumbers) {
    for (const char* scale : {"1e-6", "1e6"})
        for (const char* length : {"1e-6", "1e6"})
            for (const auto& [node, key] :
                 {std::pair("curvature", "radius"), std::pair("occlusion", "distance"),
                  std::pair("thickness", "distance"), std::pair("edge_distance", "farthest"),
                  std::pair("lighting", "distance")}) {
                Pipeline pipeline(made::nasty());
                pipeline.set_recipe(
                    mask_recipe(fmt::format(R"({{"node": "{}", "{}": {}}})", node, key, length),
                                {fmt::format("solid.scale={}", scale), "atlas.size=64"}));
                const Image<RgbF> picture = pipeline.synthesize<RgbF>();
                for (const RgbF& texel : picture.pixels())
                    ASSERT_TRUE(std::isfinite(texel.r)) << node << scale << length;
            }
}

TEST(MaskStage, StayUntilTheyChange) {
    for (const std::size_t cache : {std::size_t(0), std::size_t(1) << 26}) {
        Pipeline pipeline(ring_and_plate());
        pipeline.set_cache(cache);
        const auto runs_with = [&](const Settings& settings) {
            const Recipe recipe = mask_recipe(worn, settings);
            pipeline.set_recipe(recipe);
            Pipeline anew(ring_and_plate());
            anew.set_recipe(recipe);
            EXPECT_EQ(pipeline.synthesize<Rgb8>(), anew.synthesize<Rgb8>());
            return pipeline.records()[Stage::masks].runs;
        };
        EXPECT_EQ(runs_with({}), 2u);
        EXPECT_EQ(runs_with({"texture.b=#4080ff"}), 2u);
        EXPECT_EQ(runs_with({"texture.b=#4080ff", "solid.rotate=[1,2,3]"}), 2u);
        EXPECT_EQ(runs_with({"texture.amount.a.radius=0.2"}), 3u);
        EXPECT_EQ(runs_with({"texture.amount.a.radius=0.2", "texture.amount.a.gives=convex"}), 3u);
        EXPECT_EQ(runs_with({"solid.scale=0.5", "texture.amount.a.radius=0.1"}), 3u);  // the same
        EXPECT_EQ(runs_with({"solid.scale=2"}), 4u);  // occlusion has no length
        EXPECT_EQ(runs_with({"atlas.size=64"}), 6u);
        EXPECT_EQ(runs_with({"atlas.size=64", "solid.space=object"}), 8u);
        EXPECT_EQ(runs_with({"atlas.size=64", "solid.space=object", "texture.amount=0"}), 8u);
        EXPECT_EQ(runs_with({"atlas.size=64", "solid.space=object"}), 10u);
    }
}

TEST(MaskStage, WhatNothingReadsIsNotMade) {
    Pipeline pipeline(cube_mesh());
    pipeline.set_recipe(parse_recipe(R"({"atlas": {"size": 64}, "texture": {"node": "fbm"},
        "material": {"roughness": {"node": "facing"}}, "define": {"idle": {"node": "occlusion"}}})",
                                     "r"));
    pipeline.synthesize<Rgb8>();
    EXPECT_EQ(pipeline.records()[Stage::masks].runs, 0u);
    PicturePlan plan;
    for (PictureComponent& one : plan.components)
        one.plane = PlaneLayout(pipeline.recipe().texture).of(Channel::roughness);
    const auto pictures = pipeline.pictures<RgbaF>({plan});
    EXPECT_EQ(pipeline.records()[Stage::masks].runs, 1u);
    std::set<float> cosines;
    for (const RgbaF& texel : pictures[0].pixels()) cosines.insert(std::round(texel.r * 1e6f));
    EXPECT_EQ(cosines, (std::set<float>{-1e6f, 0.0f, 1e6f}));
}

TEST(MaskStage, AStopLeavesNothingThatIsNotWhole) {
    const Recipe recipe = mask_recipe(R"({"node": "occlusion", "rays": 64})");
    Pipeline anew(ring_and_plate());
    anew.set_recipe(recipe);
    const Image<Rgb8> whole = anew.synthesize<Rgb8>();
    Pipeline pipeline(ring_and_plate());
    pipeline.set_recipe(recipe);
    static_cast<void>(pipeline.solid());
    std::stop_source before;
    before.request_stop();
    EXPECT_EQ(pipeline.picture<Rgb8>(0, before.get_token()), nullptr);
    EXPECT_EQ(pipeline.records()[Stage::masks].runs, 0u);
    // A request while rays are traced, whenever that is: stopped, or done in time.
    std::stop_source during;
    std::jthread stopper([&] { during.request_stop(); });
    const Image<Rgb8>* shown = pipeline.picture<Rgb8>(0, during.get_token());
    if (shown) {
        EXPECT_EQ(*shown, whole);
    }
    const Image<Rgb8>* after = pipeline.picture<Rgb8>();
    ASSERT_NE(after, nullptr);
    EXPECT_EQ(*after, whole);
    EXPECT_EQ(pipeline.records()[Stage::masks].runs, 1u);
}

TEST(MaskStage, GradientsAreMadeWhereSomethingTakesThem) {
    Pipeline pipeline(ring_and_plate());
    const auto bytes_with = [&](const Settings& settings) {
        pipeline.set_recipe(mask_recipe(R"({"node": "occlusion", "rays": 4})", settings));
        static_cast<void>(pipeline.synthesize<Rgb8>());
        return pipeline.records()[Stage::masks].last.bytes;
    };
    const std::uint64_t values = 128 * 128 * 4;
    EXPECT_EQ(bytes_with({}), values);
    EXPECT_EQ(bytes_with({"filter.kind=trapezoid"}), 4 * values);
    EXPECT_EQ(bytes_with({}), 4 * values);  // those there are will do
    EXPECT_EQ(pipeline.records()[Stage::masks].runs, 2u);
    EXPECT_EQ(bytes_with({R"(texture={"node":"part"})", "filter.kind=trapezoid"}), values);
    EXPECT_EQ(bytes_with({R"(bump.input={"node":"occlusion","rays":4})"}), 4 * values);
}

TEST(MaskStage, BandsAreTheWhole) {
    Pipeline pipeline(ring_and_plate());
    pipeline.set_recipe(mask_recipe(worn));
    const Image<RgbF> whole = pipeline.synthesize<RgbF>();
    std::size_t rows = 0;
    pipeline.synthesize_in_bands(
        [&](std::size_t first, const Image<RgbF>& band) {
            for (std::size_t y = 0; y < band.height(); ++y, ++rows)
                ASSERT_TRUE(std::ranges::equal(band.row(y), whole.row(first + y)));
        },
        128 * 16);
    EXPECT_EQ(rows, 128u);
    EXPECT_EQ(pipeline.records()[Stage::masks].runs, 2u);
}

TEST(MaskStage, DirectLevelsHaveTheMaskAtTheirOwnTexels) {
    Pipeline pipeline(cube_mesh());
    pipeline.set_recipe(
        mask_recipe(R"({"node": "facing", "direction": [1, 0, 0]})", {"atlas.kind=quad"}));
    const Image<RgbF> level = pipeline.level(1, {.direct = true, .samples = 1});
    const Image<RgbF>* shown = pipeline.picture<RgbF>(1);
    const SolidAtlas& solid = pipeline.solid(1);
    ASSERT_EQ(level.width(), 64u);
    ASSERT_TRUE(shown);
    std::size_t texels = 0;
    for (std::uint32_t y = 0; y < solid.size; ++y)
        for (const Span& span : solid.row(y))
            for (std::uint32_t x = span.x; x < span.x + span.count; ++x, ++texels) {
                const auto [a, b, c] = pipeline.mesh().triangles[solid.triangle_of(span.map)];
                const auto& p = pipeline.mesh().positions;
                const Vec3d normal = glm::normalize(glm::cross(p[b] - p[a], p[c] - p[a]));
                ASSERT_NEAR(level(x, y).r, normal.x, 1e-6);
                ASSERT_EQ((*shown)(x, y).r, level(x, y).r);
            }
    EXPECT_GT(texels, 2000u);
}

TEST(MaskStage, BumpsReadThem) {
    const auto normals = [](const std::string& height) {
        Pipeline pipeline(drawn_sheet());
        pipeline.set_recipe(mask_recipe(R"({"node": "constant", "value": 0.5})",
                                        {"bump.input=" + height, "bump.height=0.1"}));
        return pipeline.normal_map<Rgb16>(40.0, true);
    };
    // A plane faces its own normal by 1 everywhere.
    const auto plain = normals(R"({"node":"fbm","octaves":2})");
    EXPECT_EQ(normals(R"({"node":"multiply","a":{"node":"fbm","octaves":2},
        "b":{"node":"facing","direction":[0,0,1]}})"),
              plain);
    EXPECT_NE(normals(R"({"node":"multiply","a":{"node":"fbm","octaves":2},
        "b":{"node":"facing","direction":[0,1,1]}})"),
              plain);
}

/// The sentence of the Error(unsupported) that `work` throws.
template <class Work>
std::string refusal(const Work& work) {
    try {
        work();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::unsupported);
        return error.what();
    }
    ADD_FAILURE();
    return "";
}

TEST(MaskStage, WhatHasNoTexelsRefusesThem) {
    const Recipe recipe = mask_recipe(R"({"node": "add", "a": {"node": "fbm"},
        "b": {"node": "curvature"}})");
    const std::string why = "its node \"curvature\" is worked out from the mesh at the texels";
    EXPECT_THAT(refusal([&] { texture_color(recipe); }), HasSubstr("texture: " + why));
    EXPECT_THAT(refusal([&] { filtered_color(recipe, FilterKind::none); }), HasSubstr(why));
    EXPECT_THAT(refusal([&] { emit_glsl(recipe, {}); }), HasSubstr(why));
    EXPECT_THAT(no_reference(recipe, Box3{}), HasSubstr(why));
    PointFile file;
    file.dimensions = 3;
    file.points.push_back({0.0, 0.0, 0.0, 0.0});
    EXPECT_THAT(refusal([&] { evaluate_points(recipe, file); }), HasSubstr(why));
    const Recipe bumpy = mask_recipe(R"({"node": "constant", "value": 0.5})",
                                     {R"(bump.input={"node":"thickness"})"});
    EXPECT_THAT(refusal([&] { bumped_normals(bumpy, cube_mesh()); }),
                HasSubstr("bump.input: its node \"thickness\""));
    // What only another channel reads is no reason.
    EXPECT_NO_THROW(
        texture_color(parse_recipe(R"({"texture": {"node": "fbm"}, "material": {"roughness":
            {"node": "curvature"}}})",
                                   "r")));
}

TEST(MaskStage, RecipesHoldThem) {
    for (const std::string& texture :
         {std::string(worn), std::string(R"({"node": "mesh_uv", "input": {"node": "part",
            "piece": "part", "seed": 3}})"),
          std::string(R"({"node": "thickness", "distance": 0.5})")}) {
        const Recipe recipe = mask_recipe(texture);
        EXPECT_EQ(parse_recipe(to_json(recipe), "r"), recipe);
    }
    try {
        mask_recipe(R"({"node": "abs", "input": {"node": "facing", "direction": [0, 0, 0]}})");
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("texture.input.direction is [0,0,0], must have a "
                                            "number that is not 0"));
    }
}

}  // namespace
}  // namespace burl
