// Controls in the editor: sliders above all others, whose drags are one step of what --set does.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/base/atomic_file.h"
#include "app/recipe/edit/controls.h"
#include "app/recipe/edit/leaves.h"
#include "app/recipe/edit/recipe_json.h"
#include "tests/app/editor/window/fixture.h"
#include "tests/app/recipe/edit/control_samples.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

class GlEditControls : public GlEditProgramTest {
  protected:
    const ScratchFolder folder;

    std::unique_ptr<EditorProgram> start_with(const char* json) {
        write_file(folder / "r.json", json);
        auto editor = start(folder / "r.json");
        play(*editor, R"({"click": "tab:Parameters"}, {"wait": 2})");
        return editor;
    }
};

TEST_F(GlEditControls, ADragIsOneStepOfAllThatIsSet) {
    const auto editor = start_with(test::planks_json);
    const Recipe before = editor->session().recipe();
    play(*editor, R"({"drag": "size", "by": [30, 0]}, {"settle": true})");
    const Recipe after = editor->session().recipe();
    EXPECT_GT(after.solid.scale, before.solid.scale);
    EXPECT_EQ(after, load_recipe(folder / "r.json", {"atlas.size=64", "atlas.tries=1",
                                                     fmt::format("size={}", after.solid.scale)}));
    EXPECT_NEAR(after.bump.height, 0.001 / after.solid.scale, 1e-12);
    play(*editor, R"({"key": "Ctrl+Z"})");
    EXPECT_EQ(editor->session().recipe(), before);
    EXPECT_FALSE(editor->session().history().can_undo());
}

TEST_F(GlEditControls, SlidersKeepToTheRangeAndGoBackToWhatWasOpened) {
    const auto editor = start_with(test::planks_json);
    play(*editor, R"({"drag": "width", "by": [900, 0]}, {"drag": "detail", "by": [-900, 0]})");
    EXPECT_EQ(
        editor->session().recipe(),
        load_recipe(folder / "r.json", {"atlas.size=64", "atlas.tries=1", "width=1", "detail=1"}));
    play(*editor, R"({"wait": 30}, {"double_click": "width"}, {"wait": 30},
                     {"double_click": "detail"}, {"wait": 2})");
    EXPECT_EQ(editor->session().recipe(),
              load_recipe(folder / "r.json", {"atlas.size=64", "atlas.tries=1"}));
}

TEST_F(GlEditControls, AWideRangeHasItsGeometricMeanInTheMiddle) {
    const auto editor = start_with(test::planks_json);
    ASSERT_TRUE(editor->session().set(std::vector<std::string>{"size=3"}));
    play(*editor, R"({"wait": 30}, {"click": "size"}, {"wait": 2})");
    EXPECT_NEAR(editor->session().recipe().solid.scale, std::sqrt(0.05 * 5), 0.02);
    play(*editor, R"({"wait": 30}, {"click": "detail"}, {"wait": 2})");
    const double middle = control_states(slider_json(editor->session().recipe()))[3].value;
    EXPECT_NEAR(middle, 4.5, 0.5) << "a narrow one its mean, rounded";
}

TEST_F(GlEditControls, SavedRecipesKeepTheirControls) {
    const auto editor = start_with(test::paint_json);
    play(*editor, R"({"drag": "flake size", "by": [20, 0]})");
    editor->session().save_recipe(folder / "saved.json");
    const Recipe saved = load_recipe(folder / "saved.json");
    EXPECT_EQ(saved, editor->session().recipe());
    EXPECT_EQ(saved.controls.size(), 3u);
    EXPECT_EQ(saved.group, "glaze");
}

TEST_F(GlEditControls, AreNotThereWithoutAny) {
    const auto editor = start();
    play(*editor, R"({"click": "tab:Parameters"}, {"wait": 2})");
    EXPECT_ANY_THROW(play(*editor, R"({"click": "group:controls"})"));
}

}  // namespace
}  // namespace burl
