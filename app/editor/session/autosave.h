#pragma once
// Autosave: recipes are written to the user's state folder while they differ from their files, and
// offered at the next start if the editor ended without saving or discarding them. Every recipe has
// a file of its own, locked by its editor, so that no running editor's recipe is offered.
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/editor/session/history.h"

namespace burl {

/// A lock file that one running program at a time can hold, until destruction. The system releases
/// it when the program ends, however it ends: the lock is flock()'s, as fcntl's locks would end
/// when any descriptor of the file is closed.
class EditLock {
  public:
    /// Creates the file `path` and locks it; empty where another program holds it or the file
    /// cannot be created.
    static std::optional<EditLock> take(const std::string& path);
    EditLock(EditLock&& other) noexcept;
    EditLock& operator=(EditLock&& other) noexcept;
    /// Removes the file and releases the lock.
    ~EditLock();

  private:
    EditLock(std::string path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}

    std::string path_;
    int descriptor_ = -1;
};

/// A recipe left behind by an editor that crashed or was killed.
struct LeftRecipe {
    /// Path of the autosave file.
    std::string file{};
    std::string json{};
    std::string title{};  ///< the recipe's name and the age of the file, for display
    std::string view{};   ///< what keep() was given beside the recipe; empty: nothing
};

/// Writes and recovers autosave files. All functions are called by one thread.
class EditAutosave {
  public:
    /// `file` is "DIR/NAME.json", the first file's path; further recipes, of this or of other
    /// running editors, go to "DIR/NAME-1.json", "DIR/NAME-2.json" and so on. An empty `file` turns
    /// autosave off.
    explicit EditAutosave(std::string file);

    /// Writes the unsaved recipes of `history` at most every 3 seconds, and removes the files of
    /// those saved since. `seconds` is the time on any steady clock. Autosave turns itself off
    /// silently where the folder cannot be written: that is no reason to interrupt somebody's work.
    /// `view` is a text kept beside each recipe: what it was looked at on, and from where.
    void keep(const EditHistory& history, double seconds, const std::string& view = {});
    /// Recipes left behind by crashed editors; they are locked, so that no other editor offers
    /// them.
    const std::vector<LeftRecipe>& left_behind() const { return left_; }
    /// Removes a left recipe after writing the unsaved recipes of `history`, which has taken it
    /// over.
    void take(std::size_t left, const EditHistory& history);
    /// Removes a left recipe and its file.
    void throw_away(std::size_t left);
    /// Unlocks all left recipes and keeps their files for the next start.
    void leave_all();
    /// Removes this editor's own files; called when the program ends normally.
    void clear();

  private:
    /// An autosaved document of this editor's history.
    struct Kept {
        std::uint64_t document = 0;  ///< EditHistory::document_number()
        std::string file;
        EditLock lock;
        std::optional<Recipe> written;  ///< the recipe as last written
        std::string view{};             ///< the view as last written
    };
    using AllUnsaved = std::vector<EditHistory::Unsaved>;

    std::string file_of(std::size_t number) const;
    void find_left();
    Kept& claim(std::uint64_t document);
    Kept& kept(std::uint64_t document);
    void write(const EditHistory::Unsaved& unsaved);
    void write_view(Kept& place) const;
    void write_all(const AllUnsaved& all);
    void remove_others(const AllUnsaved& all);
    void forget(std::size_t left);

    std::string first_;  ///< path of the first file; empty: autosave is off
    std::vector<Kept> kept_;
    std::string view_;  ///< the view that keep() was given last
    std::vector<LeftRecipe> left_;
    std::vector<EditLock> left_locks_;  ///< locks of `left_`, in the same order
    double last_ = -1e9;                ///< time of the last write, in seconds
};

/// Returns the path of a file of this name in $XDG_STATE_HOME/burl or ~/.local/state/burl; empty
/// without a home folder.
std::string state_file(const std::string& name);

}  // namespace burl
