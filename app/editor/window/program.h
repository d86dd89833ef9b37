#pragma once
// The editor as a whole: it wires the window, the session, the worker threads and the panels, and
// runs the frame loop. Everything it does follows from input events, so that scripts can replay it.
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/graph/graph.h"
#include "app/editor/jobs/baker.h"
#include "app/editor/jobs/loader.h"
#include "app/editor/jobs/requests.h"
#include "app/editor/panels/file_commands.h"
#include "app/editor/panels/welcome.h"
#include "app/editor/session/autosave.h"
#include "app/editor/session/pace.h"
#include "app/editor/session/preferences.h"
#include "app/editor/session/session.h"
#include "app/editor/widgets/fonts.h"
#include "app/editor/widgets/items.h"
#include "app/editor/widgets/notices.h"
#include "app/editor/window/atlas.h"
#include "app/editor/window/imgui.h"
#include "app/editor/window/node_gallery.h"
#include "app/editor/window/side.h"
#include "app/editor/window/viewport.h"
#include "app/editor/window/window.h"

namespace burl {

/// The editor's start-up options.
struct EditorOptions {
    std::string mesh = "sample:teapot", recipe = "marble";
    std::vector<std::string> settings{};
    std::string light = "studio";  ///< a built-in environment, or "headlight"
    /// Who makes the texture (EditSynthesis).
    EditSynthesis synthesis = EditSynthesis::automatic;
    double ui_scale = 1.0;
    /// Path of the autosave file (app/editor/session/autosave.h); empty: none.
    std::string autosave{};
    bool gallery = true;  ///< whether presets have thumbnails
    /// Path of the list of recent files (app/editor/session/recent.h); empty: none.
    std::string recent{};
    /// Path of the preferences (app/editor/session/preferences.h); empty: none.
    std::string preferences{};
    FontFiles fonts = find_fonts();
};

/// The editor. All functions are called by the main thread.
class EditorProgram {
  public:
    /// Reads the recipe and begins to read the mesh. Throws Error where the recipe cannot be read.
    EditorProgram(std::unique_ptr<GlWindow> window, const EditorOptions& options);

    /// Runs one frame: handles `events`, lays out the panels and draws. Throws Error where the
    /// first mesh cannot be read.
    void frame(const std::vector<InputEvent>& events);
    /// Runs until the window is closed; sleeps while nothing happens.
    void run();
    /// Runs one turn of run()'s loop, which draws only where something may have changed.
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

    bool wants_to_close() const { return commands_.closing(); }
    /// Whether no background work is left and its results are uploaded.
    bool settled() const;
    /// The pixels of the last frame.
    Image<Rgb8> screenshot();

    EditSession& session() { return session_; }
    const EditItems& items() const { return items_; }
    const EditBaker& baker() const { return baker_; }
    EditCamera& camera() { return viewport_.camera; }
    EditPreferences& preferences() { return preferences_; }
    const GlEditAtlas& atlas() const { return atlas_; }
    const EditGraph& graph() const { return graph_; }
    const PaintTool& paint_tool() const { return viewport_.paint.tool; }
    /// The shape of the pointer over the window.
    PointerShape pointer() const { return window_->pointer(); }
    const TextureRequests& requests() const { return requests_; }
    const EditOpenFiles& files() const { return loader_.files(); }
    FileDialog& dialog() { return commands_.dialog(); }
    /// The number of the last texture request.
    std::uint64_t last_request() const { return requests_.last(); }
    /// The texture on screen; null: none.
    const EditPicture* shown() const { return viewport_.object().picture(); }
    /// Whether the last frame was drawn with several samples per pixel.
    bool shown_smooth() const { return viewport_.object().drawn_samples() > 1; }
    /// The window's title: recipe and mesh, with a star where there are unsaved changes.
    std::string title() const;
    /// The number of frames so far.
    std::uint64_t frames() const { return frames_; }
    /// The times of the last frame.
    const FrameTimes& times() const { return times_; }

  private:
    struct ImGuiOwner {
        ImGuiOwner();
        ~ImGuiOwner();
    };
    // program.cpp: the frame loop
    std::function<void()> wake() {
        return [this] { window_->wake(); };
    }
    void panels(const std::vector<InputEvent>& events);
    void begin_frame();
    void follow_look();
    void follow_mesh();
    void take_recovered(const std::string& view);
    void meet_texts();
    void take(const InputEvent& event);
    void take_news();
    void keep();
    void take_screenshot();
    void follow_opening();
    void draw_screen();
    std::vector<InputEvent> until_due();
    void show_all();
    void settle();
    // layout.cpp: the windows of a frame, menus and shortcuts
    void shortcuts();
    void copy_recipe();
    void copy_command();
    void view_shortcuts();
    void file_menu();
    void edit_menu();
    void light_menu();
    void view_menu();
    void up_menu();
    void menu();
    void layout();
    // toolbar.cpp
    void toolbar();
    void tools_of_edits();
    void tools_of_view();
    void atlas_window();
    void first_steps(const ImVec2& corner);
    void notices(float bottom);
    // synthesis.cpp: who makes the texture
    void offer_context(EditSynthesis by);
    void choose_synthesis(EditSynthesis by);
    void synthesis_menu();
    void passes_badge(const ImVec2& low, const ImVec2& size);
    // graph.cpp: the graph in the window
    GraphHooks graph_hooks();
    float graph_height(float room);
    void graph_window(const ImVec2& low, const ImVec2& size);
    void look_badge(const ImVec2& low, const ImVec2& size);

    std::unique_ptr<GlWindow> window_;
    InterfaceFonts fonts_;  ///< outlives ImGui's context, which refers to it
    ImGuiOwner imgui_;
    GlImGui renderer_;
    EditSession session_;
    EditItems items_;
    PreferenceFile preference_file_;
    EditPreferences preferences_;
    EditNotices notices_;
    EditAutosave autosave_;
    EditBaker baker_;
    TextureRequests requests_;
    DocumentLoader loader_;
    FileCommands commands_;
    GlEditAtlas atlas_;
    ObjectViewport viewport_;
    SidePanels side_;
    EditGraph graph_;
    std::optional<GlNodeGallery> node_gallery_;

    /// Scale of the user interface from the next frame on, and the one at the start.
    double scale_ = 1.0, normal_scale_ = 1.0;
    /// The look of the last frame.
    double shown_scale_ = 0.0;
    Theme shown_theme_ = Theme::dark;
    int tool_lines_ = 1;     ///< lines that the tools took in the last frame
    std::string seen_mesh_;  ///< mesh of the last frame
    FirstSteps steps_;
    std::string met_line_;            ///< last line of the log whose characters are known
    std::uint64_t met_revision_ = 0;  ///< revision of the history whose texts are known
    bool keys_open_ = false, screenshot_due_ = false;
    std::optional<InputScript> recording_;
    std::string shown_title_;
    double last_seconds_ = 0.0;  ///< time of the last frame on the window's clock
    bool opening_ = false;
    EditPace pace_;
    EditRest rest_;
    FrameTimes times_;
    std::uint64_t frames_ = 0;
};

}  // namespace burl
