// The window's layout: the object on the left, the panels on the right and the menu above; and the
// keyboard shortcuts of the whole window.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/base/stopwatch.h"
#include "app/editor/panels/keys.h"
#include "app/editor/panels/paint.h"
#include "app/editor/panels/scale.h"
#include "app/editor/panels/timeline.h"
#include "app/editor/window/program.h"
#include "procedural/numbers/simd_target.h"

namespace burl {

namespace {

constexpr float side_share = 0.34f, side_text = 24.0f;
constexpr double degrees_per_second = 20.0;
constexpr ImGuiWindowFlags fixed =
    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
    ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoTitleBar;

/// Halves a view; the second half begins at `second`, beside the first one or below.
void split(ImVec2& size, ImVec2& second) {
    const bool beside = size.x >= 0.8f * size.y;
    (beside ? size.x : size.y) *= 0.5f;
    (beside ? second.x : second.y) += beside ? size.x : size.y;
}

/// Returns the width of the panels: a share of the window that has room for sliders with their
/// labels, but at most half of it.
float side_width(float window) {
    return std::min(0.5f * window, std::max(side_share * window, side_text * ImGui::GetFontSize()));
}

bool typing() {
    return ImGui::GetIO().WantTextInput;
}

}  // namespace

void EditorProgram::compare() {
    comparing_ = !comparing_;
    compared_ = session_.recipe();
}

/// Switches a tool on or off; the other tool goes off.
void EditorProgram::take_tool(bool& tool) {
    const bool on = !tool;
    paint_.tool.on = move_.on = false;
    tool = on;
    if (move_.on) ImGui::SetWindowFocus("Object");  // the arrow keys belong to the tool
}

void EditorProgram::shortcuts() {
    if (pressed("F1")) keys_open_ = !keys_open_;
    if (typing()) return;
    if (pressed("F12")) screenshot_due_ = true;
    if (dialog_.is_open() || asks_to_close_) return;
    if (pressed("Ctrl+Q")) ask_to_close();
    if (pressed("Ctrl+O")) open_dialog();
    if (pressed("Ctrl+S")) save();
    if (pressed("Ctrl+Shift+S")) save_dialog();
    if (pressed("Ctrl+E")) export_dialog();
    if (pressed("F5")) files_.reload();
    if (pressed("Ctrl+Z")) session_.history().undo();
    if (pressed("Ctrl+Y") || pressed("Ctrl+Shift+Z")) session_.history().redo();
    if (pressed("Ctrl+C")) window_->set_clipboard(to_json(session_.recipe()));
    if (pressed("Ctrl+V")) session_.paste_recipe(window_->clipboard());
    if (pressed("Ctrl+Shift+C")) window_->set_clipboard(command({}, seen_time()));
    if (!atlas_.shortcuts() && pressed("F")) camera_ = fitted(camera_);
    if (pressed("1")) camera_ = from_front(camera_);
    if (pressed("3")) camera_ = from_side(camera_);
    if (pressed("7")) camera_ = from_top(camera_);
    if (pressed("L")) lit_ = !lit_;
    if (pressed("T")) turntable_ = !turntable_;
    if (pressed("A")) compare();
    if (pressed("Ctrl+Plus") || pressed("Ctrl+Shift+Plus")) scale_ = larger_scale(scale_);
    if (pressed("Ctrl+Minus")) scale_ = smaller_scale(scale_);
    if (pressed("Ctrl+0")) scale_ = normal_scale_;
    if (pressed("G")) take_tool(move_.on);
    if (pressed("P")) take_tool(paint_.tool.on);
    paint_shortcuts(paint_.tool);
    timeline_shortcuts(timeline_, session_);
}

bool EditorProgram::menu_item(const char* label, const char* key, bool enabled) {
    const bool chosen = ImGui::MenuItem(label, key, false, enabled);
    items_.note(fmt::format("menu:{}", label));
    return chosen;
}

void EditorProgram::menu_toggle(const char* label, const char* key, bool& value) {
    ImGui::MenuItem(label, key, &value);
    items_.note(fmt::format("menu:{}", label));
}

void EditorProgram::file_menu() {
    if (menu_item("Open...", "Ctrl+O")) open_dialog();
    recent_menu();
    pose_menu();
    if (menu_item("Reload", "F5")) files_.reload();
    if (menu_item("Save recipe", "Ctrl+S")) save();
    if (menu_item("Save recipe as...", "Ctrl+Shift+S")) save_dialog();
    if (menu_item("Export...", "Ctrl+E", !export_.busy())) export_dialog();
    const bool moves = !session_.recipe().animation.tracks.empty();
    if (menu_item("Export frames...", "", moves && !export_.busy())) export_frames_dialog();
    if (menu_item("Screenshot", "F12")) screenshot_due_ = true;
    if (menu_item("Quit", "Ctrl+Q")) ask_to_close();
}

void EditorProgram::view_menu() {
    if (menu_item("Fit", "F")) camera_ = fitted(camera_);
    if (menu_item("Front", "1")) camera_ = from_front(camera_);
    if (menu_item("Side", "3")) camera_ = from_side(camera_);
    if (menu_item("Top", "7")) camera_ = from_top(camera_);
    menu_toggle("Light", "L", lit_);
    menu_toggle("Turntable", "T", turntable_);
    menu_toggle("Atlas", "V", atlas_.state.shown);
    menu_toggle("Wireframe", "W", atlas_.edges);
    menu_toggle("Chart borders", "B", atlas_.borders);
    menu_toggle("Timeline", "K", timeline_.open);
    ImGui::Separator();
    if (menu_item("Larger text", "Ctrl++")) scale_ = larger_scale(scale_);
    if (menu_item("Smaller text", "Ctrl+-")) scale_ = smaller_scale(scale_);
}

void EditorProgram::menu() {
    if (!ImGui::BeginMainMenuBar()) return;
    const auto under = [&](const char* label, auto entries) {
        const bool open = ImGui::BeginMenu(label);
        items_.note(fmt::format("menu:{}", label));
        if (!open) return;
        entries();
        ImGui::EndMenu();
    };
    under("File", [&] { file_menu(); });
    under("Edit", [&] {
        if (menu_item("Undo", "Ctrl+Z", session_.history().can_undo())) session_.history().undo();
        if (menu_item("Redo", "Ctrl+Y", session_.history().can_redo())) session_.history().redo();
        if (menu_item("Move the texture", "G")) take_tool(move_.on);
        if (menu_item("Paint", "P")) take_tool(paint_.tool.on);
        if (menu_item("Clear paint", "", !session_.recipe().paint.empty())) clear_paint(session_);
    });
    under("View", [&] { view_menu(); });
    under("Help", [&] {
        if (menu_item("Keys", "F1")) keys_open_ = true;
    });
    ImGui::Text("  %s%s", session_.recipe().name.c_str(), session_.history().unsaved() ? " *" : "");
    if (comparing_) ImGui::TextUnformatted("  as it was opened (A)");
    ImGui::EndMainMenuBar();
}

void EditorProgram::layout() {
    menu();
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float top = ImGui::GetFrameHeight();
    const float side = side_width(display.x);
    const float strip = timeline_.open ? timeline_height(session_) : 0.0f;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImVec2 object{display.x - side, display.y - top - strip}, atlas{0.0f, top};
    if (atlas_.state.shown) split(object, atlas);
    ImGui::SetNextWindowPos({0.0f, top});
    ImGui::SetNextWindowSize(object);
    object_window();
    if (atlas_.state.shown) {
        ImGui::SetNextWindowPos(atlas);
        ImGui::SetNextWindowSize(object);
        atlas_window();
    }
    if (timeline_.open) {
        ImGui::SetNextWindowPos({0.0f, display.y - strip});
        ImGui::SetNextWindowSize({display.x - side, strip});
        timeline_panel({session_, items_}, timeline_);
    }
    paint_panel({session_, items_}, paint_.tool, {0.0f, top});
    move_panel({session_, items_}, move_, {0.0f, top});
    ImGui::SetNextWindowPos({display.x - side, top});
    ImGui::SetNextWindowSize({side, display.y - top});
    side_window();
    ImGui::PopStyleVar();
    if (keys_open_) keys_open_ = cheat_sheet({session_, items_});
    recovery_window();
    closing_window();
    notices();
    if (const auto path = dialog_.show(items_)) (this->*chosen_)(*path);
}

ObjectView EditorProgram::object_view(const ImVec2& low, const ImVec2& size) const {
    ObjectView view;
    view.pick = pick();
    view.share = share_;
    view.camera = camera_;
    view.low = {double(low.x), double(low.y)};
    view.size = {double(size.x), double(size.y)};
    const auto& surface = object_.surface();
    if (view.pick) view.sphere = surface->sphere;
    if (surface) view.unit_from_mesh = surface->unit_from_mesh;
    if (surface && session_.recipe().solid.space == SolidSpace::unit)
        view.solid_from_mesh = surface->unit_from_mesh;
    return view;
}

void EditorProgram::object_input(const ImVec2& low, const ImVec2& size) {
    ImGui::InvisibleButton("object", size,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    items_.note("object");
    const ImGuiIO& io = ImGui::GetIO();
    atlas_.look_at_object(object_view(low, size));
    const bool paints = paint_.input(object_view(low, size), session_);
    const bool moves = move_.input(object_view(low, size), session_);
    moving_camera_ = ImGui::IsItemActive() && !paints && !moves;
    const auto shorter = double(std::min(size.x, size.y));
    if (moving_camera_ && ImGui::IsMouseDown(0))
        camera_ = orbited(camera_, {io.MouseDelta.x, io.MouseDelta.y}, shorter);
    else if (moving_camera_)
        camera_ = panned(camera_, {io.MouseDelta.x, io.MouseDelta.y}, shorter);
    if (ImGui::IsItemHovered() && io.MouseWheel != 0.0f)
        camera_ = zoomed(camera_, double(io.MouseWheel));
    if (turntable_) {
        camera_ = orbited(camera_, {-degrees_per_second * double(io.DeltaTime), 0.0}, 180.0);
        moving_camera_ = true;
    }
}

/// Whether a finer level will replace the texture on screen soon, or the first texture of an opened
/// mesh has just come: supersampling waits for the next frame.
bool EditorProgram::is_rough() const {
    const EditPicture* picture = object_.picture();
    return picture && (picture->level > 0 || (opening_ && !baker_.opening()));
}

/// Whether movement has ended and its last texture is not on screen yet: that frame is drawn first,
/// and supersampling waits for the next one.
bool EditorProgram::comes_to_rest() const {
    const EditPicture *shown = object_.picture(), *newest = baker_.picture().get();
    if (!shown || object_.drawn_samples() != 1) return false;
    return shown != newest || (shown->request < request_ && !baker_.idle());
}

void EditorProgram::object_image(const ImVec2& low, const ImVec2& size) {
    const bool rests = comes_to_rest();
    if (rests) frames_to_draw_ = std::max(frames_to_draw_, 1);
    object_.show(baker_.surface(), baker_.picture(), baker_.coming());
    object_.show_lines(object_.uploading() ? nullptr : atlas_.lines());
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    ObjectViewOptions options;
    options.size = {int(size.x * scale.x), int(size.y * scale.y)};
    options.camera = camera_;
    options.lit = lit_;
    options.share = share_;
    options.edges = atlas_.edges;
    options.borders = atlas_.borders;
    options.supersample = moving_camera_ || is_moving() || is_rough() || rests ? 1 : 2;
    const double began = thread_seconds();
    const GlTexture* texture = object_.draw(options);
    times_.worked -= thread_seconds() - began;
    if (texture) object_image_ = {object_.target(), !object_.drew()};
    if (texture)
        ImGui::GetWindowDrawList()->AddImage(imgui_texture(*texture), low,
                                             {low.x + size.x, low.y + size.y});
}

void EditorProgram::object_window() {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
    if (ImGui::Begin("Object", nullptr,
                     fixed | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoNavInputs)) {
        const ImVec2 low = ImGui::GetCursorScreenPos(), size = ImGui::GetContentRegionAvail();
        if (size.x >= 1.0f && size.y >= 1.0f) {
            object_input(low, size);
            timed(times_.object, [&] { object_image(low, size); });
            paint_.draw(object_view(low, size));
            move_.draw(object_view(low, size), session_, items_);
            atlas_.mark_object(object_view(low, size));
        }
    }
    ImGui::End();
    ImGui::PopStyleVar();
}

void EditorProgram::atlas_window() {
    if (ImGui::Begin("Atlas", nullptr, fixed | ImGuiWindowFlags_NoScrollbar))
        atlas_.panel({session_, items_}, baker_, object_, pick().get());
    ImGui::End();
}

void EditorProgram::side_window() {
    const PanelContext context{session_, items_};
    const auto tab = [&](const char* name, auto panel) {
        const bool open = ImGui::BeginTabItem(name);
        items_.note(fmt::format("tab:{}", name));
        if (!open) return;
        if (ImGui::BeginChild(name)) panel();
        ImGui::EndChild();
        ImGui::EndTabItem();
    };
    if (ImGui::Begin("Side", nullptr, fixed) && ImGui::BeginTabBar("tabs")) {
        tab("Presets", [&] { presets_panel(context, preset_search_, preset_picture()); });
        tab("Parameters", [&] { parameters_panel(context, posed_); });
        tab("Colours", [&] { color_maps_panel(context, stop_); });
        tab("Metrics", [&] { metrics_panel(context, metrics()); });
        tab("Log", [&] { log_panel(context); });
        ImGui::EndTabBar();
    }
    ImGui::End();
}

/// Returns the function that makes thumbnails; it returns null until the object has its texture,
/// which comes first.
PresetPicture EditorProgram::preset_picture() {
    return [this](const std::string& preset, int side) -> ImTextureID {
        return gallery_ && baker_.picture() ? gallery_->picture(preset, side) : nullptr;
    };
}

MetricsView EditorProgram::metrics() {
    MetricsView view;
    if (const auto surface = baker_.surface()) {
        view.facts.emplace_back("triangles", fmt::format("{}", surface->triangles));
        view.facts.emplace_back("atlas", fmt::format("{}, {} x {} texels", surface->atlas,
                                                     surface->size, surface->size));
        view.atlas = figures_.of(surface);
    }
    if (const auto picture = baker_.picture()) {
        view.facts.emplace_back("level shown", fmt::format("{}", picture->level));
        view.facts.emplace_back("made in", fmt::format("{:.1f} ms", 1e3 * picture->seconds));
    }
    view.facts.emplace_back("instructions", simd_level());
    view.facts.emplace_back("renderer", window_->context().description());
    view.records = baker_.records();
    return view;
}

}  // namespace burl
