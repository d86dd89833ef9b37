// Panels that are lists: the log, the keyboard shortcuts, recipes left behind, and entries of
// menus.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "app/editor/panels/panels.h"
#include "app/editor/panels/widgets.h"

namespace burl {

namespace {

constexpr auto keys = std::to_array<std::pair<const char*, const char*>>({
    {"left drag", "turn the object"},
    {"right or middle drag", "move it"},
    {"wheel", "nearer, farther"},
    {"F", "fit into the view"},
    {"1, 3, 7", "front, side, top"},
    {"L", "light on or off"},
    {"T", "turntable"},
    {"V", "the atlas beside the object, and back"},
    {"W, B", "wireframe, borders of charts on or off"},
    {"over the atlas: drag, wheel; F", "move, nearer; fit"},
    {"Ctrl+Z, Ctrl+Y", "undo, redo"},
    {"Ctrl+O", "open a mesh or recipe"},
    {"Ctrl+S; Ctrl+Shift+S", "save the recipe; under another name"},
    {"Ctrl+E", "export mesh, texture or shader"},
    {"Ctrl+Q", "quit; asks where something is not saved"},
    {"F5", "read mesh and recipe again"},
    {"Ctrl+Shift+C", "copy the burl command line"},
    {"Ctrl+C, Ctrl+V", "copy, paste the recipe as JSON"},
    {"A; Shift+A, Shift+B", "compare with what was opened, or kept; keep as A, as B"},
    {"N", "the graph: nodes and wires"},
    {"graph: Insert, Delete, Enter", "add a node, delete, look at it alone"},
    {"graph: arrows; Ctrl+C, V, X, G; F", "choose; copy, paste, cut, group; fit"},
    {"P", "paint on the surface, and back"},
    {"comma, period; X", "painting: smaller, larger brush; eraser"},
    {"G", "move the texture on the surface, and back"},
    {"drag, arrow keys", "moving the texture; Shift turns, Ctrl sizes, Escape takes back"},
    {"Alt+left drag", "painting, moving: turn the object"},
    {"Ctrl+plus, Ctrl+minus, Ctrl+0", "larger, smaller, normal text"},
    {"arrows, Space, Tab", "go from item to item, use it, edit it"},
    {"K", "timeline: keys of numbers over time"},
    {"Space; I; Delete", "timeline: play; key the number last touched; remove the chosen key"},
    {"F12", "screenshot"},
    {"F1", "this list"},
    {"double-click a slider", "its default"},
    {"Ctrl-click a slider", "type a number"},
    {"Shift while dragging", "a tenth of the speed"},
});

/// Draws a left recipe with its buttons; returns whether one was pressed.
bool left_row(const PanelContext& context, EditAutosave& autosave, std::size_t left) {
    const LeftRecipe& recipe = autosave.left_behind()[left];
    const std::string number = left == 0 ? "" : fmt::format(" {}", left + 1);
    ImGui::PushID(int(left));
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(recipe.title.c_str());
    ImGui::SameLine();
    const bool taken = ImGui::Button("Take it");
    context.items.note("recover" + number);
    ImGui::SameLine();
    const bool unwanted = ImGui::Button("Throw it away");
    context.items.note("do not recover" + number);
    ImGui::PopID();
    if (taken && context.session.recover_recipe(recipe.json, recipe.file))
        autosave.take(left, context.session.history());
    else if (unwanted)
        autosave.throw_away(left);
    return taken || unwanted;
}

}  // namespace

void log_panel(const PanelContext& context) {
    for (const LogLine& line : context.session.log()) {
        if (line.problem) ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1.0f, 0.55f, 0.4f, 1.0f));
        ImGui::TextWrapped("%s", line.text.c_str());
        if (line.problem) ImGui::PopStyleColor();
    }
    if (ImGui::GetScrollY() >= ImGui::GetScrollMaxY()) ImGui::SetScrollHereY(1.0f);
}

bool cheat_sheet(const PanelContext& context) {
    bool open = true;
    if (begin_centred_window("Keys", &open)) {
        if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
            for (const auto& [key, what] : keys) {
                ImGui::TableNextColumn();
                ImGui::TextUnformatted(key);
                ImGui::TableNextColumn();
                ImGui::TextUnformatted(what);
            }
            ImGui::EndTable();
        }
        if (ImGui::Button("Close")) open = false;
        context.items.note("close keys");
    }
    ImGui::End();
    return open;
}

void recovery_window(const PanelContext& context, EditAutosave& autosave) {
    if (autosave.left_behind().empty()) return;
    begin_centred_window("Unsaved work");
    ImGui::TextUnformatted("What was not saved by an editor that did not end well:");
    for (std::size_t i = 0; i < autosave.left_behind().size(); ++i)
        if (left_row(context, autosave, i)) break;
    if (ImGui::Button("Ask again at the next start")) autosave.leave_all();
    context.items.note("recover later");
    ImGui::End();
}

}  // namespace burl
