#pragma once
// The undo stack of an editor, unlimited. A step holds a recipe and the file or preset it belongs
// to, so that undo brings back the file's name, too. The contents of those files are remembered, so
// that every step knows whether it is saved. All changes of one gesture (a slider's drag) are one
// step.
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/pipeline/kept_recipe.h"

namespace burl {

/// Undo and redo. All functions are called by one thread.
class EditHistory {
  public:
    /// Starts with `recipe`, which counts as saved in `path`, a file or a preset's name.
    explicit EditHistory(Recipe recipe, const std::string& path = {});

    const Recipe& recipe() const { return now_; }
    /// The file or preset that the recipe came from or was saved to; empty: none.
    const std::string& path() const { return document().path; }
    /// The recipe as it was opened, before any edit, and the file or preset it was opened from.
    Recipe opened() const { return document().opened.recipe(); }
    const std::string& opened_path() const { return document().opened_path; }
    /// A number that identifies the opened file or preset: every recipe that is opened gets a new
    /// one, and undo brings back the older ones.
    std::uint64_t document_number() const { return document().number; }
    /// A counter that changes whenever the recipe may have changed.
    std::uint64_t revision() const { return revision_; }

    /// Begins a gesture, unless one is open: all changes until end_gesture() are one step.
    void begin_gesture() { in_gesture_ = true; }
    /// Ends the gesture; adds no step where the recipe is what it was at the beginning.
    void end_gesture();
    /// Replaces the recipe: within a gesture the last change becomes the step, outside of one the
    /// change is a step. Undone steps are dropped. `words` say what was done; empty: what differs
    /// says it (step_words.h).
    void change(Recipe recipe, std::string words = {});
    bool in_gesture() const { return in_gesture_; }
    /// Opens a file's or preset's recipe as one step, unless the same recipe of the same file is
    /// open.
    void open(Recipe recipe, const std::string& path);
    /// Opens a recipe that no file holds as one step.
    void open_unsaved(Recipe recipe);

    bool can_undo() const { return now_ != step_ || at_ > 0; }
    bool can_redo() const { return now_ == step_ && at_ + 1 < steps_.size(); }
    /// Ends an open gesture and undoes the last step, which may be the gesture's.
    void undo();
    /// Ends an open gesture and redoes the step undone last; after new changes there is none.
    void redo();

    /// The number of steps, the first of which is what the history began with, and the present one.
    std::size_t step_count() const { return steps_.size(); }
    std::size_t step() const { return at_; }
    /// A step in a few words.
    const std::string& words(std::size_t step) const { return steps_[step].words; }
    /// Ends an open gesture and goes to a step; nothing is dropped.
    void return_to(std::size_t step);

    /// Whether the recipe differs from its file or preset.
    bool changed() const { return !is_saved(now_, document()); }
    /// A document with unsaved changes.
    struct Unsaved {
        std::uint64_t document = 0;  ///< its document_number()
        std::string path{};
        const Recipe* recipe = nullptr;
    };
    /// The documents with unsaved changes, newest first: the current one if changed(), and those
    /// replaced by open() and not saved since.
    std::vector<Unsaved> all_unsaved() const;
    /// The newest recipe with unsaved changes; null: none.
    const Recipe* unsaved() const;
    /// Goes to the step of unsaved().
    void return_to_unsaved();
    /// Records that the recipe was written to the file `path`, with its images named relative to it
    /// (with_images_for, app/recipe/edit/images.h), and makes that the recipe's file. Older unsaved
    /// changes of the same file are no longer unsaved() but can be undone to.
    void mark_saved(const std::string& path);
    /// Records that the file changed on disk: no recipe counts as saved in it.
    void forget_saved() { saved_.erase(document().file); }

  private:
    /// An opened file or preset, shared by its steps, so that saving renames all of them.
    struct Document {
        std::uint64_t number = 0;
        std::string path, opened_path;
        std::string file;  ///< `path` with links resolved, as saved_ is keyed
        KeptRecipe opened;
    };
    /// A step of the undo stack.
    struct Step {
        KeptRecipe recipe;
        std::shared_ptr<Document> document;
        /// Step with unsaved changes that the opening of this step's document replaced.
        std::optional<std::size_t> left;
        std::string words{};
    };
    /// A replaced step with unsaved changes.
    struct Left {
        std::size_t step;
        Recipe recipe;
    };

    Document& document() const { return *steps_[at_].document; }
    bool is_saved(const Recipe& recipe, const Document& document) const;
    std::optional<std::size_t> changed_step() const;
    void add_step(Step step);
    void add_document(Recipe recipe, const std::string& path);
    void go_to(std::size_t step);
    void look_back();
    void give_up_left();
    void name_images(const std::string& path);

    std::vector<Step> steps_;
    std::map<std::string, Recipe> saved_;  ///< last known contents of files and presets
    std::uint64_t documents_ = 0, revision_ = 0;
    std::size_t at_ = 0;  ///< index of the current step
    /// The recipe now: steps_[at_] with the changes of an open gesture.
    Recipe now_;
    Recipe step_;  ///< recipe of steps_[at_], decompressed
    /// Replaced steps before steps_[at_], newest first, for all_unsaved().
    std::vector<Left> left_;
    bool in_gesture_ = false;
    std::string words_;  ///< what the changes of an open gesture did; empty: see what differs
};

}  // namespace burl
