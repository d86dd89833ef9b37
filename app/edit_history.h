#pragma once
// Undo and redo of recipes, unlimited: the recipe is the whole user-visible state, so a step is a
// recipe. All changes of one gesture (a slider's drag) are one step.
#include <cstddef>
#include <vector>

#include "app/kept_recipe.h"

namespace burl {

class EditHistory {
  public:
    /// `recipe` counts as saved.
    explicit EditHistory(Recipe recipe);

    const Recipe& recipe() const { return now_; }
    /// Changes until end_gesture() are one step; gestures may be opened again while open.
    void begin_gesture() { in_gesture_ = true; }
    /// Nothing happens when the recipe ends as it began.
    void end_gesture();
    /// Inside a gesture the last change counts; outside it is a step of its own. Steps that were
    /// undone are forgotten.
    void change(Recipe recipe);
    bool in_gesture() const { return in_gesture_; }

    bool can_undo() const { return now_ != step_ || at_ > 0; }
    bool can_redo() const { return now_ == step_ && at_ + 1 < steps_.size(); }
    /// Ends an open gesture first, whose step is then the one undone.
    void undo();
    void redo();

    /// Whether the recipe is not the one last saved.
    bool changed() const { return now_ != saved_; }
    void mark_saved() { saved_ = now_; }

  private:
    void go_to(std::size_t step);

    std::vector<KeptRecipe> steps_;
    std::size_t at_ = 0;  ///< of `now_`, but for changes of an open gesture
    Recipe now_, saved_;
    Recipe step_;  ///< steps_[at_]
    bool in_gesture_ = false;
};

}  // namespace burl
