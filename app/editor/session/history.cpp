#include "app/editor/session/history.h"

#include <utility>

#include <fmt/format.h>

#include "app/editor/session/step_words.h"
#include "atlas/base/real_path.h"

namespace burl {

namespace {

/// Returns a file's path with links resolved, or a preset's name unchanged.
std::string spelling_of(const std::string& path) {
    return path.ends_with(".json") ? real_path(path) : path;
}

/// Returns the words for the opening of a file or preset in a list of steps.
std::string opening_words(const std::string& path) {
    return path.empty() ? "new recipe" : fmt::format("open {}", path.substr(path.rfind('/') + 1));
}

}  // namespace

EditHistory::EditHistory(Recipe recipe, const std::string& path)
    : now_(recipe), step_(std::move(recipe)) {
    const KeptRecipe opened(now_);
    steps_.push_back(
        {opened,
         std::make_shared<Document>(Document{++documents_, path, path, spelling_of(path), opened}),
         {},
         opening_words(path)});
    saved_[document().file] = now_;
}

bool EditHistory::is_saved(const Recipe& recipe, const Document& document) const {
    const auto saved = saved_.find(document.file);
    return saved != saved_.end() && saved->second == recipe;
}

/// Appends a step after the current one; the undone steps are dropped.
void EditHistory::add_step(Step step) {
    steps_.erase(steps_.begin() + std::ptrdiff_t(at_) + 1, steps_.end());
    steps_.push_back(std::move(step));
    ++at_;
    step_ = now_;
}

void EditHistory::end_gesture() {
    in_gesture_ = false;
    std::string words = std::exchange(words_, {});
    if (now_ == step_) return;
    if (words.empty()) words = step_words(step_, now_);
    const Step& before = steps_[at_];
    add_step({KeptRecipe(now_, before.recipe), before.document, before.left, std::move(words)});
}

void EditHistory::go_to(std::size_t step) {
    at_ = step;
    now_ = step_ = steps_[at_].recipe.recipe();
    ++revision_;
    look_back();
}

void EditHistory::look_back() {
    left_.clear();
    for (auto left = steps_[at_].left; left; left = steps_[*left].left) {
        Recipe recipe = steps_[*left].recipe.recipe();
        if (!is_saved(recipe, *steps_[*left].document)) left_.push_back({*left, std::move(recipe)});
    }
}

void EditHistory::change(Recipe recipe, std::string words) {
    now_ = std::move(recipe);
    words_ = std::move(words);
    ++revision_;
    if (!in_gesture_) end_gesture();
}

/// Returns the step of unsaved(); no gesture may be open.
std::optional<std::size_t> EditHistory::changed_step() const {
    if (changed()) return at_;
    return left_.empty() ? std::nullopt : std::optional(left_[0].step);
}

void EditHistory::add_document(Recipe recipe, const std::string& path) {
    const std::optional<std::size_t> left = changed_step();
    now_ = std::move(recipe);
    ++revision_;
    const KeptRecipe opened(now_, steps_[at_].recipe);
    add_step(
        {opened,
         std::make_shared<Document>(Document{++documents_, path, path, spelling_of(path), opened}),
         left, opening_words(path)});
}

void EditHistory::open(Recipe recipe, const std::string& path) {
    end_gesture();
    const std::string file = spelling_of(path);
    if (recipe != now_ || file != document().file) add_document(std::move(recipe), path);
    saved_[file] = now_;
    look_back();
}

void EditHistory::open_unsaved(Recipe recipe) {
    end_gesture();
    add_document(std::move(recipe), "");
    saved_.erase("");
    look_back();
}

void EditHistory::undo() {
    end_gesture();
    if (at_ > 0) go_to(at_ - 1);
}

void EditHistory::redo() {
    end_gesture();
    if (at_ + 1 < steps_.size()) go_to(at_ + 1);
}

void EditHistory::return_to(std::size_t step) {
    end_gesture();
    if (step < steps_.size() && step != at_) go_to(step);
}

std::vector<EditHistory::Unsaved> EditHistory::all_unsaved() const {
    std::vector<Unsaved> all;
    const auto add = [&](const Document& document, const Recipe& recipe) {
        all.push_back({document.number, document.path, &recipe});
    };
    if (changed()) add(document(), now_);
    for (const Left& left : left_) add(*steps_[left.step].document, left.recipe);
    return all;
}

const Recipe* EditHistory::unsaved() const {
    const std::vector<Unsaved> all = all_unsaved();
    return all.empty() ? nullptr : all[0].recipe;
}

void EditHistory::return_to_unsaved() {
    end_gesture();
    if (const auto step = changed_step()) go_to(*step);
}

void EditHistory::mark_saved(const std::string& path) {
    end_gesture();
    name_images(path);
    document().path = path;
    document().file = spelling_of(path);
    saved_[document().file] = now_;
    give_up_left();
    look_back();
}

/// Renames the images of all steps of the document, so that the names are relative to the file.
void EditHistory::name_images(const std::string& path) {
    for (Step& step : steps_)
        if (step.document == steps_[at_].document) step.recipe.name_images(document().path, path);
    document().opened.name_images(document().path, path);
    now_ = step_ = steps_[at_].recipe.recipe();
    ++revision_;
}

/// Drops older unsaved steps of the file that was just saved, which saving would undo. Unsaved
/// steps of other documents stay.
void EditHistory::give_up_left() {
    const auto is_older = [&](std::size_t left) {
        return left < at_ && steps_[left].document->file == document().file;
    };
    for (Step& step : steps_)
        while (step.left && is_older(*step.left)) step.left = steps_[*step.left].left;
}

}  // namespace burl
