// The bar of tools above the object: what is used most, each an icon with a tip.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/editor/widgets/flow.h"
#include "app/editor/widgets/icons.h"
#include "app/editor/widgets/widgets.h"
#include "app/editor/window/program.h"

namespace burl {

namespace {

/// Goes on to the place of a tool: beside the one before it, `gap` away, or in another line where
/// there is no room.
void next_tool(const IconButton& button, float gap = 2.0f) {
    const float room = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    const float wide = button_width(icon_or(button.icon, button.word));
    if (ImGui::GetItemRectMax().x + gap + wide <= room) ImGui::SameLine(0.0f, gap);
}

/// Draws a tool beside the one before it; returns whether it was clicked.
bool tool(EditItems& items, const IconButton& button) {
    next_tool(button);
    return icon_button(items, button);
}

/// Draws the first tool of a group.
bool first_tool(EditItems& items, const IconButton& button) {
    next_tool(button, ImGui::GetFontSize());
    return icon_button(items, button);
}

void switched(EditItems& items, bool& value, const IconButton& button) {
    if (tool(items, button)) value = !value;
}

}  // namespace

void EditorProgram::toolbar() {
    const float middle = 0.25f * ImGui::GetFrameHeight();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                        ImVec2(ImGui::GetStyle().WindowPadding.x, middle));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(2.0f, 0.0f));
    const bool shown =
        ImGui::Begin("Tools", nullptr,
                     fixed_window | ImGuiWindowFlags_NoScrollbar |
                         ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoNav);
    if (shown) {
        tools_of_edits();
        tools_of_view();
        const float used = ImGui::GetItemRectMax().y - ImGui::GetWindowPos().y - middle;
        tool_lines_ = std::max(1, int(std::lround(used / ImGui::GetFrameHeight())));
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
}

void EditorProgram::tools_of_edits() {
    EditHistory& history = session_.history();
    if (icon_button(items_, {icon::undo, "Undo", "Undo (Ctrl+Z)", false, history.can_undo()}))
        history.undo();
    if (tool(items_, {icon::redo, "Redo", "Redo (Ctrl+Y)", false, history.can_redo()}))
        history.redo();
    if (tool(items_, {icon::contrast, "Compare", "Compare with the recipe as it was opened (A)",
                      requests_.comparing()}))
        requests_.compare();
    if (first_tool(items_, {icon::move, "Move",
                            "Move the texture on the object: drag it, Shift turns, Ctrl sizes (G)",
                            viewport_.move.on}))
        viewport_.take_tool(viewport_.move.on);
    if (tool(items_, {icon::paint, "Paint", "Paint on the surface (P)", viewport_.paint.tool.on}))
        viewport_.take_tool(viewport_.paint.tool.on);
}

void EditorProgram::tools_of_view() {
    if (first_tool(items_, {icon::fit, "Fit", "The whole object in the view (F)"}))
        viewport_.camera = fitted(viewport_.camera);
    switched(items_, viewport_.turntable,
             {icon::turntable, "Turn", "Turntable: the object turns by itself (T)",
              viewport_.turntable});
    switched(items_, viewport_.lit,
             {icon::light, "Light", "Light, or the texture's own colours (L)", viewport_.lit});
    switched(items_, atlas_.edges, {icon::grid, "Wires", "The triangles' edges (W)", atlas_.edges});
    switched(items_, atlas_.borders,
             {icon::borders, "Borders", "The borders of charts (B)", atlas_.borders});
    if (first_tool(items_, {icon::atlas, "Atlas", "The texture as it lies in its atlas (V)",
                            atlas_.state.shown}))
        atlas_.state.shown = !atlas_.state.shown;
    switched(items_, session_.timeline.open,
             {icon::timeline, "Time", "Timeline: numbers that change over time (K)",
              session_.timeline.open});
}

}  // namespace burl
