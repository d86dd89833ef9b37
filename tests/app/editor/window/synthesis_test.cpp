// The texture on screen by OpenGL, and the papers' passes one by one.
#include <cstdio>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/editor/window/fixture.h"

namespace burl {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class GlEditSynthesisTest : public GlEditProgramTest {
  protected:
    std::unique_ptr<EditorProgram> start_by(EditSynthesis by, const std::string& recipe = "marble",
                                            const std::vector<std::string>& settings = {}) {
        EditorOptions options;
        options.light = "headlight";
        options.mesh = "sample:cube";
        options.recipe = recipe;
        options.settings = {"atlas.size=64", "atlas.tries=1", "atlas.kind=quad"};
        options.settings.insert(options.settings.end(), settings.begin(), settings.end());
        options.gallery = false;
        options.synthesis = by;
        if (!context) context = create_test_context();
        auto editor = std::make_unique<EditorProgram>(
            create_unseen_window(std::move(context), {800, 640}), options);
        play(*editor, R"({"settle": true}, {"wait": 2})");
        return editor;
    }

    /// The share of pixels that differ from `before` by more than 3 codes.
    static double share_away(EditorProgram& editor, const Image<Rgb8>& before) {
        const Image<Rgb8> now = settled(editor);
        std::size_t away = 0;
        for (std::size_t i = 0; i < now.pixels().size(); ++i) {
            const Rgb8 a = now.pixels()[i], b = before.pixels()[i];
            away += std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)}) > 3;
        }
        return double(away) / double(now.pixels().size());
    }
};

const std::vector<std::string> value_noise{"texture.input.noise.0.kind=value",
                                           "texture.input.noise.0.fade=smooth",
                                           "texture.input.noise.0.octaves=1"};

TEST_F(GlEditSynthesisTest, OpenGlShowsWhatTheHostShows) {
    for (const char* recipe : {"marble", "oak", "hammered"}) {
        SCOPED_TRACE(recipe);
        const Image<Rgb8> host = settled(*start_by(EditSynthesis::host, recipe));
        auto editor = start_by(EditSynthesis::gl, recipe);
        ASSERT_TRUE(editor->shown());
        EXPECT_TRUE(editor->shown()->resident.pictures);
        EXPECT_EQ(editor->shown()->by, "OpenGL");
        EXPECT_LT(share_away(*editor, host), 0.002);
    }
}

TEST_F(GlEditSynthesisTest, AnEditIsSeen) {
    auto editor = start_by(EditSynthesis::gl);
    const Image<Rgb8> before = settled(*editor);
    ASSERT_TRUE(editor->session().set(std::vector<std::string>{"texture.input.noise.0.seed=7"}));
    EXPECT_GT(share_away(*editor, before), 0.01);
    EXPECT_TRUE(editor->shown()->resident.pictures);
}

/// Software OpenGL runs where the host runs. A graphics processor is timed, and what was measured
/// agrees with who makes the texture.
TEST_F(GlEditSynthesisTest, AutoIsTheHostOnSoftwareAndElseTheFasterOne) {
    auto editor = start_by(EditSynthesis::automatic);
    const bool by_gl = editor->shown()->resident.pictures != nullptr;
    const std::string& words = editor->shown()->by;
    RecordProperty("by", words);
    if (words == "the host") {  // software, which is not timed
        EXPECT_FALSE(by_gl);
        return;
    }
    double gl = 0.0, host = 0.0;
    const std::string measured = words.substr(words.find(": ") + 2);
    ASSERT_EQ(std::sscanf(measured.c_str(), "OpenGL %lf ms, host %lf ms", &gl, &host), 2) << words;
    EXPECT_THAT(words, StartsWith(by_gl ? "OpenGL: " : "the host: "));
    EXPECT_TRUE(by_gl ? gl <= host : gl >= host);
}

TEST_F(GlEditSynthesisTest, WhatOpenGlCannotMakeTheHostMakesAndSaysWhy) {
    auto editor = start_by(EditSynthesis::gl, "marble", {"precision.kind=float64"});
    EXPECT_FALSE(editor->shown()->resident.pictures);
    EXPECT_THAT(editor->shown()->by, HasSubstr("float32"));
    EXPECT_TRUE(editor->items().find("synthesis badge"));
}

TEST_F(GlEditSynthesisTest, PassesAreWalkedThrough) {
    auto editor = start_by(EditSynthesis::passes, "marble", value_noise);
    ASSERT_TRUE(editor->shown()->resident.pass);
    EXPECT_EQ(editor->shown()->resident.pass->words, "colour");
    EXPECT_EQ(editor->shown()->resident.pass->number, 65u);
    const Image<Rgb8> finished = settled(*editor);
    play(*editor, R"({"click": "pass before"}, {"settle": true}, {"wait": 2})");
    EXPECT_EQ(editor->shown()->resident.pass->number, 64u);
    EXPECT_EQ(editor->shown()->resident.pass->words, "field index: index");
    EXPECT_GT(share_away(*editor, finished), 0.05);
    play(*editor, R"({"click": "pass after"}, {"settle": true}, {"wait": 2})");
    EXPECT_EQ(editor->shown()->resident.pass->number, 65u);
}

TEST_F(GlEditSynthesisTest, TheMenuChooses) {
    auto editor = start_by(EditSynthesis::host);
    EXPECT_FALSE(editor->shown()->resident.pictures);
    play(*editor, R"({"click": "menu:View"}, {"click": "menu:Texture by"}, {"wait": 2},
                     {"click": "menu:OpenGL"}, {"settle": true}, {"wait": 2})");
    EXPECT_TRUE(editor->shown()->resident.pictures);
    play(*editor, R"({"click": "menu:View"}, {"click": "menu:Texture by"}, {"wait": 2},
                     {"click": "menu:Host"}, {"settle": true}, {"wait": 2})");
    EXPECT_FALSE(editor->shown()->resident.pictures);
}

}  // namespace
}  // namespace burl
