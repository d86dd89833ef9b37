#include "app/editor/widgets/slider.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <imgui.h>
#include <imgui_internal.h>

#include "app/editor/widgets/theme.h"

namespace burl {

namespace {

constexpr float fine_speed = 0.1f;    // of the pointer, with Shift
constexpr float mark_height = 0.12f;  // of the line below the number, in font sizes
constexpr float frame_edge = 2.0f;    // ImGui keeps a slider's grab this far from its frame

/// A slider's frame, and where the middle of ImGui's grab may be.
struct Frame {
    ImVec2 low, high;
    float begin, length;
    float x_of(double share) const { return begin + float(share) * length; }
};

Frame next_frame() {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::CalcItemWidth(), inside = width - 2.0f * frame_edge;
    const float grab = std::min(ImGui::GetStyle().GrabMinSize, inside);
    return {low,
            {low.x + width, low.y + ImGui::GetFrameHeight()},
            low.x + frame_edge + 0.5f * grab,
            std::max(inside - grab, 0.0f)};
}

/// Draws the frame, and what lies between zero, or the range's end, and the value.
void draw(const Frame& frame, ImGuiID id, double value, const SliderRange& range,
          SliderScale scale) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImGuiContext& context = *GImGui;
    const bool active = context.ActiveId == id, hovered = context.HoveredIdPreviousFrame == id;
    const float rounding = ImGui::GetStyle().FrameRounding;
    list.AddRectFilled(frame.low, frame.high,
                       ImGui::GetColorU32(active    ? ImGuiCol_FrameBgActive
                                          : hovered ? ImGuiCol_FrameBgHovered
                                                    : ImGuiCol_FrameBg),
                       rounding);
    if (ImGui::TempInputIsActive(id)) return;
    const float x = frame.x_of(share_of(value, range, scale));
    const bool both = range.low < 0.0 && range.high > 0.0;
    const float from = both ? frame.x_of(share_of(0.0, range, scale)) : frame.low.x;
    const float left = std::min(from, x), right = std::max(from, x);
    list.AddRectFilled({left, frame.low.y}, {right, frame.high.y}, palette().fill, rounding,
                       both ? ImDrawFlags_RoundCornersNone : ImDrawFlags_RoundCornersLeft);
    // The value's mark is below the number, which it must not cover.
    const ImU32 mark = active || hovered ? palette().handle : palette().accent;
    const float thick = mark_height * ImGui::GetFontSize();
    list.AddRectFilled({left, frame.high.y - thick}, {right, frame.high.y}, mark);
    list.AddRectFilled({x - 2.0f * thick, frame.high.y - 2.0f * thick},
                       {x + 2.0f * thick, frame.high.y}, mark, thick);
}

/// Makes ImGui draw a slider's number alone.
struct NumberAlone {
    static constexpr std::array colors{ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered,
                                       ImGuiCol_FrameBgActive, ImGuiCol_SliderGrab,
                                       ImGuiCol_SliderGrabActive};
    NumberAlone() {
        for (const ImGuiCol color : colors)
            ImGui::PushStyleColor(color, ImVec4(0.0f, 0.0f, 0.0f, 0.0f));
    }
    NumberAlone(const NumberAlone&) = delete;
    NumberAlone& operator=(const NumberAlone&) = delete;
    ~NumberAlone() { ImGui::PopStyleColor(int(colors.size())); }
};

}  // namespace

double share_of(double value, const SliderRange& range, SliderScale scale) {
    const double share = scale == SliderScale::linear
                             ? (value - range.low) / (range.high - range.low)
                             : std::log(value / range.low) / std::log(range.high / range.low);
    return share >= 0.0 ? std::min(share, 1.0) : 0.0;
}

bool slide(const char* id, double& value, const SliderRange& range, SliderScale scale,
           const char* format) {
    ImGuiIO& io = ImGui::GetIO();
    const ImGuiID self = ImGui::GetID(id);
    const ImGuiContext& context = *GImGui;
    const Frame frame = next_frame();
    draw(frame, self, value, range, scale);
    const bool fine = io.KeyShift && !io.KeyCtrl;
    const bool held = context.ActiveId == self && !ImGui::TempInputIsActive(self) &&
                      context.ActiveIdSource == ImGuiInputSource_Mouse;
    const bool begins = !held && fine && io.MouseClicked[0];
    // ImGui is told of a pointer that moves at the speed wanted, from where it began.
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID key = ImGui::GetID((std::string(id) + " pointer").c_str());
    const double before = value;
    const float real = io.MousePos.x;
    if (held)
        io.MousePos.x = storage.GetFloat(key) + (fine ? fine_speed : 1.0f) * io.MouseDelta.x;
    else if (begins && real >= frame.low.x && real < frame.high.x)
        io.MousePos.x = frame.x_of(share_of(value, range, scale));
    bool changed = false;
    {
        const NumberAlone alone;
        changed = ImGui::SliderScalar(
            id, ImGuiDataType_Double, &value, &range.low, &range.high, format,
            scale == SliderScale::linear ? ImGuiSliderFlags_None : ImGuiSliderFlags_Logarithmic);
    }
    if (context.ActiveId == self) storage.SetFloat(key, io.MousePos.x);
    io.MousePos.x = real;
    // Rounding alone moves nothing.
    if ((held && io.MouseDelta.x == 0.0f) || (begins && ImGui::IsItemActivated())) {
        value = before;
        changed = false;
    }
    return changed;
}

}  // namespace burl
