#include "app/editor/panels/notices.h"

#include <imgui.h>

#include <utility>

#include "app/editor/panels/theme.h"

namespace burl {

namespace {

constexpr double news_seconds = 12.0;
constexpr float most_width = 40.0f;  // maximum width of a line, in font sizes

/// Draws the lines of a window of notices; returns the answer clicked.
std::string notice_lines(EditItems& items, const std::vector<Notice>& notices) {
    std::string answer;
    for (const Notice& notice : notices) {
        if (notice.problem) ImGui::PushStyleColor(ImGuiCol_Text, palette().problem);
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
    return answer;
}

}  // namespace

void EditNotices::tell(std::string text, bool problem) {
    news_ = {std::move(text), {"Dismiss"}, problem};
    until_ = seconds_() + news_seconds;
}

std::string EditNotices::show(EditItems& items, std::vector<Notice> notices, float bottom) {
    if (seconds_() < until_) notices.push_back(news_);
    if (notices.empty()) return {};
    const float margin = ImGui::GetStyle().WindowPadding.x;
    ImGui::SetNextWindowPos({margin, bottom - margin}, ImGuiCond_Always, {0.0f, 1.0f});
    ImGui::SetNextWindowBgAlpha(0.85f);
    ImGui::Begin("Notices", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoNav);
    const std::string answer = notice_lines(items, notices);
    ImGui::End();
    if (answer == "Dismiss") until_ = 0.0;
    return answer;
}

}  // namespace burl
