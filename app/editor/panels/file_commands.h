#pragma once
// The editor's commands for files: opening, saving, exporting and quitting, with the dialogs and
// questions they ask.
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "app/editor/jobs/export.h"
#include "app/editor/jobs/loader.h"
#include "app/editor/panels/file_dialog.h"
#include "app/editor/panels/panels.h"
#include "app/editor/widgets/notices.h"

namespace burl {

/// File commands. All functions are called by the user interface's thread.
class FileCommands {
  public:
    /// `wake` is called by the export's thread when an export has ended.
    FileCommands(EditSession& session, DocumentLoader& loader, EditNotices& notices,
                 std::function<void()> wake)
        : session_(session), loader_(loader), notices_(notices), export_(std::move(wake)) {}

    void open_dialog();
    /// Saves the recipe in its file, or asks for one where it is a preset.
    void save();
    void save_dialog();
    void export_dialog();
    void export_frames_dialog();
    /// Quits, after a question where changes are not saved.
    void quit();
    /// Returns the `burl bake` command of the texture on screen.
    std::string command_line() const;

    /// Draws the menus of recent files and of poses.
    void recent_menu(EditItems& items);
    void pose_menu(EditItems& items);
    /// Draws the question about unsaved changes, until there are none or the user cancels.
    void closing_window(EditItems& items);
    /// Draws the dialog; the path chosen is opened, saved or exported to.
    void show_dialog(EditItems& items);
    FileDialog& dialog() { return dialog_; }
    /// Whether a dialog or the question is shown.
    bool asks() const { return dialog_.is_open() || asks_to_close_; }
    /// Whether the program is to end.
    bool closing() const { return closing_; }

    bool exporting() const { return export_.busy(); }
    ProgressState progress() const { return export_.progress(); }
    void stop_export() { export_.stop(); }
    /// Logs the result of an export that has ended.
    void take_outcome();
    /// Blocks until no export is running.
    void wait() { export_.wait(); }

  private:
    void ask(FileDialog::Wish wish, std::function<void(const std::string& path)> then);
    void save_as(const std::string& path);
    void export_as(const std::string& path);
    void export_frames_as(const std::string& path);
    std::string command(const Recipe& recipe, std::vector<std::string> output, double time) const;
    std::vector<std::string> places() const;
    ExportRequest export_request(const std::string& path);
    void export_options(EditItems& items, const std::string& path);
    double seen_time() const;

    EditSession& session_;
    DocumentLoader& loader_;
    EditNotices& notices_;
    FileDialog dialog_;
    std::function<void(const std::string& path)> chosen_;  ///< takes the path chosen in the dialog
    /// The choices for exports.
    struct ExportChoice {
        std::uint32_t size = 0;  ///< the texture's side in texels; 0: the recipe's
        bool levels = false;
        std::set<std::string> masks{};
    };
    ExportChoice choice_;
    EditExport export_;
    bool asks_to_close_ = false, closing_ = false;
};

}  // namespace burl
