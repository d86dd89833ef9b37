#include "app/edit_history.h"

#include <utility>

namespace burl {

EditHistory::EditHistory(Recipe recipe) : steps_{recipe}, now_(recipe), saved_(std::move(recipe)) {}

void EditHistory::end_gesture() {
    in_gesture_ = false;
    if (now_ == steps_[at_]) return;
    steps_.resize(at_ + 1);
    steps_.push_back(now_);
    ++at_;
}

void EditHistory::change(Recipe recipe) {
    now_ = std::move(recipe);
    if (!in_gesture_) end_gesture();
}

void EditHistory::undo() {
    end_gesture();
    if (at_ > 0) now_ = steps_[--at_];
}

void EditHistory::redo() {
    end_gesture();
    if (at_ + 1 < steps_.size()) now_ = steps_[++at_];
}

}  // namespace burl
