#include "app/editor/panels/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

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

bool begin_centred_window(const char* name, bool* open) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * display.x, 0.5f * display.y}, ImGuiCond_Always, {0.5f, 0.5f});
    return ImGui::Begin(name, open,
                        ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse);
}

bool begin_tool_window(const char* name, bool& on, const ImVec2& low) {
    constexpr float gap = 8.0f;
    ImGui::SetNextWindowPos({low.x + gap, low.y + gap});
    ImGui::SetNextWindowBgAlpha(0.8f);
    return ImGui::Begin(name, &on,
                        ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                            ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoFocusOnAppearing);
}

bool menu_item(EditItems& items, const char* label, const char* key, bool enabled) {
    const bool chosen = ImGui::MenuItem(label, key, false, enabled);
    items.note(fmt::format("menu:{}", label));
    return chosen;
}

void menu_toggle(EditItems& items, const char* label, const char* key, bool& value) {
    ImGui::MenuItem(label, key, &value);
    items.note(fmt::format("menu:{}", label));
}

namespace {

std::uint8_t code_of(float share) {
    return std::uint8_t(std::clamp(std::lround(share * 255.0f), 0L, 255L));
}

}  // namespace

bool edit_color(const char* label, Rgb8& color) {
    float rgb[3] = {float(color.r) / 255.0f, float(color.g) / 255.0f, float(color.b) / 255.0f};
    if (!ImGui::ColorEdit3(label, rgb)) return false;
    color = {code_of(rgb[0]), code_of(rgb[1]), code_of(rgb[2])};
    return true;
}

bool edit_color(const char* label, Rgb8& color, std::uint8_t& alpha) {
    float rgba[4] = {float(color.r) / 255.0f, float(color.g) / 255.0f, float(color.b) / 255.0f,
                     float(alpha) / 255.0f};
    if (!ImGui::ColorEdit4(label, rgba, ImGuiColorEditFlags_AlphaPreviewHalf)) return false;
    color = {code_of(rgba[0]), code_of(rgba[1]), code_of(rgba[2])};
    alpha = code_of(rgba[3]);
    return true;
}

void follow_gesture(EditHistory& history) {
    if (ImGui::IsItemActivated()) history.begin_gesture();
    if (ImGui::IsItemDeactivated()) history.end_gesture();
}

}  // namespace burl
