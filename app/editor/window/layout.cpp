// The window's layout: the object on the left, the panels on the right and the menu above; and the
// keyboard shortcuts of the whole window.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "app/editor/panels/keys.h"
#include "app/editor/panels/paint.h"
#include "app/editor/panels/widgets.h"
#include "app/editor/window/program.h"
#include "app/recipe/edit/recipe_json.h"
#include "procedural/numbers/simd_target.h"

namespace burl {

namespace {

constexpr float side_share = 0.34f, side_text = 24.0f;

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

}  // namespace

void EditorProgram::shortcuts() {
    if (pressed("F1")) keys_open_ = !keys_open_;
    if (ImGui::GetIO().WantTextInput) return;
    if (pressed("F12")) screenshot_due_ = true;
    if (commands_.asks()) return;
    if (pressed("Ctrl+Q")) commands_.quit();
    if (pressed("Ctrl+O")) commands_.open_dialog();
    if (pressed("Ctrl+S")) commands_.save();
    if (pressed("Ctrl+Shift+S")) commands_.save_dialog();
    if (pressed("Ctrl+E")) commands_.export_dialog();
    if (pressed("F5")) loader_.files().reload();
    if (pressed("Ctrl+Z")) session_.history().undo();
    if (pressed("Ctrl+Y") || pressed("Ctrl+Shift+Z")) session_.history().redo();
    if (pressed("Ctrl+C")) window_->set_clipboard(to_json(session_.recipe()));
    if (pressed("Ctrl+V")) session_.paste_recipe(window_->clipboard());
    if (pressed("Ctrl+Shift+C")) window_->set_clipboard(commands_.command_line());
    view_shortcuts();
    if (pressed("G")) viewport_.take_tool(viewport_.move.on);
    if (pressed("P")) viewport_.take_tool(viewport_.paint.tool.on);
    paint_shortcuts(viewport_.paint.tool);
    timeline_shortcuts(session_);
}

void EditorProgram::view_shortcuts() {
    EditCamera& camera = viewport_.camera;
    if (!atlas_.shortcuts() && pressed("F")) camera = fitted(camera);
    if (pressed("1")) camera = from_front(camera);
    if (pressed("3")) camera = from_side(camera);
    if (pressed("7")) camera = from_top(camera);
    if (pressed("L")) viewport_.lit = !viewport_.lit;
    if (pressed("T")) viewport_.turntable = !viewport_.turntable;
    if (pressed("A")) requests_.compare();
    if (pressed("Ctrl+Plus") || pressed("Ctrl+Shift+Plus")) scale_ = larger_scale(scale_);
    if (pressed("Ctrl+Minus")) scale_ = smaller_scale(scale_);
    if (pressed("Ctrl+0")) scale_ = normal_scale_;
}

void EditorProgram::file_menu() {
    if (menu_item(items_, "Open...", "Ctrl+O")) commands_.open_dialog();
    commands_.recent_menu(items_);
    commands_.pose_menu(items_);
    if (menu_item(items_, "Reload", "F5")) loader_.files().reload();
    if (menu_item(items_, "Save recipe", "Ctrl+S")) commands_.save();
    if (menu_item(items_, "Save recipe as...", "Ctrl+Shift+S")) commands_.save_dialog();
    const bool idle = !commands_.exporting(), moves = !session_.recipe().animation.tracks.empty();
    if (menu_item(items_, "Export...", "Ctrl+E", idle)) commands_.export_dialog();
    if (menu_item(items_, "Export frames...", "", moves && idle)) commands_.export_frames_dialog();
    if (menu_item(items_, "Screenshot", "F12")) screenshot_due_ = true;
    if (menu_item(items_, "Quit", "Ctrl+Q")) commands_.quit();
}

void EditorProgram::edit_menu() {
    EditHistory& history = session_.history();
    if (menu_item(items_, "Undo", "Ctrl+Z", history.can_undo())) history.undo();
    if (menu_item(items_, "Redo", "Ctrl+Y", history.can_redo())) history.redo();
    if (menu_item(items_, "Move the texture", "G")) viewport_.take_tool(viewport_.move.on);
    if (menu_item(items_, "Paint", "P")) viewport_.take_tool(viewport_.paint.tool.on);
    if (menu_item(items_, "Clear paint", "", !session_.recipe().paint.empty()))
        clear_paint(session_);
}

/// The light's entries of the View menu.
void EditorProgram::light_menu() {
    const bool open = ImGui::BeginMenu("Light");
    items_.note("menu:Light");
    if (!open) return;
    menu_toggle(items_, "Lit", "L", viewport_.lit);
    ImGui::Separator();
    const auto entry = [&](std::string_view name) {
        bool chosen = viewport_.light.name() == name;
        menu_toggle(items_, std::string(name).c_str(), "", chosen);
        if (chosen) viewport_.light.choose(name);
    };
    for (const EnvironmentNote& note : environment_notes()) entry(note.name);
    entry(EditLight::headlight);
    ImGui::EndMenu();
}

void EditorProgram::view_menu() {
    EditCamera& camera = viewport_.camera;
    if (menu_item(items_, "Fit", "F")) camera = fitted(camera);
    if (menu_item(items_, "Front", "1")) camera = from_front(camera);
    if (menu_item(items_, "Side", "3")) camera = from_side(camera);
    if (menu_item(items_, "Top", "7")) camera = from_top(camera);
    light_menu();
    menu_toggle(items_, "Turntable", "T", viewport_.turntable);
    menu_toggle(items_, "Atlas", "V", atlas_.state.shown);
    menu_toggle(items_, "Wireframe", "W", atlas_.edges);
    menu_toggle(items_, "Chart borders", "B", atlas_.borders);
    menu_toggle(items_, "Timeline", "K", session_.timeline.open);
    ImGui::Separator();
    if (menu_item(items_, "Larger text", "Ctrl++")) scale_ = larger_scale(scale_);
    if (menu_item(items_, "Smaller text", "Ctrl+-")) scale_ = smaller_scale(scale_);
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
    under("Edit", [&] { edit_menu(); });
    under("View", [&] { view_menu(); });
    under("Help", [&] {
        if (menu_item(items_, "Keys", "F1")) keys_open_ = true;
    });
    ImGui::Text("  %s%s", session_.recipe().name.c_str(), session_.history().unsaved() ? " *" : "");
    if (requests_.comparing()) ImGui::TextUnformatted("  as it was opened (A)");
    ImGui::EndMainMenuBar();
}

void EditorProgram::layout() {
    menu();
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const PanelContext context{session_, items_};
    const bool timeline = session_.timeline.open;
    const float top = ImGui::GetFrameHeight();
    const float side = side_width(display.x);
    const float strip = timeline ? timeline_height(session_) : 0.0f;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImVec2 object{display.x - side, display.y - top - strip}, atlas{0.0f, top};
    if (atlas_.state.shown) split(object, atlas);
    ImGui::SetNextWindowPos({0.0f, top});
    ImGui::SetNextWindowSize(object);
    if (viewport_.window(items_, opening_, times_)) frames_to_draw_ = std::max(frames_to_draw_, 1);
    if (atlas_.state.shown) {
        ImGui::SetNextWindowPos(atlas);
        ImGui::SetNextWindowSize(object);
        atlas_window();
    }
    if (timeline) {
        ImGui::SetNextWindowPos({0.0f, display.y - strip});
        ImGui::SetNextWindowSize({display.x - side, strip});
        timeline_panel(context);
    }
    paint_panel(context, viewport_.paint.tool, {0.0f, top});
    move_panel(context, viewport_.move, {0.0f, top});
    ImGui::SetNextWindowPos({display.x - side, top});
    ImGui::SetNextWindowSize({side, display.y - top});
    side_.window(context, baker_, loader_.posed());
    ImGui::PopStyleVar();
    if (keys_open_) keys_open_ = cheat_sheet(context);
    recovery_window(context, autosave_);
    commands_.closing_window(items_);
    notices(display.y - (session_.timeline.open ? timeline_height(session_) : 0.0f));
    commands_.show_dialog(items_);
}

void EditorProgram::atlas_window() {
    if (ImGui::Begin("Atlas", nullptr, fixed_window | ImGuiWindowFlags_NoScrollbar))
        atlas_.panel({session_, items_}, baker_.front(), viewport_.object(),
                     viewport_.pick().get());
    ImGui::End();
}

/// Draws the notices of background work, above y = `bottom`.
void EditorProgram::notices(float bottom) {
    EditOpenFiles& files = loader_.files();
    std::vector<Notice> notices;
    for (const FileKind kind : {FileKind::mesh, FileKind::recipe, FileKind::pose})
        if (const std::string path = files.reading(kind); !path.empty())
            notices.push_back({fmt::format("Reading {} ...", file_name(path))});
    if (baker_.laying_out())
        notices.push_back(
            {"Laying out patches; until they are done, pairs of triangles are shown"});
    if (commands_.exporting()) notices.push_back({"Exporting ..."});
    if (files.asks())
        notices.push_back({fmt::format("{} has changed on disk; the recipe here is not saved",
                                       file_name(files.recipe())),
                           {"Take the file's", "Keep this one"}});
    const std::string answer = notices_.show(items_, std::move(notices), bottom);
    if (answer == "Take the file's") files.reload();
    if (answer == "Keep this one") {
        files.keep();
        session_.history().forget_saved();
    }
}

}  // namespace burl
