#pragma once
// A file browser in the editor's window: the desktop's own dialogs need a desktop.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/panels/items.h"

namespace burl {

/// An entry of a folder.
struct FolderEntry {
    std::string name;
    bool folder = false;
    bool operator==(const FolderEntry&) const = default;
};

/// Lists a folder: folders first, then files with one of the extensions (lower case, with the dot;
/// none: all), each sorted by name and without hidden ones. Empty where the folder cannot be read.
std::vector<FolderEntry> list_folder(const std::string& folder,
                                     const std::vector<std::string>& extensions);

/// Returns the last part of a path.
std::string file_name(const std::string& path);

/// Joins names as "a.mtl, a.obj and a.png"; of many only the first, and the number of the others.
std::string names_together(const std::vector<std::string>& names);

/// Creates an empty file "STEM-NNN.EXTENSION" in the working folder with the first free number from
/// 001 on; concurrent programs get different files. Throws Error(io).
std::string claim_numbered(const std::string& stem, const std::string& extension);

/// A dialog for one path, to open or to save.
class FileDialog {
  public:
    /// The purpose of the dialog.
    struct Wish {
        std::string title{};
        std::vector<std::string> extensions{};
        bool saves = false;    ///< whether the file may be new
        std::string name{};    ///< name offered at first
        std::string hint{};    ///< explanation of the extensions
        std::string choice{};  ///< label of a check box; empty: none
        /// Returns all files that would be written for a path and a check box's state; not set:
        /// that path alone.
        std::function<std::vector<std::string>(const std::string& path, bool chose)> files{};
    };

    /// Opens the dialog in the folder shown last, with the keyboard's focus on the file's name.
    void open(Wish wish);
    bool is_open() const { return open_; }
    void cancel() { open_ = false; }
    /// The folder shown.
    const std::string& folder() const { return folder_; }
    /// The names of the entries shown last; none while it is closed.
    const std::vector<std::string>& names() const { return names_; }
    /// Whether the check box is ticked.
    bool chose() const { return chose_; }
    /// Draws the dialog. Returns the path in the frame it is chosen, after a confirmation where
    /// files would be replaced.
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
    std::vector<std::string> names_;
    std::string asked_;                  ///< path for which a confirmation is shown; empty: none
    std::vector<std::string> replaced_;  ///< names of the files to be replaced
    bool open_ = false, accepted_ = false, chose_ = false, agreed_ = false;
    bool begins_ = false;  ///< whether the next frame is the dialog's first
};

}  // namespace burl
