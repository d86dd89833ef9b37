// Undo and redo as a person meets them: one step for every gesture, nothing lost, nothing for
// gestures that change nothing.
#include "app/edit_history.h"

#include <gtest/gtest.h>

namespace burl {
namespace {

Recipe scaled(double scale) {
    Recipe recipe;
    recipe.solid.scale = scale;
    return recipe;
}

TEST(EditHistory, ADragIsOneStep) {
    EditHistory history(scaled(1));
    history.begin_gesture();
    for (int i = 2; i < 50; ++i) history.change(scaled(i));
    EXPECT_EQ(history.recipe(), scaled(49));
    history.end_gesture();
    ASSERT_TRUE(history.can_undo());
    history.undo();
    EXPECT_EQ(history.recipe(), scaled(1));
    EXPECT_FALSE(history.can_undo());
    history.redo();
    EXPECT_EQ(history.recipe(), scaled(49));
    EXPECT_FALSE(history.can_redo());
}

TEST(EditHistory, AGestureThatEndsWhereItBeganIsNoStep) {
    EditHistory history(scaled(1));
    history.begin_gesture();
    history.change(scaled(2));
    history.change(scaled(1));
    history.end_gesture();
    EXPECT_FALSE(history.can_undo());
}

TEST(EditHistory, UndoInTheMiddleOfAGestureTakesTheGestureBack) {
    EditHistory history(scaled(1));
    history.change(scaled(2));
    history.begin_gesture();
    history.change(scaled(3));
    history.undo();
    EXPECT_EQ(history.recipe(), scaled(2));
    history.undo();
    EXPECT_EQ(history.recipe(), scaled(1));
    history.undo();
    EXPECT_EQ(history.recipe(), scaled(1));
    history.redo();
    history.redo();
    EXPECT_EQ(history.recipe(), scaled(3));
}

TEST(EditHistory, AChangeAfterUndoForgetsWhatWasUndone) {
    EditHistory history(scaled(1));
    history.change(scaled(2));
    history.change(scaled(3));
    history.undo();
    history.change(scaled(4));
    EXPECT_FALSE(history.can_redo());
    history.undo();
    EXPECT_EQ(history.recipe(), scaled(2));
}

TEST(EditHistory, ChangedIsAgainstWhatWasSaved) {
    EditHistory history(scaled(1));
    EXPECT_FALSE(history.changed());
    history.change(scaled(2));
    EXPECT_TRUE(history.changed());
    history.mark_saved();
    EXPECT_FALSE(history.changed());
    history.undo();
    EXPECT_TRUE(history.changed());
    history.redo();
    EXPECT_FALSE(history.changed());
}

TEST(EditHistory, StepsShareTheStrokesOfPaintThatTheyHaveInCommon) {
    Recipe recipe;
    const KeptRecipe empty(recipe);
    recipe.paint.resize(3);
    recipe.paint[1].points.resize(5, Vec3d(1.0));
    const KeptRecipe three(recipe, empty);
    EXPECT_EQ(three.shared_strokes(), 0u);
    recipe.paint.resize(4);
    recipe.paint[2].radius = 7.0;
    const KeptRecipe four(recipe, three);
    EXPECT_EQ(four.shared_strokes(), 2u);
    EXPECT_EQ(four.recipe(), recipe);
    EditHistory history(Recipe{});
    history.change(three.recipe());
    history.change(four.recipe());
    history.undo();
    EXPECT_EQ(history.recipe(), three.recipe());
    history.redo();
    EXPECT_EQ(history.recipe(), four.recipe());
}

}  // namespace
}  // namespace burl
