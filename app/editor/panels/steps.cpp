// The list of the history's steps, and the states kept to compare with.
#include <array>
#include <string>

#include <fmt/format.h>
#include <imgui.h>

#include "app/editor/panels/panels.h"
#include "app/editor/widgets/flow.h"
#include "app/editor/widgets/widgets.h"

namespace burl {

namespace {

/// The row of a state: keep it, go back to it, forget it.
void kept_state(const PanelContext& context, std::size_t index) {
    constexpr std::array states{"A", "B"};
    std::optional<Recipe>& kept = context.session.kept[index];
    const std::string name = states[index];
    ImGui::PushID(name.c_str());
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(name.c_str());
    ImGui::SameLine();
    const char* const back = "go back to it";
    const char* const none = "nothing kept";
    const bool is_kept = kept.has_value();  // as this frame shows it, whatever its buttons do
    const std::vector<float> widths =
        is_kept ? std::vector{button_width("keep this"), button_width(back), button_width("forget")}
                : std::vector{button_width("keep this"), ImGui::CalcTextSize(none).x};
    Flow flow(widths);
    flow.next();
    if (ImGui::Button("keep this")) kept = context.session.recipe();
    context.items.note("keep:" + name);
    tip(fmt::format("Keeps the recipe as it is now, as {} (Shift+{}).", name, name).c_str());
    if (is_kept) {
        flow.next();
        if (ImGui::Button(back))
            context.session.build([&](const Recipe&) {
                return GraphEdit{*kept, fmt::format("go back to {}", name), ""};
            });
        context.items.note("back to:" + name);
        tip("Makes what was kept the recipe again, as one step.");
        flow.next();
        if (ImGui::Button("forget")) kept.reset();
        context.items.note("forget:" + name);
        tip("Keeps nothing here any more.");
    } else {
        flow.next();
        ImGui::TextDisabled("%s", none);
    }
    ImGui::PopID();
}

}  // namespace

void steps_panel(const PanelContext& context) {
    EditHistory& history = context.session.history();
    for (std::size_t i = 0; i < context.session.kept.size(); ++i) kept_state(context, i);
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyle().Colors[ImGuiCol_TextDisabled]);
    ImGui::TextWrapped("The key A shows them one after the other.");
    ImGui::PopStyleColor();
    ImGui::Separator();
    if (ImGui::BeginChild("steps")) {
        for (std::size_t i = 0; i < history.step_count(); ++i) {
            const bool present = i == history.step();
            const bool undone = i > history.step();
            if (undone)
                ImGui::PushStyleColor(ImGuiCol_Text,
                                      ImGui::GetStyle().Colors[ImGuiCol_TextDisabled]);
            const std::string words = fmt::format("{}  {}##{}", i, history.words(i), i);
            const bool clicked = ImGui::Selectable(words.c_str(), present);
            if (undone) ImGui::PopStyleColor();
            context.items.note(fmt::format("step:{}", i));
            if (clicked) {
                history.return_to(i);
                break;
            }
        }
        if (ImGui::GetScrollY() >= ImGui::GetScrollMaxY()) ImGui::SetScrollHereY(1.0f);
    }
    ImGui::EndChild();
}

}  // namespace burl
