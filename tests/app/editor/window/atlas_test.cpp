// The view of the atlas and the lines over the object as a person uses them, without a display.
#include "app/editor/window/atlas.h"

#include <gtest/gtest.h>

#include "app/editor/jobs/export.h"
#include "tests/app/editor/window/fixture.h"

namespace burl {
namespace {

class EditAtlasTest : public GlEditProgramTest {
  protected:
    static ItemRect view(EditorProgram& editor) { return *editor.items().find("atlas view"); }
    /// Moves the pointer and lets the marks follow.
    static void point(EditorProgram& editor, const glm::dvec2& at) {
        play(editor, R"({"events": [{"move": [)" + std::to_string(at.x) + "," +
                         std::to_string(at.y) + R"(]}]}, {"wait": 2})");
    }
    static std::size_t different_within(const Image<Rgb8>& a, const Image<Rgb8>& b,
                                        const ItemRect& rect) {
        std::size_t count = 0;
        for (auto y = std::size_t(rect.low.y); y < std::size_t(rect.high.y); ++y)
            for (auto x = std::size_t(rect.low.x); x < std::size_t(rect.high.x); ++x)
                count += a(x, y) != b(x, y);
        return count;
    }
};

TEST_F(EditAtlasTest, NothingOfItIsMadeWhileItIsHidden) {
    const auto editor = start();
    const Image<Rgb8> before = settled(*editor);
    EXPECT_FALSE(editor->baker().front().sheet());
    EXPECT_FALSE(editor->atlas().lines());
    EXPECT_FALSE(editor->items().find("atlas view"));
    const auto runs = editor->baker().front().records()[Stage::synthesis].runs;
    play(*editor, R"({"key": "V"}, {"settle": true}, {"wait": 2})");
    EXPECT_TRUE(editor->baker().front().sheet());
    EXPECT_TRUE(editor->items().find("atlas view"));
    EXPECT_FALSE(editor->atlas().picture());  // the texture needs none of its own
    play(*editor, R"({"click": "menu:View"}, {"wait": 2}, {"click": "menu:Atlas"}, {"wait": 2})");
    EXPECT_FALSE(editor->baker().front().sheet());
    EXPECT_FALSE(editor->atlas().lines());
    EXPECT_EQ(editor->baker().front().records()[Stage::synthesis].runs, runs);
    EXPECT_EQ(different(*editor, before), 0u);
}

TEST_F(EditAtlasTest, EveryModeIsAnotherPictureAndTheTextureIsTheObjects) {
    const auto editor = start();
    play(*editor, R"({"resize": [1400, 640]}, {"wait": 2})");  // room for the modes in a row
    play(*editor, R"({"key": "V"}, {"settle": true})");
    const Image<Rgb8> texture = settled(*editor);
    // The middle of the view is the middle of the texture.
    const glm::dvec2 middle = view(*editor).middle();
    const Rgb8 seen = texture(std::size_t(middle.x + 1), std::size_t(middle.y + 1)),
               texel = editor->baker().front().picture()->texels(32, 32);
    EXPECT_NEAR(seen.r, texel.r, 1);
    EXPECT_NEAR(seen.b, texel.b, 1);
    std::vector<Image<Rgb8>> seen_before{texture};
    for (const char* mode : {"solid", "charts", "scale", "error"}) {
        play(*editor, std::string(R"({"click": "atlas mode )") + mode + R"("}, {"settle": true})");
        const Image<Rgb8> now = settled(*editor);
        for (const Image<Rgb8>& other : seen_before)
            EXPECT_GT(different_within(now, other, view(*editor)), 10000u) << mode;
        seen_before.push_back(now);
    }
    play(*editor, R"({"click": "atlas mode texture"}, {"settle": true})");
    EXPECT_EQ(different(*editor, texture), 0u);
}

TEST_F(EditAtlasTest, LevelsWheelAndFitChangeTheView) {
    const auto editor = start();
    play(*editor, R"({"resize": [1400, 640]}, {"wait": 2})");  // room for the modes in a row
    play(*editor, R"({"key": "V"}, {"click": "atlas mode charts"}, {"settle": true})");
    const Image<Rgb8> whole = settled(*editor);
    play(*editor, R"({"drag": "atlas level", "by": [400, 0]})");
    const Image<Rgb8> coarsest = settled(*editor);
    EXPECT_GT(different_within(whole, coarsest, view(*editor)), 5000u);
    play(*editor, R"({"drag": "atlas level", "by": [-400, 0]})");
    EXPECT_EQ(different_within(whole, settled(*editor), view(*editor)), 0u);
    const EditCamera camera = editor->camera();
    play(*editor,
         R"({"wheel": "atlas view", "by": [0, 6]}, {"drag": "atlas view", "by": [60, 0]})");
    EXPECT_GT(different_within(whole, settled(*editor), view(*editor)), 5000u);
    EXPECT_EQ(editor->camera(), camera);
    point(*editor, view(*editor).middle());
    play(*editor, R"({"key": "F"})");
    EXPECT_EQ(different_within(whole, settled(*editor), view(*editor)), 0u);
    play(*editor, R"({"wheel": "atlas view", "by": [0, 6]}, {"double_click": "atlas view"})");
    EXPECT_EQ(different_within(whole, settled(*editor), view(*editor)), 0u);
}

TEST_F(EditAtlasTest, APointerOnTheOneIsMarkedInTheOther) {
    const auto editor = start();
    play(*editor, R"({"key": "V"}, {"settle": true})");
    const Image<Rgb8> plain = settled(*editor);
    const ItemRect object = *editor->items().find("object"), atlas = view(*editor);
    point(*editor, object.middle());
    ASSERT_TRUE(editor->atlas().on_object());
    EXPECT_FALSE(editor->atlas().on_atlas());
    const SurfaceHit hit = *editor->atlas().on_object();
    EXPECT_GT(different_within(plain, editor->screenshot(), atlas), 20u);
    // Where that mark is, a pointer on the atlas finds the same place of the object.
    const glm::dvec2 size = atlas.high - atlas.low;
    point(*editor, atlas.low + pixel_at({}, size, hit.uv));
    ASSERT_TRUE(editor->atlas().on_atlas());
    EXPECT_FALSE(editor->atlas().on_object());
    // The pointer stands on whole pixels.
    const SurfaceHit found = *editor->atlas().on_atlas();
    EXPECT_LT(glm::distance(found.uv, hit.uv) * std::min(size.x, size.y), 1.5);
    EXPECT_LT(glm::distance(found.point, hit.point), 0.05);
    EXPECT_GT(different_within(plain, editor->screenshot(), object), 20u);
    EXPECT_EQ(different(*editor, plain), 0u);
}

TEST_F(EditAtlasTest, FollowsASliderWhileItMoves) {
    const auto editor = start();
    play(*editor, R"({"key": "V"}, {"click": "tab:Parameters"}, {"settle": true})");
    const Image<Rgb8> before = settled(*editor);
    const glm::dvec2 at = editor->items().find("solid.scale")->middle();
    point(*editor, at);
    const std::string x = std::to_string(at.x + 40), y = std::to_string(at.y);
    play(*editor, R"({"events": [{"button": 0, "down": true}]}, {"events": [{"move": [)" + x + "," +
                      y + R"(]}]}, {"settle": true}, {"wait": 2})");
    ASSERT_TRUE(editor->session().history().in_gesture());
    EXPECT_GT(different_within(before, editor->screenshot(), view(*editor)), 3000u);
    play(*editor, R"({"events": [{"button": 0, "down": false}]}, {"key": "Ctrl+Z"})");
    EXPECT_EQ(different_within(before, settled(*editor), view(*editor)), 0u);
}

TEST_F(EditAtlasTest, ErrorsAreThoseOfTheRecipeOnTheScreen) {
    const auto editor = start();
    play(*editor, R"({"resize": [1400, 640]}, {"wait": 2})");  // room for the modes in a row
    play(*editor, R"({"key": "V"}, {"click": "atlas mode error"}, {"settle": true}, {"wait": 2})");
    const auto of = [&] {
        Pipeline pipeline(load_mesh("sample:cube"));
        pipeline.set_recipe(editor->session().recipe());
        return texture_error(pipeline.solid(), pipeline.recipe(), pipeline.synthesize<Rgb8>(), {});
    };
    ASSERT_TRUE(editor->atlas().picture());
    EXPECT_EQ(editor->atlas().picture()->codes, of()->codes);
    play(*editor, R"({"click": "tab:Parameters"}, {"wait": 2},
        {"drag": "texture.input.noise.0.amplitude", "by": [30, 0]}, {"settle": true}, {"wait": 2})");
    EXPECT_EQ(editor->atlas().picture()->codes, of()->codes);
    EXPECT_EQ(editor->atlas().picture()->largest, of()->largest);
    EXPECT_EQ(editor->atlas().picture()->rms, of()->rms);
}

TEST_F(EditAtlasTest, LinesAreDrawnOverTheObjectOnDemand) {
    const auto editor = start();
    const Image<Rgb8> plain = settled(*editor);
    play(*editor, R"({"key": "W"}, {"settle": true})");
    const Image<Rgb8> edges = settled(*editor);
    EXPECT_GT(differing(plain, edges), 300u);
    play(*editor, R"({"key": "B"}, {"settle": true})");
    const Image<Rgb8> both = settled(*editor);
    EXPECT_GT(differing(edges, both), 300u);
    play(*editor, R"({"key": "W"}, {"settle": true})");
    EXPECT_GT(differing(both, settled(*editor)), 50u);
    play(*editor, R"({"click": "menu:View"}, {"wait": 2}, {"click": "menu:Chart borders"})");
    EXPECT_EQ(different(*editor, plain), 0u);
    EXPECT_FALSE(editor->atlas().lines());
}

}  // namespace
}  // namespace burl
