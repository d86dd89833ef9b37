#include "app/edit_history.h"

#include <utility>

namespace burl {

EditHistory::EditHistory(Recipe recipe)
    : steps_{KeptRecipe(recipe)}, now_(recipe), saved_(recipe), step_(std::move(recipe)) {}

void EditHistory::end_gesture() {
    in_gesture_ = false;
    if (now_ == step_) return;
    steps_.erase(steps_.begin() + std::ptrdiff_t(at_) + 1, steps_.end());
    steps_.emplace_back(now_, steps_[at_]);
    step_ = now_;
    ++at_;
}

void EditHistory::go_to(std::size_t step) {
    at_ = step;
    now_ = step_ = steps_[at_].recipe();
}

void EditHistory::change(Recipe recipe) {
    now_ = std::move(recipe);
    if (!in_gesture_) end_gesture();
}

void EditHistory::undo() {
    end_gesture();
    if (at_ > 0) go_to(at_ - 1);
}

void EditHistory::redo() {
    end_gesture();
    if (at_ + 1 < steps_.size()) go_to(at_ + 1);
}

}  // namespace burl
