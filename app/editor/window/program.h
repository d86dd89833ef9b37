#pragma once
// The editor as a whole: a window, the panels, the session and the pipeline's thread, tied together
// frame by frame. Everything it does follows from input events, so that scripts replay it.
#include <memory>
#include <string>
#include <vector>

#include "app/editor/panels/files.h"
#include "app/editor/panels/items.h"
#include "app/editor/panels/move.h"
#include "app/editor/panels/paint_hand.h"
#include "app/editor/panels/panels.h"
#include "app/editor/panels/presets.h"
#include "app/editor/session/autosave.h"
#include "app/editor/session/pace.h"
#include "app/editor/session/session.h"
#include "app/editor/session/timeline.h"
#include "app/editor/window/atlas.h"
#include "app/editor/window/gallery.h"
#include "app/editor/window/imgui.h"
#include "app/editor/window/object.h"
#include "app/editor/window/window.h"
#include "app/editor/work/baker.h"
#include "app/editor/work/export.h"
#include "app/editor/work/open_files.h"
#include "app/editor/work/posed_pick.h"

namespace burl {

struct EditorOptions {
    std::string mesh = "sample:teapot", recipe = "marble";
    std::vector<std::string> settings{};
    double ui_scale = 1.0;
    std::string autosave{};  ///< file (edit_autosave.h); empty: none
    bool gallery = true;     ///< whether presets have pictures
    std::string recent{};    ///< file (edit_recent.h); empty: none
};

/// Where the time of a frame went, in seconds on the thread of the user interface.
struct FrameTimes {
    double panels = 0.0;  ///< input, panels and all else that is not drawing
    double object = 0.0;  ///< uploading the surface and the texture, and drawing the object
    double screen = 0.0;  ///< drawing the user interface
    /// Of `panels` and uploading: what that thread's processor worked, however many others wanted
    /// it.
    double worked = 0.0;
};

class EditorProgram {
  public:
    /// Reads the recipe and begins to read the mesh. Throws Error as the former does.
    EditorProgram(std::unique_ptr<GlWindow> window, const EditorOptions& options);
    ~EditorProgram();

    /// One frame: what happened since the last one, then the panels, then the picture. Throws Error
    /// where the first mesh cannot be read.
    void frame(const std::vector<InputEvent>& events);
    /// Until the window is closed; waits while nothing happens.
    void run();
    /// Once round run()'s loop.
    void turn();
    /// A mesh is read, laid out or uploaded, or its finest picture is not on the screen yet.
    bool opening() const { return opening_; }
    /// Plays a script to its end; its screenshots go into `folder`, empty: nowhere. Waits at
    /// "settle" for the pipeline. Throws Error as ScriptPlayer does, io for screenshots.
    void play(InputScript script, const std::string& folder);

    /// Frames from now on become steps of a script.
    void record() { recording_.emplace(); }
    const std::optional<InputScript>& recording() const { return recording_; }

    bool wants_to_close() const { return closing_; }
    /// No texture is being made and what is there is shown.
    bool settled() const;
    /// What the last frame drew.
    Image<Rgb8> screenshot();

    EditSession& session() { return session_; }
    const EditItems& items() const { return items_; }
    const EditBaker& baker() const { return baker_; }
    EditCamera& camera() { return camera_; }
    const GlEditAtlas& atlas() const { return atlas_; }
    const EditOpenFiles& files() const { return files_; }
    FileDialog& dialog() { return dialog_; }
    /// Number of the last texture that was asked for.
    std::uint64_t last_request() const { return request_; }
    /// The texture that the last frame shows; null: none. And whether with many samples a pixel.
    const EditPicture* shown() const { return object_.picture(); }
    bool shown_smooth() const { return object_.drawn_samples() > 1; }
    /// The window's: recipe and mesh, and a star where the recipe is not saved.
    std::string title() const;
    /// Of the last frame.
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
    double seen_time() const;  ///< 0 without keys
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
    /// A slider, a hand or the clock changes what is seen.
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
    double scale_ = 1.0, normal_scale_ = 1.0;  ///< of the user interface, from the next frame on
    double shown_scale_ = 0.0;
    bool lit_ = true, turntable_ = false, keys_open_ = false, comparing_ = false, closing_ = false;
    bool moving_camera_ = false, asks_to_close_ = false;
    Recipe compared_;  ///< what is compared; another one ends it
    /// Told over the object for some seconds.
    struct News {
        std::string text{};
        bool problem = false;
        double until = 0.0;
    } news_;
    StopSelection stop_;
    EditTimeline timeline_;
    EditPaint paint_;
    EditMove move_;
    std::uint64_t document_ = 0;  ///< EditHistory::document_number() of the last frame
    bool posed_ = false;          ///< the mesh has a pose
    double share_ = 0.0;          ///< of the way there that is shown
    std::optional<WorkerRequest> requested_;
    std::uint64_t request_ = 0;
    double last_seconds_ = 0.0;
    bool opening_ = false;
    EditPace pace_;
    std::string shown_title_;
    int frames_to_draw_ = 3;  ///< until the user interface has come to rest
    FileDialog dialog_;
    void (EditorProgram::*chosen_)(const std::string&) = nullptr;  ///< takes the dialog's file
    EditAutosave autosave_;
    std::optional<InputScript> recording_;
    bool screenshot_due_ = false;
    EditExport export_;
    FrameTimes times_;
    std::string first_mesh_;  ///< what the editor was started with
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
