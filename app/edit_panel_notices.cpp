#include "app/edit_panel_notices.h"

#include <imgui.h>

namespace burl {

std::string notices_panel(EditItems& items, const std::vector<Notice>& notices) {
    if (notices.empty()) return {};
    std::string answer;
    const ImGuiIO& io = ImGui::GetIO();
    const float margin = ImGui::GetStyle().WindowPadding.x;
    ImGui::SetNextWindowPos({margin, io.DisplaySize.y - margin}, ImGuiCond_Always, {0.0f, 1.0f});
    ImGui::SetNextWindowBgAlpha(0.85f);
    ImGui::Begin("Notices", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoNav);
    for (const Notice& notice : notices) {
        ImGui::TextUnformatted(notice.text.c_str());
        for (const std::string& choice : notice.answers) {
            if (&choice != &notice.answers.front()) ImGui::SameLine();
            if (ImGui::Button(choice.c_str())) answer = choice;
            items.note(choice);
        }
    }
    ImGui::End();
    return answer;
}

}  // namespace burl
