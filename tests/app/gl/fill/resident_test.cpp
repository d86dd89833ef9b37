// Pictures made where they are shown are the host's to one code.
#include "app/gl/fill/resident.h"

#include <cstdlib>
#include <set>
#include <thread>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/pipeline/material.h"
#include "app/pipeline/pipeline.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/surface/sample_meshes.h"
#include "app/surface/tangents.h"
#include "tests/app/gl/device/fixture.h"

namespace burl {
namespace {

/// How the codes of a texture differ from the host's.
struct Away {
    int most = 0;        ///< the largest difference of a code
    double share = 0.0;  ///< of codes that differ
};

template <class Pixel>
Away away(const std::vector<std::uint8_t>& drawn, const Image<Pixel>& host) {
    Away result;
    std::size_t differing = 0, n = 0;
    for (const Pixel& pixel : host.pixels()) {
        const auto codes = reinterpret_cast<const std::uint8_t*>(&pixel);
        for (std::size_t c = 0; c < sizeof(Pixel); ++c, ++n) {
            const int difference = std::abs(int(drawn[n / sizeof(Pixel) * 4 + c]) - int(codes[c]));
            result.most = std::max(result.most, difference);
            differing += difference != 0 ? 1 : 0;
        }
    }
    result.share = double(differing) / double(n);
    return result;
}

class GlResidentTest : public GlTest {
  protected:
    std::vector<std::uint8_t> read(const GlTexture& texture, int level, int side) {
        const GladGLContext& gl = context->gl();
        std::vector<std::uint8_t> codes(std::size_t(side) * std::size_t(side) * 4);
        gl.BindTexture(GL_TEXTURE_2D, texture.get());
        gl.GetTexImage(GL_TEXTURE_2D, level, GL_RGBA, GL_UNSIGNED_BYTE, codes.data());
        return codes;
    }

    void expect_hosts(const Recipe& recipe) {
        SCOPED_TRACE(recipe.name);
        Pipeline pipeline(sample_mesh("sample:teapot"));
        pipeline.set_recipe(recipe);
        std::vector<PicturePlan> plans;
        for (const MaterialPicture& picture : material_pictures(recipe, Packing::gltf))
            plans.push_back(picture.plan);
        GlPictureMaker maker(*context);
        ASSERT_EQ(maker.problem(recipe), "");
        const auto pictures = maker.make(pipeline.solid(), recipe, plans);
        ASSERT_EQ(pictures->images.size(), 1 + plans.size());
        expect_near(away(read(pictures->images[0], 0, pictures->side), *pipeline.picture<Rgb8>()));
        if (plans.empty()) return;
        const auto host = pipeline.pictures<Rgba8>(plans);
        for (std::size_t i = 0; i < plans.size(); ++i)
            expect_near(away(read(pictures->images[i + 1], 0, pictures->side), host[i]));
    }

    /// Sharp edges may fall on the other side of a texel in float32.
    static void expect_near(const Away& away) {
        EXPECT_LE(away.share, 0.01);
        if (away.share > 1e-4) {
            EXPECT_LE(away.most, 1);
        }
    }
};

TEST_F(GlResidentTest, ColoursAreTheHosts) {
    for (const char* name : {"marble", "wood", "clouds"})
        expect_hosts(load_recipe(name, {"atlas.size=128", "atlas.kind=quad"}));
}

TEST_F(GlResidentTest, ChannelsAreTheHosts) {
    for (const char* name : {"oak", "rust", "gold"})
        expect_hosts(load_recipe(name, {"atlas.size=64", "atlas.kind=quad"}));
}

/// Normals are within two codes of the host's, but for texels at sharp rises.
TEST_F(GlResidentTest, BumpsAreTheHosts) {
    for (const char* name : {"hammered", "orange-peel", "hammered-copper", "brick-wall"}) {
        SCOPED_TRACE(name);
        const Recipe recipe = load_recipe(name, {"atlas.size=128", "atlas.kind=quad"});
        ASSERT_FALSE(recipe.bump.empty());
        Pipeline pipeline(sample_mesh("sample:teapot"));
        pipeline.set_recipe(recipe);
        GlPictureMaker maker(*context);
        ASSERT_TRUE(maker.makes_bumps(recipe));
        EXPECT_EQ(maker.make(pipeline.solid(), recipe, {})->images.size(), 1u);
        const NormalFrames frames = make_normal_frames(pipeline.mesh(), pipeline.mesh_atlas(),
                                                       {recipe.solid.space, 60.0, true});
        maker.set_frames(frame_maps(pipeline.solid(),
                                    {pipeline.atlas_mesh(), pipeline.atlas(), frames.positions,
                                     frames.normals, frames.tangents},
                                    0));
        const auto pictures = maker.make(pipeline.solid(), recipe, {});
        ASSERT_EQ(pictures->images.size(), 2u);
        const auto drawn = read(pictures->images[1], 0, pictures->side);
        const Image<Rgb8> host = pipeline.normal_map<Rgb8>(60.0, true);
        std::size_t far = 0, bumped = 0;
        for (std::size_t i = 0; i < host.pixels().size(); ++i) {
            const Rgb8 h = host.pixels()[i];
            bumped += std::abs(h.r - 128) > 3 || std::abs(h.g - 128) > 3;
            far += std::abs(h.r - drawn[4 * i]) > 2 || std::abs(h.g - drawn[4 * i + 1]) > 2 ||
                   std::abs(h.b - drawn[4 * i + 2]) > 2;
        }
        EXPECT_GT(bumped, host.pixels().size() / 20);
        EXPECT_LT(far, host.pixels().size() / 200);
    }
}

TEST_F(GlResidentTest, PaintIsTheHostsAndGoes) {
    Recipe recipe = load_recipe("marble", {"atlas.size=64", "atlas.kind=quad"});
    PaintStroke stroke;
    stroke.points = {Vec3d(0.0), Vec3d(0.5, 0.1, 0.0)};
    stroke.radius = 0.3;
    stroke.color = {200, 30, 20};
    recipe.paint = {stroke};
    Pipeline pipeline(sample_mesh("sample:cube"));
    pipeline.set_recipe(recipe);
    GlPictureMaker maker(*context);
    const auto painted = maker.make(pipeline.solid(), recipe, {});
    const auto codes = read(painted->images[0], 0, 64);
    expect_near(away(codes, *pipeline.picture<Rgb8>()));
    recipe.paint.clear();
    pipeline.set_recipe(recipe);
    const auto plain = maker.make(pipeline.solid(), recipe, {});
    EXPECT_NE(read(plain->images[0], 0, 64), codes);
    expect_near(away(read(plain->images[0], 0, 64), *pipeline.picture<Rgb8>()));
    recipe.paint = {stroke};
    recipe.paint[0].layer = 1;  // a mask's, which shows no colour
    pipeline.set_recipe(recipe);
    const auto masked = maker.make(pipeline.solid(), recipe, {});
    EXPECT_EQ(read(masked->images[0], 0, 64), read(plain->images[0], 0, 64));
    recipe.paint = {stroke};
    recipe.paint[0].radius = 0.1;
    pipeline.set_recipe(recipe);
    const auto again = maker.make(pipeline.solid(), recipe, {});
    expect_near(away(read(again->images[0], 0, 64), *pipeline.picture<Rgb8>()));
}

TEST_F(GlResidentTest, PresetsThatAreFilteredAreTheHosts) {
    for (const char* preset : {"checks", "checker-floor", "dots", "stripes"}) {
        SCOPED_TRACE(preset);
        const Recipe recipe = load_recipe(preset, {"atlas.size=64", "atlas.kind=quad"});
        ASSERT_NE(recipe.filter.kind, FilterKind::none);
        Pipeline pipeline(sample_mesh("sample:cube"));
        pipeline.set_recipe(recipe);
        GlPictureMaker maker(*context);
        if (!maker.problem(recipe).empty()) continue;  // the host's, then
        const auto made = maker.make(pipeline.solid(), recipe, {});
        const Away off = away(read(made->images[0], 0, 64), *pipeline.picture<Rgb8>());
        EXPECT_LE(off.share, 0.01) << off.most << " codes, at the poles of a mapping";
    }
}

TEST_F(GlResidentTest, LevelsAreMeansInLinearLight) {
    const Recipe recipe = load_recipe("checks", {"atlas.size=64", "atlas.kind=quad"});
    Pipeline pipeline(sample_mesh("sample:cube"));
    pipeline.set_recipe(recipe);
    GlPictureMaker maker(*context);
    const auto pictures = maker.make(pipeline.solid(), recipe, {});
    const auto fine = read(pictures->images[0], 0, 64), coarse = read(pictures->images[0], 1, 32);
    for (std::size_t y = 0; y < 32; ++y)
        for (std::size_t x = 0; x < 32; ++x) {
            double light = 0.0;
            for (const std::size_t at : {128 * y + 2 * x, 128 * y + 2 * x + 1, 128 * y + 64 + 2 * x,
                                         128 * y + 64 + 2 * x + 1})
                light += srgb_decode(fine[4 * at] / 255.0) / 4.0;
            EXPECT_NEAR(coarse[4 * (32 * y + x)], 255.0 * srgb_encode(light), 2.0);
        }
}

/// Pictures that are shown are never drawn over.
TEST_F(GlResidentTest, PicturesInUseStay) {
    const Recipe marble = load_recipe("marble", {"atlas.size=32", "atlas.kind=quad"});
    const Recipe wood = load_recipe("wood", {"atlas.size=32", "atlas.kind=quad"});
    Pipeline pipeline(sample_mesh("sample:cube"));
    pipeline.set_recipe(marble);
    GlPictureMaker maker(*context);
    auto first = maker.make(pipeline.solid(), marble, {});
    const auto codes = read(first->images[0], 0, 32);
    const auto second = maker.make(pipeline.solid(), wood, {});
    EXPECT_NE(second, first);
    EXPECT_EQ(read(first->images[0], 0, 32), codes);
    const auto* const released = first.get();
    first.reset();
    EXPECT_EQ(maker.make(pipeline.solid(), marble, {}).get(), released);
}

/// While a slider moves, nothing is compiled, and every texture is the host's (expect_hosts above).
TEST_F(GlResidentTest, RecipesThatDifferInNumbersShareAProgram) {
    const std::vector<std::string> base{"atlas.size=32", "atlas.kind=quad"};
    Pipeline pipeline(sample_mesh("sample:cube"));
    pipeline.set_recipe(load_recipe("marble", base));
    GlPictureMaker maker(*context);
    const auto codes_at = [&](const char* recipe, const std::string& path, double value) {
        std::vector<std::string> settings = base;
        settings.push_back(fmt::format("{}={}", path, value));
        const auto made = maker.make(pipeline.solid(), load_recipe(recipe, settings), {});
        return read(made->images[0], 0, 32);
    };
    const std::pair<const char*, const char*> sliders[] = {
        {"marble", "texture.input.noise.0.amplitude"},
        {"marble", "texture.input.noise.0.frequency.0"},
        {"marble", "solid.scale"},
        {"oak", "ring spacing"}};
    for (const auto& [recipe, path] : sliders) {
        const auto first = codes_at(recipe, path, 0.011);
        const std::size_t before = maker.programs();
        std::set<std::vector<std::uint8_t>> all{first};
        for (const double value : {0.0123, 0.013, 0.016, 0.0171, 0.019})
            all.insert(codes_at(recipe, path, value));
        EXPECT_EQ(maker.programs(), before) << path;
        EXPECT_EQ(all.size(), 6u) << path << ": the numbers have no effect";
    }
}

TEST_F(GlResidentTest, ProblemsAreClauses) {
    GlPictureMaker maker(*context);
    EXPECT_NE(maker.problem(load_recipe("oak", {"filter.kind=trapezoid"})), "");
    EXPECT_NE(maker.problem(load_recipe("marble", {"precision.kind=float64"})), "");
    EXPECT_EQ(maker.problem(load_recipe("oak")), "");
    GlPassMaker passes(*context);
    EXPECT_NE(passes.problem(load_recipe("oak")), "");
}

/// Another thread's context makes them; this one shows them.
TEST_F(GlResidentTest, AreSharedBetweenThreads) {
    const Recipe recipe = load_recipe("marble", {"atlas.size=64", "atlas.kind=quad"});
    Pipeline pipeline(sample_mesh("sample:cube"));
    pipeline.set_recipe(recipe);
    const std::unique_ptr<GlContext> other = context->share();
    std::unique_ptr<GlPictureMaker> maker;
    std::shared_ptr<const GlPictures> pictures;
    std::thread([&] {
        const CurrentContext current(*other);
        maker = std::make_unique<GlPictureMaker>(*other);
        pictures = maker->make(pipeline.solid(), recipe, {});
    }).join();
    expect_near(away(read(pictures->images[0], 0, 64), *pipeline.picture<Rgb8>()));
    pictures.reset();
    std::thread([&] {
        const CurrentContext current(*other);
        maker.reset();
    }).join();
}

TEST_F(GlResidentTest, PassesCanBeSeenOneByOne) {
    const Recipe recipe = load_recipe(
        "marble", {"atlas.size=64", "atlas.kind=quad", "texture.input.noise.0.kind=value",
                   "texture.input.noise.0.octaves=1", "texture.input.noise.0.fade=smooth"});
    Pipeline pipeline(sample_mesh("sample:cube"));
    pipeline.set_recipe(recipe);
    GlPassMaker maker(*context);
    ASSERT_EQ(maker.problem(recipe), "");
    const auto all = maker.make(pipeline.solid(), recipe, 10000);
    EXPECT_EQ(maker.shown().words, "colour");
    EXPECT_EQ(maker.shown().number, 65u);  // one octave by the hash, with the S-curve, and colours
    EXPECT_EQ(maker.shown().count, 65u);
    expect_near(away(read(all->images[0], 0, 64), *pipeline.picture<Rgb8>()));
    const auto finished = read(all->images[0], 0, 64);
    const auto first = maker.make(pipeline.solid(), recipe, 1);
    EXPECT_EQ(maker.shown().words, "cells: integers");
    EXPECT_EQ(maker.shown().number, 1u);
    const auto early = read(first->images[0], 0, 64);
    EXPECT_NE(early, finished);
    const auto last_but_one = maker.make(pipeline.solid(), recipe, 64);
    EXPECT_EQ(maker.shown().words, "field index: index");
    EXPECT_NE(read(last_but_one->images[0], 0, 64), early);
}

}  // namespace
}  // namespace burl
