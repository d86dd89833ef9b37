#pragma once
// A small browser for files, because the desktop's own dialogs are not there without a desktop.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/edit_items.h"

namespace burl {

struct FolderEntry {
    std::string name;
    bool folder = false;
    bool operator==(const FolderEntry&) const = default;
};

/// Folders first, then files with one of the extensions (in lower case, with the dot; none: all),
/// each by name; hidden ones are left out. Empty where the folder cannot be read.
std::vector<FolderEntry> list_folder(const std::string& folder,
                                     const std::vector<std::string>& extensions);

/// A dialog that gives a path once.
class FileDialog {
  public:
    struct Wish {
        std::string title{};
        std::vector<std::string> extensions{};
        bool saves = false;    ///< the file need not be there
        std::string name{};    ///< to begin with
        std::string hint{};    ///< what the extensions are for
        std::string choice{};  ///< something to tick; empty: nothing
    };

    /// Opens it in the folder last shown; what is typed is the file's name at once.
    void open(Wish wish);
    bool is_open() const { return open_; }
    /// Whether Wish::choice is ticked.
    bool chose() const { return chose_; }
    /// Draws it; the path chosen in this frame.
    std::optional<std::string> show(EditItems& items);

  private:
    std::string path() const;
    std::optional<std::string> chosen();
    std::string remark() const;
    void entries(EditItems& items);
    void answers(EditItems& items);

    Wish wish_;
    std::string folder_ = ".", name_;
    bool open_ = false, accepted_ = false, chose_ = false;
    bool begins_ = false;  ///< the next frame is the first
};

}  // namespace burl
