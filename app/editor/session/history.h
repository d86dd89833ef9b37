#pragma once
// Undo and redo of what an editor has open, unlimited. A step is a recipe together with the file or
// preset that it belongs to, so that going back to it brings back the file's name, too; what those
// files hold is known, so that what is saved is known of every step. All changes of one gesture (a
// slider's drag) are one step.
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/pipeline/kept_recipe.h"

namespace burl {

class EditHistory {
  public:
    /// `recipe` counts as saved in `path`, a file or a preset's name.
    explicit EditHistory(Recipe recipe, const std::string& path = {});

    const Recipe& recipe() const { return now_; }
    /// The file or preset that the recipe came from or was saved to; empty: none.
    const std::string& path() const { return document().path; }
    /// The recipe as it was opened, and what was opened.
    Recipe opened() const { return document().opened.recipe(); }
    const std::string& opened_path() const { return document().opened_path; }
    /// Another number for everything that is opened; undo brings the number before back.
    std::uint64_t document_number() const { return document().number; }
    /// Another number whenever the recipe may be another one.
    std::uint64_t revision() const { return revision_; }

    /// Changes until end_gesture() are one step; gestures may be opened again while open.
    void begin_gesture() { in_gesture_ = true; }
    /// Nothing happens when the recipe ends as it began.
    void end_gesture();
    /// Inside a gesture the last change counts; outside it is a step of its own. Steps that were
    /// undone are forgotten.
    void change(Recipe recipe);
    bool in_gesture() const { return in_gesture_; }
    /// Opens a file's or preset's recipe as one step; no step where just that is open.
    void open(Recipe recipe, const std::string& path);
    /// A recipe that no file holds, as one step.
    void open_unsaved(Recipe recipe);

    bool can_undo() const { return now_ != step_ || at_ > 0; }
    bool can_redo() const { return now_ == step_ && at_ + 1 < steps_.size(); }
    /// Ends an open gesture first, whose step is then the one undone.
    void undo();
    void redo();

    /// Whether the recipe is not what its file or preset holds.
    bool changed() const { return !is_saved(now_, document()); }
    /// A document's changes that would be lost.
    struct Unsaved {
        std::uint64_t document = 0;  ///< its document_number()
        std::string path{};
        const Recipe* recipe = nullptr;
    };
    /// This recipe's where it has changed(), and those in whose place others were opened, each
    /// until it is saved; the newest first.
    std::vector<Unsaved> all_unsaved() const;
    /// The first of those; null: nothing.
    const Recipe* unsaved() const;
    /// Goes back to that.
    void return_to_unsaved();
    /// The file holds the recipe now, as with_images_for (app/recipe/images.h) names its images
    /// there, and the recipe belongs to the file. Changes of the file that
    /// were left before are given up, but for undo.
    void mark_saved(const std::string& path);
    /// Somebody else has changed the file: no recipe counts as saved there.
    void forget_saved() { saved_.erase(document().file); }

  private:
    /// An opened file or preset; steps share it, so that saving names all of them.
    struct Document {
        std::uint64_t number = 0;
        std::string path, opened_path;
        std::string file;  ///< its one spelling
        KeptRecipe opened;
    };
    struct Step {
        KeptRecipe recipe;
        std::shared_ptr<Document> document;
        std::optional<std::size_t> left;  ///< the step that was left with changes
    };
    /// A step that was left, and its changes are not saved.
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
    std::map<std::string, Recipe> saved_;  ///< what files and presets hold
    std::uint64_t documents_ = 0, revision_ = 0;
    std::size_t at_ = 0;  ///< of `now_`, but for changes of an open gesture
    Recipe now_;
    Recipe step_;             ///< steps_[at_]
    std::vector<Left> left_;  ///< before steps_[at_], the newest first; kept for all_unsaved()
    bool in_gesture_ = false;
};

}  // namespace burl
