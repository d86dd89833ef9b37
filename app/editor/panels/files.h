#pragma once
// A small browser for files, because the desktop's own dialogs are not there without a desktop.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/panels/items.h"

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

/// "a.mtl, a.obj and a.png"; of many the first ones and how many more there are.
std::string names_together(const std::vector<std::string>& names);

/// An empty file "STEM-NNN.EXTENSION" in the working folder, with the first number from 001 on that
/// no file has, made so that no other program gets the same. Throws Error(io).
std::string claim_numbered(const std::string& stem, const std::string& extension);

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
        /// All files that are written for a path and the choice; none: that file alone.
        std::function<std::vector<std::string>(const std::string& path, bool chose)> files{};
    };

    /// Opens it in the folder last shown; what is typed is the file's name at once.
    void open(Wish wish);
    bool is_open() const { return open_; }
    void cancel() { open_ = false; }
    /// The folder that is shown.
    const std::string& folder() const { return folder_; }
    /// Whether Wish::choice is ticked.
    bool chose() const { return chose_; }
    /// Draws it; the path chosen in this frame. Where that replaces files it has asked first.
    std::optional<std::string> show(EditItems& items);

  private:
    std::string path() const;
    std::optional<std::string> chosen();
    std::optional<std::string> agreed();
    std::vector<std::string> replaced(const std::string& path) const;
    std::string remark() const;
    void entries(EditItems& items);
    void answers(EditItems& items);
    void question(EditItems& items);

    Wish wish_;
    std::string folder_ = ".", name_;
    std::string asked_;                  ///< the path whose files would be replaced; empty: none
    std::vector<std::string> replaced_;  ///< names of those
    bool open_ = false, accepted_ = false, chose_ = false, agreed_ = false;
    bool begins_ = false;  ///< the next frame is the first
};

}  // namespace burl
