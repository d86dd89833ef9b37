// Undo and redo as a person meets them: one step for every gesture, nothing lost, nothing for
// gestures that change nothing.
#include "app/editor/session/history.h"

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
    history.mark_saved("r.json");
    EXPECT_FALSE(history.changed());
    history.undo();
    EXPECT_TRUE(history.changed());
    history.redo();
    EXPECT_FALSE(history.changed());
}

TEST(EditHistory, UndoBringsBackTheFileAndWhatItHolds) {
    EditHistory history(scaled(1), "marble");
    history.open(scaled(5), "five.json");
    EXPECT_EQ(history.path(), "five.json");
    EXPECT_FALSE(history.changed());
    history.undo();
    EXPECT_EQ(history.recipe(), scaled(1));
    EXPECT_EQ(history.path(), "marble");
    EXPECT_FALSE(history.changed());
    EXPECT_EQ(history.opened(), scaled(1));
    history.redo();
    EXPECT_EQ(history.path(), "five.json");
    EXPECT_EQ(history.opened(), scaled(5));
    history.change(scaled(6));
    EXPECT_TRUE(history.changed());
    EXPECT_EQ(history.opened(), scaled(5));
    EXPECT_EQ(history.opened_path(), "five.json");
}

TEST(EditHistory, AFileHasItsOwnNumberAndUndoTheOneBefore) {
    EditHistory history(scaled(1), "marble");
    const std::uint64_t first = history.document_number();
    history.open(scaled(2), "two.json");
    const std::uint64_t second = history.document_number();
    EXPECT_NE(first, second);
    history.undo();
    EXPECT_EQ(history.document_number(), first);
    history.open(scaled(3), "three.json");
    EXPECT_NE(history.document_number(), first);
    EXPECT_NE(history.document_number(), second);
}

TEST(EditHistory, WhatWasSavedKeepsItsNameInAllSteps) {
    EditHistory history(scaled(1), "marble");
    history.change(scaled(2));
    history.mark_saved("mine.json");
    EXPECT_EQ(history.path(), "mine.json");
    history.undo();
    EXPECT_EQ(history.path(), "mine.json");
    EXPECT_TRUE(history.changed()) << "the file holds the step after it";
    EXPECT_EQ(history.opened_path(), "marble");
}

TEST(EditHistory, AFileThatTwoStepsNameHoldsWhatWasSavedLast) {
    EditHistory history(scaled(1), "a.json");
    history.open(scaled(2), "b.json");
    history.mark_saved("./a.json");  // another spelling
    EXPECT_FALSE(history.changed());
    history.undo();
    EXPECT_TRUE(history.changed());
    history.mark_saved("a.json");
    EXPECT_FALSE(history.changed());
    history.redo();
    EXPECT_TRUE(history.changed());
}

TEST(EditHistory, OpeningAnotherRecipeSavesNothing) {
    EditHistory history(scaled(1), "marble");
    history.open(scaled(2), "wood");
    EXPECT_EQ(history.unsaved(), nullptr) << "nothing was changed";
    history.change(scaled(3));
    history.open(scaled(4), "checks");
    history.open(scaled(5), "stone");
    EXPECT_FALSE(history.changed());
    ASSERT_NE(history.unsaved(), nullptr);
    EXPECT_EQ(*history.unsaved(), scaled(3));
    history.change(scaled(6));
    EXPECT_EQ(*history.unsaved(), scaled(6)) << "the newest changes";
    history.undo();
    history.return_to_unsaved();
    EXPECT_EQ(history.recipe(), scaled(3));
    EXPECT_EQ(history.path(), "wood");
    history.undo();
    EXPECT_EQ(history.unsaved(), nullptr) << "the changes were taken back";
}

TEST(EditHistory, SavingIsWhatEndsIt) {
    EditHistory history(scaled(1), "marble");
    history.change(scaled(2));
    history.open(scaled(3), "wood");
    ASSERT_NE(history.unsaved(), nullptr);
    history.undo();
    history.mark_saved("mine.json");
    history.redo();
    EXPECT_EQ(history.unsaved(), nullptr) << "what was left is in its file now";
    history.change(scaled(4));
    history.open(scaled(5), "checks");
    ASSERT_NE(history.unsaved(), nullptr);
    history.mark_saved("five.json");
    ASSERT_NE(history.unsaved(), nullptr) << "wood has changes that are in no file";
    EXPECT_EQ(*history.unsaved(), scaled(4));
    history.return_to_unsaved();
    history.mark_saved("four.json");
    EXPECT_EQ(history.unsaved(), nullptr);
}

TEST(EditHistory, WhatWasLeftBehindWhatIsSavedIsStillUnsaved) {
    EditHistory history(scaled(1), "a.json");
    history.change(scaled(2));
    history.open(scaled(3), "b.json");
    history.change(scaled(4));
    history.open(scaled(5), "c.json");
    history.undo();
    history.mark_saved("b.json");
    history.redo();
    EXPECT_FALSE(history.changed());
    ASSERT_NE(history.unsaved(), nullptr) << "a.json has changes that are in no file";
    EXPECT_EQ(*history.unsaved(), scaled(2));
    history.return_to_unsaved();
    EXPECT_EQ(history.path(), "a.json");
    EXPECT_EQ(history.recipe(), scaled(2));
}

TEST(EditHistory, SavingAFileGivesUpWhatWasLeftOfIt) {
    EditHistory history(scaled(1), "wood");
    history.change(scaled(2));
    history.open(scaled(3), "r.json");
    history.change(scaled(4));
    history.open(scaled(5), "./r.json");  // as it is on disk
    ASSERT_NE(history.unsaved(), nullptr);
    EXPECT_EQ(*history.unsaved(), scaled(4)) << "until the file has something newer";
    history.change(scaled(6));
    history.mark_saved("r.json");
    ASSERT_NE(history.unsaved(), nullptr);
    EXPECT_EQ(*history.unsaved(), scaled(2)) << "the preset's changes are in no file";
    history.undo();
    history.undo();
    EXPECT_EQ(history.recipe(), scaled(4));
    EXPECT_TRUE(history.changed()) << "the file holds what came later";
    history.open(scaled(7), "s.json");
    EXPECT_EQ(*history.unsaved(), scaled(4)) << "undo has made it what is wanted";
}

TEST(EditHistory, SavingAFileGivesUpWhatWasLeftOfItBehindAnother) {
    EditHistory history(scaled(1), "r.json");
    history.change(scaled(2));
    history.open(scaled(3), "wood");
    history.change(scaled(4));
    history.open(scaled(5), "r.json");
    history.mark_saved("r.json");
    ASSERT_NE(history.unsaved(), nullptr);
    EXPECT_EQ(*history.unsaved(), scaled(4));
    history.return_to_unsaved();
    history.mark_saved("w.json");
    EXPECT_EQ(history.unsaved(), nullptr);
}

TEST(EditHistory, OpeningWhatIsOpenIsNoStep) {
    EditHistory history(scaled(1), "a.json");
    history.change(scaled(2));
    history.open(scaled(2), "a.json");  // somebody else wrote just that
    EXPECT_FALSE(history.changed());
    history.undo();
    EXPECT_EQ(history.recipe(), scaled(1));
    EXPECT_TRUE(history.changed());
}

TEST(EditHistory, WhatIsRecoveredBelongsToNoFile) {
    EditHistory history(scaled(1), "a.json");
    history.open_unsaved(scaled(1));
    EXPECT_EQ(history.path(), "");
    EXPECT_TRUE(history.changed());
    history.undo();
    EXPECT_EQ(history.path(), "a.json");
    EXPECT_FALSE(history.changed());
}

TEST(EditHistory, AFileThatSomebodyElseChangedHoldsNoStep) {
    EditHistory history(scaled(1), "a.json");
    history.change(scaled(2));
    history.forget_saved();
    history.undo();
    EXPECT_TRUE(history.changed());
    history.mark_saved("a.json");
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
