#pragma once
// Rows of widgets that need more lines where a panel is narrow or its text large.
#include <imgui.h>

#include <cstddef>
#include <vector>

namespace burl {

/// The width of a button with these words.
inline float button_width(const char* words) {
    return ImGui::CalcTextSize(words).x + 2.0f * ImGui::GetStyle().FramePadding.x;
}

/// Places widgets of known widths beside each other, in as many lines as they need.
class Flow {
  public:
    explicit Flow(const std::vector<float>& widths)
        : widths_(widths), room_(ImGui::GetContentRegionAvail().x) {}

    /// Goes on to the place of the next widget, of which there must be one more.
    void next() {
        const float gap = ImGui::GetStyle().ItemSpacing.x, width = widths_.at(at_++);
        const bool fits = used_ > 0.0f && used_ + gap + width <= room_;
        if (fits) ImGui::SameLine();
        used_ = fits ? used_ + gap + width : width;
    }
    /// The number of lines that widgets need in `room`.
    static int lines(const std::vector<float>& widths, float room) {
        const float gap = ImGui::GetStyle().ItemSpacing.x;
        int lines = 1;
        float used = 0.0f;
        for (const float width : widths) {
            const bool fits = used == 0.0f || used + gap + width <= room;
            if (!fits) ++lines;
            used = fits && used > 0.0f ? used + gap + width : width;
        }
        return lines;
    }

  private:
    const std::vector<float>& widths_;
    float room_, used_ = 0.0f;
    std::size_t at_ = 0;
};

}  // namespace burl
