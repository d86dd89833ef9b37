#pragma once
// The editor as a whole: window, panels, session and worker threads, tied together frame by frame.
// Everything it does follows from input events, so that scripts can replay it.
#include <memory>
#include <string>
#include <vector>

#include "app/editor/jobs/baker.h"
#include "app/editor/jobs/export.h"
#include "app/editor/jobs/open_files.h"
#include "app/editor/jobs/posed_pick.h"
#include "app/editor/panels/files.h"
#include "app/editor/panels/items.h"
#include "app/editor/panels/move.h"
#include "app/editor/panels/paint.h"
#include "app/editor/panels/panels.h"
#include "app/editor/session/autosave.h"
#include "app/editor/session/pace.h"
#include "app/editor/session/session.h"
#include "app/editor/window/atlas.h"
#include "app/editor/window/gallery.h"
#include "app/editor/window/imgui.h"
#include "app/editor/window/object.h"
#include "app/editor/window/window.h"

namespace burl {

/// The editor's start-up options.
struct EditorOptions {
    std::string mesh = "sample:teapot", recipe = "marble";
    std::vector<std::string> settings{};
    double ui_scale = 1.0;
    /// Path of the autosave file (app/editor/session/autosave.h); empty: none.
    std::string autosave{};
    bool gallery = true;  ///< whether presets have thumbnails
    /// Path of the list of recent files (app/editor/session/recent.h); empty: none.
    std::string recent{};
};

/// Wall-clock times of a frame's parts on the user interface's thread, in seconds.
struct FrameTimes {
    double panels = 0.0;  ///< input, panels and everything but drawing
    double object = 0.0;  ///< uploading the surface and the texture, and drawing the object
    double screen = 0.0;  ///< drawing the user interface
    /// Processor time of the user interface's thread for `panels` and uploads, whatever the load.
    double worked = 0.0;
};

/// The editor. All functions are called by the main thread.
class EditorProgram {
  public:
    /// Reads the recipe and begins to read the mesh. Throws Error where the recipe cannot be read.
    EditorProgram(std::unique_ptr<GlWindow> window, const EditorOptions& options);
    ~EditorProgram();

    /// Runs one frame: handles `events`, lays out the panels and draws. Throws Error where the
    /// first mesh cannot be read.
    void frame(const std::vector<InputEvent>& events);
    /// Runs until the window is closed; sleeps while nothing happens.
    void run();
    /// Runs one turn of run()'s loop.
    void turn();
    /// Whether a mesh is being read, laid out or uploaded, or its texture at level 0 is not on
    /// screen.
    bool opening() const { return opening_; }
    /// Plays a script to its end; screenshots are written to `folder`, or nowhere where it is
    /// empty. "settle" steps wait for all background work. Throws Error as ScriptPlayer does, and
    /// Error(io) for screenshots.
    void play(InputScript script, const std::string& folder);

    /// Starts to record all later frames as a script.
    void record() { recording_.emplace(); }
    const std::optional<InputScript>& recording() const { return recording_; }

    bool wants_to_close() const { return closing_; }
    /// Whether no background work is left and its results are uploaded.
    bool settled() const;
    /// The pixels of the last frame.
    Image<Rgb8> screenshot();

    EditSession& session() { return session_; }
    const EditItems& items() const { return items_; }
    const EditBaker& baker() const { return baker_; }
    EditCamera& camera() { return camera_; }
    const GlEditAtlas& atlas() const { return atlas_; }
    const EditOpenFiles& files() const { return files_; }
    FileDialog& dialog() { return dialog_; }
    /// The number of the last texture request.
    std::uint64_t last_request() const { return request_; }
    /// The texture on screen; null: none.
    const EditPicture* shown() const { return object_.picture(); }
    /// Whether the last frame was drawn with several samples per pixel.
    bool shown_smooth() const { return object_.drawn_samples() > 1; }
    /// The window's title: recipe and mesh, with a star where there are unsaved changes.
    std::string title() const;
    /// The times of the last frame.
    const FrameTimes& times() const { return times_; }

  private:
    struct ImGuiOwner {
        ImGuiOwner();
        ~ImGuiOwner();
    };
    void panels(const std::vector<InputEvent>& events);
    void take(const InputEvent& event);
    void take_news();
    void note(const std::vector<InputEvent>& events);
    void take_files();
    void take_mesh(FileRead read);
    void take_recipe(FileRead read);
    void take_pose(const FileRead& read);
    void open_pose(const std::string& path);
    void close_pose();
    void pose_menu();
    double pose_share();
    std::shared_ptr<const SurfacePick> pick() const;
    void settle();
    void follow_opening();
    std::vector<InputEvent> until_due();
    void open(const std::string& path);
    void recent_menu();
    void notices();
    void news(std::string text, bool problem);
    void ask_to_close();
    void closing_window();
    void save();
    void save_dialog();
    void ask_for_file(void (EditorProgram::*then)(const std::string&), FileDialog::Wish wish);
    void save_as(const std::string& path);
    void export_as(const std::string& path);
    double seen_time() const;  ///< time on the clock in seconds; 0 without animation
    std::string command(std::vector<std::string> output, double time) const;
    void export_frames_as(const std::string& path);
    void take_screenshot();
    void open_dialog();
    void export_dialog();
    void export_frames_dialog();
    bool menu_item(const char* label, const char* key, bool enabled = true);
    void menu_toggle(const char* label, const char* key, bool& value);
    void file_menu();
    void view_menu();
    void recovery_window();
    bool left_row(std::size_t left);
    void follow_document();
    void shortcuts();
    void menu();
    void layout();
    void object_window();
    void atlas_window();
    void object_input(const ImVec2& low, const ImVec2& size);
    ObjectView object_view(const ImVec2& low, const ImVec2& size) const;
    void side_window();
    bool is_rough() const;
    bool comes_to_rest() const;
    void object_image(const ImVec2& low, const ImVec2& size);
    void draw_screen();
    void request_texture();
    Recipe shown_recipe();
    /// Whether a slider, a drag or the clock is changing the recipe.
    bool is_moving() const { return session_.history().in_gesture() || timeline_.moving(); }
    void compare();
    void take_tool(bool& tool);
    MetricsView metrics();
    PresetPicture preset_picture();

    std::unique_ptr<GlWindow> window_;
    ImGuiOwner imgui_;
    GlImGui renderer_;
    EditSession session_;
    EditItems items_;
    EditCamera camera_;
    /// Scale of the user interface from the next frame on.
    double scale_ = 1.0, normal_scale_ = 1.0;
    double shown_scale_ = 0.0;
    bool lit_ = true, turntable_ = false, keys_open_ = false, comparing_ = false, closing_ = false;
    bool moving_camera_ = false, asks_to_close_ = false;
    Recipe compared_;  ///< the session's recipe when comparing began; another recipe ends it
    /// A message shown over the object for some seconds.
    struct News {
        std::string text{};
        bool problem = false;
        double until = 0.0;
    } news_;
    StopSelection stop_;
    EditTimeline timeline_;
    EditPaint paint_;
    EditMove move_;
    std::uint64_t document_ = 0;  ///< EditHistory::document_number() in the last frame
    bool posed_ = false;          ///< whether the mesh has a pose
    double share_ = 0.0;          ///< share of the way to the pose that is shown, 0 to 1
    std::optional<WorkerRequest> requested_;
    std::uint64_t request_ = 0;
    double last_seconds_ = 0.0;
    bool opening_ = false;
    EditPace pace_;
    std::string shown_title_;
    int frames_to_draw_ = 3;  ///< frames still to draw until the user interface is at rest
    FileDialog dialog_;
    /// Receives the path chosen in the dialog.
    void (EditorProgram::*chosen_)(const std::string&) = nullptr;
    EditAutosave autosave_;
    std::optional<InputScript> recording_;
    bool screenshot_due_ = false;
    EditExport export_;
    FrameTimes times_;
    std::string first_mesh_;  ///< mesh that the editor was started with
    EditOpenFiles files_;
    GlImGui::OpaqueImage object_image_{};

    EditBaker baker_;
    EditPosedPick posed_pick_;
    GlEditObject object_;
    std::optional<GlEditGallery> gallery_;
    std::string preset_search_;
    EditFigures figures_;
    GlEditAtlas atlas_;
};

}  // namespace burl
