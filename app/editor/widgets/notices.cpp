#include "app/editor/widgets/notices.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include <utility>

#include "app/editor/widgets/theme.h"

namespace burl {

namespace {

constexpr double news_seconds = 12.0;
constexpr float most_width = 30.0f, bar_width = 16.0f;  // of a line, of a bar; in font sizes

/// Draws the lines of a window of notices; returns the answer clicked.
std::string notice_lines(EditItems& items, const std::vector<Notice>& notices) {
    std::string answer;
    for (const Notice& notice : notices) {
        if (notice.problem) ImGui::PushStyleColor(ImGuiCol_Text, palette().problem);
        ImGui::PushTextWrapPos(most_width * ImGui::GetFontSize());
        ImGui::TextUnformatted(notice.text.c_str());
        ImGui::PopTextWrapPos();
        if (notice.problem) ImGui::PopStyleColor();
        if (notice.share >= 0.0)
            ImGui::ProgressBar(float(notice.share), {bar_width * ImGui::GetFontSize(), 0.0f});
        for (const std::string& choice : notice.answers) {
            if (&choice != &notice.answers.front()) ImGui::SameLine();
            if (ImGui::Button(choice.c_str())) answer = choice;
            items.note(choice);
        }
    }
    return answer;
}

}  // namespace

void coarse_sign(EditItems& items, const ImVec2& low, const ImVec2& size, std::uint32_t level) {
    if (level == 0) return;
    const std::string text = fmt::format("1/{} of the texture's size", 1U << std::min(level, 16U));
    const ImVec2 room = ImGui::CalcTextSize(text.c_str()), margin = ImGui::GetStyle().FramePadding;
    const ImVec2 high{low.x + size.x - 2.0f * margin.x, low.y + size.y - 2.0f * margin.x};
    const ImVec2 from{high.x - room.x - 2.0f * margin.x, high.y - room.y - 2.0f * margin.y};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(from, high, IM_COL32(0, 0, 0, 150), ImGui::GetStyle().FrameRounding);
    list.AddText({from.x + margin.x, from.y + margin.y}, IM_COL32(255, 255, 255, 230),
                 text.c_str());
    items.note("coarse level", {{from.x, from.y}, {high.x, high.y}});
}

void EditNotices::tell(std::string text, bool problem) {
    news_ = {std::move(text), {"Dismiss"}, problem};
    until_ = seconds_() + news_seconds;
}

std::string EditNotices::show(EditItems& items, std::vector<Notice> notices, float bottom) {
    shown_ = seconds_() < until_;
    if (shown_) notices.push_back(news_);
    if (notices.empty()) return {};
    const float margin = ImGui::GetStyle().WindowPadding.x;
    ImGui::SetNextWindowPos({margin, bottom - margin}, ImGuiCond_Always, {0.0f, 1.0f});
    ImGui::SetNextWindowBgAlpha(0.85f);
    ImGui::Begin("Notices", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoNav);
    std::string answer = notice_lines(items, notices);
    ImGui::End();
    if (answer == "Dismiss") until_ = 0.0;
    return answer;
}

}  // namespace burl
