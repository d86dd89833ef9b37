#pragma once
// A file browser in the editor's window: the desktop's own dialogs need a desktop.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/widgets/items.h"

namespace burl {

/// A dialog for one path, to open or to save.
class FileDialog {
  public:
    /// The purpose of the dialog.
    struct Wish {
        std::string title{};
        std::vector<std::string> extensions{};
        bool saves = false;                 ///< whether the file may be new
        std::string name{};                 ///< name offered at first
        std::string hint{};                 ///< explanation of the extensions
        std::vector<std::string> places{};  ///< folders offered besides those of every dialog
        /// Draws what else there is to choose, in `option_rows` rows, for the path typed.
        std::function<void(EditItems& items, const std::string& path)> options{};
        int option_rows = 0;
        /// Returns all files that would be written for a path; not set: that path alone.
        std::function<std::vector<std::string>(const std::string& path)> files{};
        const char* verb = nullptr;  ///< what the button says; null: Save or Open
    };

    /// Opens the dialog in the folder shown last, with the keyboard's focus on the file's name.
    void open(Wish wish);
    bool is_open() const { return open_; }
    void cancel() { open_ = false; }
    /// The folder shown.
    const std::string& folder() const { return folder_; }
    /// The names of the entries shown last; none while it is closed.
    const std::vector<std::string>& names() const { return names_; }
    /// Draws the dialog. Returns the path in the frame it is chosen, after a confirmation where
    /// files would be replaced.
    std::optional<std::string> show(EditItems& items);

  private:
    struct Place {
        std::string label, folder;
    };
    std::string path() const;
    std::optional<std::string> chosen();
    std::optional<std::string> agreed();
    std::vector<std::string> replaced(const std::string& path) const;
    std::string remark() const;
    void go_to(const std::string& folder);
    void crumbs(EditItems& items);
    void places(EditItems& items);
    void entries(EditItems& items);
    void name_row(EditItems& items);
    void new_folder(EditItems& items);
    void make_folder_named();
    void answers(EditItems& items);
    void question(EditItems& items);

    Wish wish_;
    std::string start_;  ///< the folder shown first
    std::string folder_ = ".", name_;
    std::vector<Place> places_;
    std::vector<std::string> names_;
    std::string asked_;                  ///< path for which a confirmation is shown; empty: none
    std::vector<std::string> replaced_;  ///< names of the files to be replaced
    std::optional<std::string> made_;    ///< name of a folder to make, while it is typed
    std::string problem_;                ///< why no folder was made
    bool open_ = false, accepted_ = false, agreed_ = false;
    bool had_popup_ = false;  ///< whether the last frame had a list open, which Escape closes first
    bool begins_ = false;     ///< whether the keyboard's focus goes to the name in the next frame
};

}  // namespace burl
