#pragma once
// Unsaved work survives a crash: recipes are written beside the user's other state while they
// differ from their files, and offered at the next start. Every one has a file of its own, which
// its editor holds by a lock, so that only what no running editor has is offered.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/session/history.h"
#include "app/editor/session/lock.h"

namespace burl {

/// A recipe that an editor left without ending well.
struct LeftRecipe {
    std::string file{};
    std::string json{};
    std::string title{};  ///< its name, and when it was written
};

class EditAutosave {
  public:
    /// `file`: "DIR/NAME.json" for the first recipe, "DIR/NAME-1.json" for another one, of this
    /// editor or of one that runs beside it, and so on; empty: nowhere.
    explicit EditAutosave(std::string file);

    /// To be called often; writes at most every few seconds, and removes the file of what is saved
    /// now. A folder that cannot be written to ends it in silence: losing the autosave is no
    /// reason to stop somebody's work.
    void keep(const EditHistory& history, double seconds);
    /// Recipes left by editors that did not end well; no other editor offers them meanwhile.
    const std::vector<LeftRecipe>& left_behind() const { return left_; }
    /// The history has one of them now, which is kept for it at once, or it is not wanted.
    void take(std::size_t left, const EditHistory& history);
    void throw_away(std::size_t left);
    /// All stay where they are, for the next start.
    void leave_all();
    /// The program ends well: its own files go.
    void clear();

  private:
    /// A document of this editor's history.
    struct Kept {
        std::uint64_t document = 0;
        std::string file;
        EditLock lock;
        std::optional<Recipe> written;
    };
    using AllUnsaved = std::vector<EditHistory::Unsaved>;

    std::string file_of(std::size_t number) const;
    void find_left();
    Kept& claim(std::uint64_t document);
    Kept& kept(std::uint64_t document);
    void write(const EditHistory::Unsaved& unsaved);
    void write_all(const AllUnsaved& all);
    void remove_others(const AllUnsaved& all);
    void forget(std::size_t left);

    std::string first_;  ///< of all files; empty: nothing is written
    std::vector<Kept> kept_;
    std::vector<LeftRecipe> left_;
    std::vector<EditLock> left_locks_;  ///< of each of those
    double last_ = -1e9;
};

/// A file of this name in $XDG_STATE_HOME/burl or ~/.local/state/burl; empty without a home.
std::string state_file(const std::string& name);

}  // namespace burl
