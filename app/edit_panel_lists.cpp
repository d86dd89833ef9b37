// Panels that list things: presets, figures, the log, keys.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "app/edit_panels.h"
#include "app/embedded.h"

namespace burl {

namespace {

constexpr std::array<std::pair<const char*, const char*>, 22> keys{{
    {"left drag", "turn the object"},
    {"right or middle drag", "move it"},
    {"wheel", "nearer, farther"},
    {"F", "fit into the view"},
    {"1, 3, 7", "front, side, top"},
    {"L", "light on or off"},
    {"T", "turntable"},
    {"Ctrl+Z, Ctrl+Y", "undo, redo"},
    {"Ctrl+O", "open a mesh or recipe"},
    {"Ctrl+S", "save the recipe"},
    {"Ctrl+E", "export the textured mesh"},
    {"Ctrl+Shift+C", "copy the burl command line"},
    {"Ctrl+C, Ctrl+V", "copy, paste the recipe as JSON"},
    {"A", "compare with the recipe as it was opened"},
    {"P", "paint on the surface, and back"},
    {"comma, period; X", "painting: smaller, larger brush; eraser"},
    {"Alt+left drag", "painting: turn the object"},
    {"F12", "screenshot"},
    {"F1", "this list"},
    {"double-click a slider", "its default"},
    {"Ctrl-click a slider", "type a number"},
    {"Shift while dragging", "a tenth of the speed"},
}};

std::string counted(std::uint64_t count) {
    if (count >= 10000000) return fmt::format("{:.1f} M", double(count) / 1e6);
    if (count >= 10000) return fmt::format("{:.1f} k", double(count) / 1e3);
    return fmt::format("{}", count);
}

std::uint64_t sum(const auto& counts) {
    std::uint64_t all = 0;
    for (const std::uint64_t count : counts) all += count;
    return all;
}

void row(const std::string& name, const std::string& value) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name.c_str());
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", value.c_str());
}

}  // namespace

void presets_panel(const PanelContext& context) {
    for (const EmbeddedFile& file : embedded_recipes()) {
        const std::string name(file.name.substr(0, file.name.rfind('.')));
        if (ImGui::Selectable(name.c_str(), name == context.session.recipe_path()))
            context.session.open_recipe(name);
        context.items.note("preset:" + name);
    }
}

void metrics_panel(const PanelContext&, const MetricsView& view) {
    if (ImGui::BeginTable("facts", 2, ImGuiTableFlags_RowBg)) {
        for (const auto& [name, value] : view.facts) row(name, value);
        ImGui::EndTable();
    }
    if (!ImGui::BeginTable("stages", 4, ImGuiTableFlags_RowBg)) return;
    for (const char* title : {"stage", "ms", "octaves", "spared"}) ImGui::TableSetupColumn(title);
    ImGui::TableHeadersRow();
    for (std::size_t k = 0; k < stage_names.size(); ++k) {
        const StageRecord& record = view.records[Stage(k)];
        if (record.runs == 0) continue;
        ImGui::TableNextRow();
        for (const std::string& text :
             {std::string(stage_names[k]), fmt::format("{:.1f}", 1e3 * record.seconds),
              counted(record.done.work.octaves), counted(sum(record.done.work.octaves_skipped))}) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(text.c_str());
        }
    }
    ImGui::EndTable();
}

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
    ImGui::SetNextWindowPos(
        ImVec2(0.5f * ImGui::GetIO().DisplaySize.x, 0.5f * ImGui::GetIO().DisplaySize.y),
        ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    if (ImGui::Begin("Keys", &open,
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse)) {
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

}  // namespace burl
