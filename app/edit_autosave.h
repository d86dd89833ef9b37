#pragma once
// Unsaved work survives a crash: the recipe is written beside the user's other state while it
// differs from its file, and offered at the next start. Every editor that runs has a file of its
// own, which it holds by a lock, so that only what no running editor has is offered.
#include <optional>
#include <string>
#include <vector>

#include "app/edit_history.h"
#include "app/edit_lock.h"

namespace burl {

/// A recipe that an editor left without ending well.
struct LeftRecipe {
    std::string file{};
    std::string json{};
    std::string title{};  ///< its name, and when it was written
};

class EditAutosave {
  public:
    /// `file`: "DIR/NAME.json" of the first editor, "DIR/NAME-1.json" of another that runs beside
    /// it, and so on; empty: nowhere.
    explicit EditAutosave(std::string file);

    /// To be called often; writes at most every few seconds, and removes the file once nothing is
    /// unsaved. A folder that cannot be written to ends it in silence: losing the autosave is no
    /// reason to stop somebody's work.
    void keep(const EditHistory& history, double seconds);
    /// Recipes left by editors that did not end well; no other editor offers them meanwhile.
    const std::vector<LeftRecipe>& left_behind() const { return left_; }
    /// The history has one of them now, which is kept for it at once, or it is not wanted.
    void take(std::size_t left, const EditHistory& history);
    void throw_away(std::size_t left);
    /// All stay where they are, for the next start.
    void leave_all();
    /// The program ends well: its own file goes.
    void clear();

  private:
    std::string file_of(std::size_t editor) const;
    void find_left();
    bool claim();
    void write(const Recipe& recipe);
    void forget(std::size_t left);

    std::string first_;  ///< file of the first editor; empty: nothing is written
    std::string file_;   ///< this one's; empty: not yet
    std::optional<EditLock> lock_;
    std::vector<LeftRecipe> left_;
    std::vector<EditLock> left_locks_;  ///< of each of those
    std::optional<Recipe> written_;
    double last_ = -1e9;
};

/// A file of this name in $XDG_STATE_HOME/burl or ~/.local/state/burl; empty without a home.
std::string state_file(const std::string& name);

}  // namespace burl
