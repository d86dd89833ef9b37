// Panels that are lists: the log, the keyboard shortcuts, recipes left behind, and entries of
// menus.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <span>

#include "app/editor/panels/panels.h"
#include "app/editor/widgets/widgets.h"

namespace burl {

namespace {

constexpr auto key_lines = std::to_array<KeyLine>({
    {"The object", nullptr},
    {"left drag", "turn it"},
    {"right or middle drag", "move it"},
    {"wheel", "nearer, farther, where the pointer is"},
    {"F", "fit into the view"},
    {"1, 3, 7", "front, side, top"},
    {"L", "light, or the texture's own colours; View > Light: which light"},
    {"T", "turntable"},
    {"W, B", "wireframe, borders of charts"},
    {"V", "the atlas beside the object; over it F fits it"},
    {"The texture", nullptr},
    {"G", "move it: drag, arrow keys; Shift turns, Ctrl sizes; Escape: back"},
    {"P", "paint on the surface: a colour, or a mask of the graph"},
    {"comma, period; X", "smaller, larger brush; eraser"},
    {"Alt+left drag", "turn the object all the same"},
    {"A; Shift+A, Shift+B", "compare with what was opened, or kept; keep as A, as B"},
    {"Ctrl+Z; Ctrl+Y, Ctrl+Shift+Z", "undo; redo"},
    {"Sliders", nullptr},
    {"double-click", "as it was opened; again: the default"},
    {"Ctrl-click", "type a number"},
    {"Shift while dragging", "a tenth of the speed"},
    {"arrows, Space, Tab", "go through the panels, use, edit"},
    {"The graph", nullptr},
    {"N", "nodes and wires"},
    {"Insert, Tab, Space", "add a node; so does a wire dropped beside all nodes"},
    {"Delete, Backspace", "delete what is chosen"},
    {"Enter; Escape", "look at a node alone; end that, choose nothing"},
    {"Ctrl+C, Ctrl+X, Ctrl+V", "copy, cut, paste nodes"},
    {"Ctrl+G; F", "group; fit"},
    {"arrows", "choose in the tree"},
    {"Files", nullptr},
    {"Ctrl+O; F5", "open a mesh or recipe; read them again"},
    {"Ctrl+S, Ctrl+Shift+S", "save the recipe; under another name"},
    {"Ctrl+E", "export mesh, texture or shader"},
    {"Ctrl+C, Ctrl+V", "copy, paste the recipe as JSON"},
    {"Ctrl+Shift+C", "copy the burl command line"},
    {"F12", "screenshot"},
    {"Ctrl+Q", "quit; asks where something is not saved"},
    {"Time", nullptr},
    {"K; Space", "timeline; play, stop"},
    {"I, Delete", "key the number last touched; remove the chosen key"},
    {"The window", nullptr},
    {"Ctrl+Plus, Ctrl+Minus, Ctrl+0", "larger, smaller, normal text"},
    {"F1", "this list"},
});
constexpr std::size_t second_column = 22;  // the first line of the right half, a heading
constexpr float two_columns = 70.0f;       // width of both halves, in font sizes

/// Draws a half of the list of keys.
void key_table(const char* id, std::span<const KeyLine> lines) {
    if (!ImGui::BeginTable(id, 2, ImGuiTableFlags_SizingFixedFit)) return;
    for (const KeyLine& line : lines) {
        ImGui::TableNextColumn();
        if (!line.does) {
            ImGui::Spacing();
            ImGui::PushFont(heading_font());
            ImGui::TextUnformatted(line.keys);
            ImGui::PopFont();
            ImGui::TableNextRow();
            continue;
        }
        ImGui::PushStyleColor(ImGuiCol_Text, palette().accent);
        ImGui::TextUnformatted(line.keys);
        ImGui::PopStyleColor();
        ImGui::TableNextColumn();
        // Where the window is narrow, lines end at its edge.
        const float room = ImGui::GetIO().DisplaySize.x - 3.0f * ImGui::GetFontSize();
        const float wide = ImGui::CalcTextSize(line.does).x;
        const float at = ImGui::GetCursorPosX();
        ImGui::PushTextWrapPos(at + std::min(wide + 1.0f, std::max(room - at, 0.2f * room)));
        ImGui::TextUnformatted(line.does);
        ImGui::PopTextWrapPos();
    }
    ImGui::EndTable();
}

/// The answer about a left recipe.
struct LeftAnswer {
    bool given = false;
    std::optional<std::string> view{};  ///< the view of a recipe that was taken
};

LeftAnswer left_row(const PanelContext& context, EditAutosave& autosave, std::size_t left) {
    const LeftRecipe recipe = autosave.left_behind()[left];
    const std::string number = left == 0 ? "" : fmt::format(" {}", left + 1);
    ImGui::PushID(int(left));
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(recipe.title.c_str());
    ImGui::SameLine();
    const bool wanted = ImGui::Button("Take it");
    context.items.note("recover" + number);
    ImGui::SameLine();
    const bool unwanted = ImGui::Button("Throw it away");
    context.items.note("do not recover" + number);
    ImGui::PopID();
    const bool taken = wanted && context.session.recover_recipe(recipe.json, recipe.file);
    if (taken)
        autosave.take(left, context.session.history());
    else if (unwanted)
        autosave.throw_away(left);
    return {wanted || unwanted, taken ? std::optional(recipe.view) : std::nullopt};
}

}  // namespace

std::span<const KeyLine> keys_listed() {
    return key_lines;
}

void log_panel(const PanelContext& context) {
    for (const LogLine& line : context.session.log()) {
        if (line.problem) ImGui::PushStyleColor(ImGuiCol_Text, palette().problem);
        ImGui::TextWrapped("%s", line.text.c_str());
        if (line.problem) ImGui::PopStyleColor();
    }
    if (ImGui::GetScrollY() >= ImGui::GetScrollMaxY()) ImGui::SetScrollHereY(1.0f);
}

bool cheat_sheet(const PanelContext& context) {
    bool open = true;
    if (begin_centred_window("Keys", &open)) {
        const std::span<const KeyLine> all(key_lines);
        ImGui::BeginGroup();
        key_table("left", all.first(second_column));
        ImGui::EndGroup();
        if (ImGui::GetIO().DisplaySize.x > two_columns * ImGui::GetFontSize())
            ImGui::SameLine(0.0f, 2.0f * ImGui::GetFontSize());
        ImGui::BeginGroup();
        key_table("right", all.subspan(second_column));
        ImGui::EndGroup();
        if (ImGui::Button("Close")) open = false;
        context.items.note("close keys");
    }
    ImGui::End();
    return open;
}

std::optional<std::string> recovery_window(const PanelContext& context, EditAutosave& autosave) {
    if (autosave.left_behind().empty()) return {};
    begin_centred_window("Unsaved work");
    ImGui::TextUnformatted("What was not saved by an editor that did not end well:");
    LeftAnswer answer;
    for (std::size_t i = 0; i < autosave.left_behind().size() && !answer.given; ++i)
        answer = left_row(context, autosave, i);
    if (ImGui::Button("Ask again at the next start")) autosave.leave_all();
    context.items.note("recover later");
    ImGui::End();
    return answer.view;
}

}  // namespace burl
