#pragma once
// What was not saved survives a crash: the recipe is written beside the user's other state while it
// differs from its file, and offered at the next start.
#include <optional>
#include <string>

#include "app/edit_history.h"

namespace burl {

class EditAutosave {
  public:
    /// `file`: where to; empty: nowhere.
    explicit EditAutosave(std::string file) : file_(std::move(file)) {}

    /// To be called often; writes at most every few seconds, and removes the file once nothing is
    /// unsaved. A folder that cannot be written to ends it in silence: losing the autosave is no
    /// reason to stop somebody's work.
    void keep(const EditHistory& history, double seconds);
    /// What a run that did not end well has left.
    std::optional<std::string> left_behind() const;
    /// The program ends well, or what was left is not wanted.
    void clear();

  private:
    std::string file_;
    std::optional<Recipe> written_;
    double last_ = -1e9;
};

/// A file of this name in $XDG_STATE_HOME/burl or ~/.local/state/burl; empty without a home.
std::string state_file(const std::string& name);

}  // namespace burl
