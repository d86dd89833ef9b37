#include "app/editor/panels/scale.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace burl {

namespace {

constexpr std::array steps{0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0, 2.5, 3.0, 4.0};
constexpr float font_pixels = 13.0f;
constexpr double hair = 1e-6;

}  // namespace

double larger_scale(double scale) {
    const auto next = std::ranges::upper_bound(steps, scale + hair);
    return next == steps.end() ? steps.back() : *next;
}

double smaller_scale(double scale) {
    const auto next = std::ranges::lower_bound(steps, scale - hair);
    return next == steps.begin() ? steps.front() : *(next - 1);
}

void set_interface_scale(double scale) {
    ImGuiStyle style;
    ImGui::StyleColorsDark(&style);
    style.ScaleAllSizes(float(scale));
    ImGui::GetStyle() = style;
    ImFontConfig font;
    font.SizePixels = std::round(font_pixels * float(scale));
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    fonts.Clear();
    fonts.AddFontDefault(&font);
}

double interface_scale() {
    const ImVector<ImFont*>& fonts = ImGui::GetIO().Fonts->Fonts;
    return fonts.empty() ? 0.0 : double(fonts[0]->FontSize / font_pixels);
}

}  // namespace burl
