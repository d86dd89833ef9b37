// Painting in the editor by pointer and keys, without a display, and a hand's strokes.
#include "app/editor/panels/paint.h"

#include <gtest/gtest.h>

#include "tests/app/editor/window/fixture.h"

namespace burl {
namespace {

TEST(PaintTool, LeadsAStrokeOnAndBreaksItWhereTheSurfaceIsFar) {
    PaintTool tool;
    tool.brush.radius = 0.1;
    Recipe recipe = painted_at({}, tool, {0, 0, 0}, false);
    ASSERT_EQ(recipe.paint.size(), 1u);
    EXPECT_EQ(painted_at(recipe, tool, {0.01, 0, 0}, true), recipe);  // hardly moved
    recipe = painted_at(recipe, tool, {0.05, 0, 0}, true);
    recipe = painted_at(recipe, tool, {0.1000004, 0, 0}, true);
    ASSERT_EQ(recipe.paint.size(), 1u);
    EXPECT_EQ(recipe.paint[0].points, (std::vector<Vec3d>{{0, 0, 0}, {0.05, 0, 0}, {0.1, 0, 0}}));
    recipe = painted_at(recipe, tool, {0.1, 0, 5}, true);
    ASSERT_EQ(recipe.paint.size(), 2u);
    recipe = painted_at(recipe, tool, {0.1, 0, 5.05}, false);
    ASSERT_EQ(recipe.paint.size(), 3u);
    EXPECT_EQ(recipe.paint[2].radius, 0.1);
}

TEST(PaintTool, RadiiStayWithinWhatAHandMayChoose) {
    PaintTool tool;
    EXPECT_NEAR(resized(tool, 2).brush.radius, 1.21 * tool.brush.radius, 1e-12);
    EXPECT_EQ(resized(tool, 100).brush.radius, largest_brush_radius);
    EXPECT_EQ(resized(tool, -100).brush.radius, least_brush_radius);
}

TEST(PaintTool, ACircleIsRoundAndInItsPlane) {
    for (const Vec3d& normal : {Vec3d(0, 0, 2), Vec3d(-3, 0.1, 0), Vec3d(1, -2, 3)}) {
        const std::vector<Vec3d> points = circle({1, 2, 3}, normal, 0.5, 12);
        ASSERT_EQ(points.size(), 12u);
        Vec3d sum(0.0);
        for (const Vec3d& p : points) {
            EXPECT_NEAR(glm::distance(p, Vec3d(1, 2, 3)), 0.5, 1e-12);
            EXPECT_NEAR(glm::dot(p - Vec3d(1, 2, 3), normal), 0.0, 1e-12);
            sum += p;
        }
        EXPECT_LT(glm::length(sum - 12.0 * Vec3d(1, 2, 3)), 1e-9);
    }
}

class EditPaintTest : public GlEditProgramTest {
  protected:
    static constexpr const char* stroke = R"({"drag": "object", "by": [90, 20], "frames": 6})";

    static const std::vector<PaintStroke>& paint(EditorProgram& editor) {
        return editor.session().recipe().paint;
    }
    static std::uint64_t runs(EditorProgram& editor, Stage stage) {
        return editor.baker().front().records()[stage].runs;
    }
};

TEST_F(EditPaintTest, ADragPaintsTheSurfaceUnderThePointerAsOneStep) {
    const auto editor = start();
    play(*editor, R"({"key": "P"}, {"wait": 2})");
    const Image<Rgb8> before = settled(*editor);
    const EditCamera camera = editor->camera();
    const std::uint64_t syntheses = runs(*editor, Stage::synthesis);
    play(*editor, stroke);
    EXPECT_EQ(editor->camera(), camera);
    ASSERT_FALSE(paint(*editor).empty());
    std::size_t points = 0;
    for (const PaintStroke& s : paint(*editor))
        for (const Vec3d& p : s.points) {
            // The unit box of a cube: one coordinate is a half, the others less.
            EXPECT_NEAR(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}), 0.5, 2e-6);
            ++points;
        }
    EXPECT_GT(points, 10u);
    EXPECT_GT(different(*editor, before), 500u);
    // No texel of the texture below was made again, and the screen's is what a bake has.
    EXPECT_EQ(runs(*editor, Stage::synthesis), syntheses);
    EXPECT_GT(runs(*editor, Stage::paint), 2u);
    Pipeline pipeline(load_mesh("sample:cube"));
    pipeline.set_recipe(editor->session().recipe());
    ASSERT_TRUE(editor->baker().front().picture());
    EXPECT_EQ(editor->baker().front().picture()->texels, pipeline.synthesize<Rgb8>());
    play(*editor, R"({"key": "Ctrl+Z"})");
    EXPECT_TRUE(paint(*editor).empty());
    EXPECT_FALSE(editor->session().history().can_undo());
    EXPECT_EQ(different(*editor, before), 0u);
    play(*editor, R"({"key": "Ctrl+Y"})");
    EXPECT_FALSE(paint(*editor).empty());
}

TEST_F(EditPaintTest, BesideTheObjectAndWithoutTheModeTheCameraTurns) {
    const auto editor = start();
    play(*editor, stroke);
    EXPECT_TRUE(paint(*editor).empty());
    const EditCamera turned = editor->camera();
    play(*editor, R"({"key": "P"}, {"wait": 2},
        {"events": [{"move": [30, 460]}]}, {"events": [{"button": 0, "down": true}]},
        {"events": [{"move": [90, 450]}]}, {"events": [{"button": 0, "down": false}]},
        {"wait": 2})");
    EXPECT_TRUE(paint(*editor).empty());
    EXPECT_NE(editor->camera(), turned);
}

TEST_F(EditPaintTest, TheWindowSetsTheBrushErasesAndClears) {
    const auto editor = start();
    play(*editor,
         std::string(R"({"key": "P"}, {"wait": 2}, {"drag": "paint.opacity", "by": [-40, 0]},
        {"key": "Period"}, {"key": "Period"},)") +
             stroke);
    ASSERT_FALSE(paint(*editor).empty());
    const PaintStroke first = paint(*editor)[0];
    EXPECT_LT(first.opacity, 0.9);
    EXPECT_NEAR(first.radius, 1.21 * PaintTool{}.brush.radius, 1e-9);
    EXPECT_EQ(first.mode, PaintMode::paint);
    play(*editor, std::string(R"({"key": "X"},)") + stroke);
    EXPECT_EQ(paint(*editor).back().mode, PaintMode::erase);
    const std::vector<PaintStroke> all = paint(*editor);
    play(*editor, R"({"click": "paint.clear"}, {"wait": 2})");
    EXPECT_TRUE(paint(*editor).empty());
    play(*editor, R"({"key": "Ctrl+Z"})");
    EXPECT_EQ(paint(*editor), all);
    play(*editor,
         R"({"click": "menu:Edit"}, {"wait": 2}, {"click": "menu:Clear paint"}, {"wait": 2})");
    EXPECT_TRUE(paint(*editor).empty());
}

}  // namespace
}  // namespace burl
