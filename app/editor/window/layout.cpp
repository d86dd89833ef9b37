// The window's layout: the object on the left, the panels on the right and the menu above; and the
// keyboard shortcuts of the whole window.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "app/base/progress.h"
#include "app/editor/panels/files.h"
#include "app/editor/panels/paint.h"
#include "app/editor/widgets/keys.h"
#include "app/editor/widgets/widgets.h"
#include "app/editor/window/kept_view.h"
#include "app/editor/window/panes.h"
#include "app/editor/window/program.h"
#include "app/recipe/edit/recipe_json.h"

namespace burl {

namespace {

void place_next_window(const ScreenRect& rect) {
    ImGui::SetNextWindowPos(rect.low);
    ImGui::SetNextWindowSize({rect.high.x - rect.low.x, rect.high.y - rect.low.y});
}

}  // namespace

void EditorProgram::shortcuts() {
    if (pressed("F1")) keys_open_ = !keys_open_;
    if (ImGui::GetIO().WantTextInput) return;
    if (pressed("F12")) screenshot_due_ = true;
    if (commands_.asks() || graph_.searching()) return;
    if (keys_open_ && pressed("Escape")) {
        keys_open_ = false;
        return;
    }
    if (!requests_.looking_at().empty() && pressed("Escape")) return requests_.look("");
    if (graph_.shortcuts({session_, items_}, graph_hooks())) return;
    if (pressed("Ctrl+Q")) commands_.quit();
    if (pressed("Ctrl+O")) commands_.open_dialog();
    if (pressed("Ctrl+S")) commands_.save();
    if (pressed("Ctrl+Shift+S")) commands_.save_dialog();
    if (pressed("Ctrl+E")) commands_.export_dialog();
    if (pressed("F5")) loader_.files().reload();
    if (pressed("Ctrl+Z")) session_.history().undo();
    if (pressed("Ctrl+Y") || pressed("Ctrl+Shift+Z")) session_.history().redo();
    if (pressed("Ctrl+C")) copy_recipe();
    if (pressed("Ctrl+V")) session_.paste_recipe(window_->clipboard());
    if (pressed("Ctrl+Shift+C")) copy_command();
    view_shortcuts();
    if (pressed("G")) viewport_.take_tool(viewport_.move.on);
    if (pressed("P")) viewport_.take_tool(viewport_.paint.tool.on);
    paint_shortcuts(viewport_.paint.tool);
    timeline_shortcuts(session_);
}

void EditorProgram::copy_recipe() {
    window_->set_clipboard(to_json(session_.recipe()));
    session_.tell("copied the recipe as JSON");
    notices_.tell("copied the recipe as JSON");
}

void EditorProgram::copy_command() {
    window_->set_clipboard(commands_.command_line());
    session_.tell("copied the burl command");
    notices_.tell("copied the burl command");
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
    if (pressed("Shift+A")) session_.kept[0] = session_.recipe();
    if (pressed("Shift+B")) session_.kept[1] = session_.recipe();
    if (pressed("N")) graph_.shown = !graph_.shown;
    if (pressed("Ctrl+Plus") || pressed("Ctrl+Shift+Plus")) scale_ = larger_scale(scale_);
    if (pressed("Ctrl+Minus")) scale_ = smaller_scale(scale_);
    if (pressed("Ctrl+0")) scale_ = normal_scale_;
}

void EditorProgram::file_menu() {
    if (menu_item(items_, "New", "")) session_.open_new();
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
    ImGui::Separator();
    if (menu_item(items_, "Copy the recipe", "Ctrl+C")) copy_recipe();
    if (menu_item(items_, "Paste a recipe", "Ctrl+V")) session_.paste_recipe(window_->clipboard());
    if (menu_item(items_, "Copy the burl command", "Ctrl+Shift+C")) copy_command();
    ImGui::Separator();
    if (menu_item(items_, "Compare", "A")) requests_.compare();
    if (menu_item(items_, "Keep as A", "Shift+A")) session_.kept[0] = session_.recipe();
    if (menu_item(items_, "Keep as B", "Shift+B")) session_.kept[1] = session_.recipe();
    ImGui::Separator();
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
    up_menu();
    light_menu();
    synthesis_menu();
    menu_toggle(items_, "Turntable", "T", viewport_.turntable);
    menu_toggle(items_, "Graph", "N", graph_.shown);
    menu_toggle(items_, "Atlas", "V", atlas_.state.shown);
    menu_toggle(items_, "Wireframe", "W", atlas_.edges);
    menu_toggle(items_, "Chart borders", "B", atlas_.borders);
    menu_toggle(items_, "Timeline", "K", session_.timeline.open);
    ImGui::Separator();
    if (menu_item(items_, "Larger text", "Ctrl++")) scale_ = larger_scale(scale_);
    if (menu_item(items_, "Smaller text", "Ctrl+-")) scale_ = smaller_scale(scale_);
    bool light = preferences_.theme == Theme::light;
    menu_toggle(items_, "Light theme", "", light);
    preferences_.theme = light ? Theme::light : Theme::dark;
    if (menu_item(items_, "Panels where they were at first", "")) preferences_.panes = {};
}

/// Draws the choice of the axis that is up: scans and CAD have z.
void EditorProgram::up_menu() {
    const bool open = ImGui::BeginMenu("Up");
    items_.note("menu:Up");
    if (!open) return;
    for (const UpAxis axis : {UpAxis::y, UpAxis::z, UpAxis::minus_z}) {
        const std::string name = to_text(axis);
        if (ImGui::MenuItem(name.c_str(), nullptr, viewport_.camera.up == axis))
            viewport_.camera.up = axis;
        items_.note("up:" + name);
    }
    ImGui::EndMenu();
}

/// Shows what to try until that is closed.
void EditorProgram::first_steps(const ImVec2& corner) {
    follow(steps_, session_.history(), viewport_.camera);
    const bool tool = viewport_.move.on || viewport_.paint.tool.on;
    if (preferences_.welcomed || tool) return;
    preferences_.welcomed = !first_steps_window(items_, steps_, corner);
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
        if (menu_item(items_, "First steps", "")) preferences_.welcomed = false;
    });
    ImGui::Text("  %s%s", session_.recipe().name.c_str(), session_.history().unsaved() ? " *" : "");
    if (requests_.comparing())
        ImGui::TextUnformatted(fmt::format("  {} (A)", requests_.shown_words()).c_str());
    ImGui::EndMainMenuBar();
}

void EditorProgram::layout() {
    menu();
    const PanelContext context{session_, items_};
    const bool timeline = session_.timeline.open;
    PaneWishes wishes{ImGui::GetIO().DisplaySize,
                      ImGui::GetFrameHeight(),
                      ImGui::GetFrameHeight(),
                      atlas_.state.shown,
                      0.0f,
                      tool_lines_};
    // The graph lies below all else, over the window's whole width.
    const ImVec2 display = wishes.size;
    wishes.size.y -= graph_height(display.y - wishes.top);
    const float left = panes_of(wishes, preferences_.panes).side.low.x;
    if (timeline) wishes.timeline = timeline_height(session_, left);
    const Panes panes = panes_of(wishes, preferences_.panes);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    place_next_window(panes.tools);
    toolbar();
    place_next_window(panes.object);
    if (viewport_.window(items_, opening_, times_)) rest_.ask(1);
    place_next_window(panes.atlas);
    if (atlas_.state.shown) atlas_window();
    graph_window({0.0f, wishes.size.y}, {display.x, display.y - wishes.size.y});
    place_next_window(panes.timeline);
    if (timeline) timeline_panel(context);
    place_next_window(panes.side);
    side_.window(context, baker_, loader_.posed(),
                 {graph_, graph_hooks(), preferences_.favourites, viewport_.light.on_host()});
    ImGui::PopStyleVar();
    splitters(items_, wishes, panes, preferences_.panes);
    paint_panel(context, viewport_.paint.tool, panes.object.low);
    move_panel(context, viewport_.move, panes.object.low);
    look_badge(panes.object.low, {panes.object.high.x - panes.object.low.x,
                                  panes.object.high.y - panes.object.low.y});
    passes_badge(panes.object.low, {panes.object.high.x - panes.object.low.x,
                                    panes.object.high.y - panes.object.low.y});
    if (keys_open_) keys_open_ = cheat_sheet(context);
    if (const auto view = recovery_window(context, autosave_)) take_recovered(*view);
    first_steps({panes.object.high.x, panes.object.low.y});
    commands_.closing_window(items_);
    notices(panes.object.high.y);
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
    if (commands_.exporting()) {
        const ProgressState progress = commands_.progress();
        notices.push_back({fmt::format("Exporting: {}", progress_text(progress)),
                           {"Stop the export"},
                           false,
                           progress.share});
    }
    if (files.asks())
        notices.push_back({fmt::format("{} has changed on disk; the recipe here is not saved",
                                       file_name(files.recipe())),
                           {"Take the file's", "Keep this one"}});
    const std::string answer = notices_.show(items_, std::move(notices), bottom);
    if (answer == "Stop the export") commands_.stop_export();
    if (answer == "Take the file's") files.reload();
    if (answer == "Keep this one") {
        files.keep();
        session_.history().forget_saved();
    }
}

}  // namespace burl
