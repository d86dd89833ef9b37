// The graph's place in the window, its pictures, and the badge of a node that is looked at.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/editor/widgets/widgets.h"
#include "app/editor/window/program.h"

namespace burl {

namespace {

constexpr float border_height = 5.0f;  // at interface scale 1

}  // namespace

GraphHooks EditorProgram::graph_hooks() {
    GraphHooks hooks;
    if (node_gallery_)
        hooks.picture = [this](const GraphNodeView& node) { return node_gallery_->picture(node); };
    hooks.clipboard = [this] { return window_->clipboard(); };
    hooks.set_clipboard = [this](const std::string& text) { window_->set_clipboard(text); };
    hooks.look = [this](const std::string& place) { requests_.look(place); };
    hooks.paint = [this](int layer) {
        viewport_.paint.tool.brush.layer = layer;
        if (!viewport_.paint.tool.on) viewport_.take_tool(viewport_.paint.tool.on);
    };
    hooks.looking_at = requests_.looking_at();
    return hooks;
}

/// The graph's height, of the room that it shares with the object; 0: it is not shown.
float EditorProgram::graph_height(float room) {
    return graph_.shown ? std::clamp(float(preferences_.panes.graph), 0.15f, 0.85f) * room : 0.0f;
}

void EditorProgram::graph_window(const ImVec2& low, const ImVec2& size) {
    if (!graph_.shown) return;
    const float border = border_height * float(interface_scale());
    ImGui::SetNextWindowPos(low);
    ImGui::SetNextWindowSize({size.x, border});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0f, 1.0f));
    if (ImGui::Begin("Graph border", nullptr,
                     fixed_window | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoNav)) {
        ImGui::InvisibleButton("border", {std::max(size.x, 1.0f), border});
        items_.note("graph border");
        if (ImGui::IsItemHovered() || ImGui::IsItemActive())
            ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
        const float moved = ImGui::GetIO().MouseDelta.y;
        double& share = preferences_.panes.graph;
        const double room = double(size.y) / std::max(share, 0.1);
        if (ImGui::IsItemActive() && room > 1.0 && moved != 0.0f)
            share = std::clamp(share - double(moved) / room, 0.15, 0.85);
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
    ImGui::SetNextWindowPos({low.x, low.y + border});
    ImGui::SetNextWindowSize({size.x, std::max(1.0f, size.y - border)});
    graph_.window({session_, items_}, graph_hooks());
    if (node_gallery_)
        node_gallery_->follow(graph_, session_,
                              {loader_.files().mesh(), viewport_.light.on_host()});
}

/// Tells over the object what is shown there in the recipe's place.
void EditorProgram::look_badge(const ImVec2& low, const ImVec2& size) {
    const std::string place = requests_.looking_at();
    if (place.empty()) return;
    const auto node = graph_.model().graph().find(place);
    std::string words = node ? graph_.model().graph().nodes[*node].words : place;
    if (const auto range = requests_.look_range())
        words += fmt::format(": black is {:.3g}, white {:.3g}", (*range)[0], (*range)[1]);
    ImGui::SetNextWindowPos({low.x + 0.5f * size.x, low.y + 8.0f}, ImGuiCond_Always, {0.5f, 0.0f});
    ImGui::SetNextWindowBgAlpha(0.85f);
    ImGui::Begin("Look", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoNav);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(fmt::format("Only {}", words).c_str());
    items_.note("look badge");
    ImGui::SameLine();
    if (ImGui::Button("End (Escape)")) requests_.look("");
    items_.note("end look");
    ImGui::End();
}

}  // namespace burl
