// The bar of tools above the object: what is used most, each an icon with a tip.
#include <imgui.h>

#include "app/editor/widgets/icons.h"
#include "app/editor/widgets/widgets.h"
#include "app/editor/window/program.h"

namespace burl {

namespace {

/// A gap between two groups of tools.
void gap() {
    ImGui::SameLine(0.0f, ImGui::GetFontSize());
}

void switched(EditItems& items, bool& value, const IconButton& button) {
    ImGui::SameLine();
    if (icon_button(items, button)) value = !value;
}

}  // namespace

void EditorProgram::toolbar() {
    const float middle = 0.5f * (ImGui::GetFrameHeight() * 1.5f - ImGui::GetFrameHeight());
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                        ImVec2(ImGui::GetStyle().WindowPadding.x, middle));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(2.0f, 0.0f));
    const bool shown =
        ImGui::Begin("Tools", nullptr,
                     fixed_window | ImGuiWindowFlags_NoScrollbar |
                         ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoNav);
    if (shown) {
        tools_of_edits();
        gap();
        tools_of_view();
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
}

void EditorProgram::tools_of_edits() {
    EditHistory& history = session_.history();
    if (icon_button(items_, {icon::undo, "Undo", "Undo (Ctrl+Z)", false, history.can_undo()}))
        history.undo();
    ImGui::SameLine();
    if (icon_button(items_, {icon::redo, "Redo", "Redo (Ctrl+Y)", false, history.can_redo()}))
        history.redo();
    ImGui::SameLine();
    if (icon_button(items_,
                    {icon::contrast, "Compare", "Compare with the recipe as it was opened (A)",
                     requests_.comparing()}))
        requests_.compare();
    gap();
    if (icon_button(items_, {icon::move, "Move",
                             "Move the texture on the object: drag it, Shift turns, Ctrl sizes (G)",
                             viewport_.move.on}))
        viewport_.take_tool(viewport_.move.on);
    ImGui::SameLine();
    if (icon_button(items_,
                    {icon::paint, "Paint", "Paint on the surface (P)", viewport_.paint.tool.on}))
        viewport_.take_tool(viewport_.paint.tool.on);
}

void EditorProgram::tools_of_view() {
    if (icon_button(items_, {icon::fit, "Fit", "The whole object in the view (F)"}))
        viewport_.camera = fitted(viewport_.camera);
    switched(items_, viewport_.turntable,
             {icon::turntable, "Turn", "Turntable: the object turns by itself (T)",
              viewport_.turntable});
    switched(items_, viewport_.lit,
             {icon::light, "Light", "Light, or the texture's own colours (L)", viewport_.lit});
    switched(items_, atlas_.edges, {icon::grid, "Wires", "The triangles' edges (W)", atlas_.edges});
    switched(items_, atlas_.borders,
             {icon::borders, "Borders", "The borders of charts (B)", atlas_.borders});
    gap();
    if (icon_button(items_, {icon::atlas, "Atlas", "The texture as it lies in its atlas (V)",
                             atlas_.state.shown}))
        atlas_.state.shown = !atlas_.state.shown;
    switched(items_, session_.timeline.open,
             {icon::timeline, "Time", "Timeline: numbers that change over time (K)",
              session_.timeline.open});
}

}  // namespace burl
