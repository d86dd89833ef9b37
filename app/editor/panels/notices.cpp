#include "app/editor/panels/notices.h"

#include <imgui.h>

namespace burl {

namespace {

const ImVec4 problem_color{1.0f, 0.55f, 0.4f, 1.0f};  // as in the log
constexpr float most_width = 40.0f;                   // maximum width of a line, in font sizes

}  // namespace

std::string notices_panel(EditItems& items, const std::vector<Notice>& notices, float bottom) {
    if (notices.empty()) return {};
    std::string answer;
    const float margin = ImGui::GetStyle().WindowPadding.x;
    ImGui::SetNextWindowPos({margin, bottom - margin}, ImGuiCond_Always, {0.0f, 1.0f});
    ImGui::SetNextWindowBgAlpha(0.85f);
    ImGui::Begin("Notices", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoNav);
    for (const Notice& notice : notices) {
        if (notice.problem) ImGui::PushStyleColor(ImGuiCol_Text, problem_color);
        ImGui::PushTextWrapPos(most_width * ImGui::GetFontSize());
        ImGui::TextUnformatted(notice.text.c_str());
        ImGui::PopTextWrapPos();
        if (notice.problem) ImGui::PopStyleColor();
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
