#include "app/editor/widgets/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <imgui_internal.h>

namespace burl {

namespace {

constexpr std::array steps{0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0, 2.5, 3.0, 4.0};
constexpr float line_pixels = 17.0f;
constexpr double hair = 1e-6;
constexpr float label_share = 0.36f;                     // the share of a row that its name has
constexpr float tip_seconds = 0.35f, tip_width = 22.0f;  // of tips: delay, and width in font sizes

}  // namespace

double larger_scale(double scale) {
    const auto next = std::ranges::upper_bound(steps, scale + hair);
    return next == steps.end() ? steps.back() : *next;
}

double smaller_scale(double scale) {
    const auto next = std::ranges::lower_bound(steps, scale - hair);
    return next == steps.begin() ? steps.front() : *(next - 1);
}

void set_interface(double scale, Theme theme, InterfaceFonts& fonts) {
    ImGuiStyle style;
    set_theme(style, theme);
    style.ScaleAllSizes(float(scale));
    style.MouseCursorScale = float(scale);  // the desktop draws the cursor: this only keeps it
    ImGui::GetStyle() = style;
    fonts.load(*ImGui::GetIO().Fonts, std::round(line_pixels * float(scale)));
}

double interface_scale() {
    return double(ImGui::GetStyle().MouseCursorScale);
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

bool begin_section(EditItems& items, const std::string& label, const std::string& item,
                   bool begins_open) {
    const float gap = ImGui::GetStyle().ItemSpacing.y, high = ImGui::GetFrameHeight();
    ImGui::Dummy({1.0f, 0.5f * gap});
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImGuiID id = ImGui::GetID(label.c_str());
    bool& open = *ImGui::GetStateStorage()->GetBoolRef(id, begins_open);
    const float wide = std::max(1.0f, ImGui::GetContentRegionAvail().x);
    if (ImGui::InvisibleButton(label.c_str(), {wide, high})) open = !open;
    items.note(item);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImGui::RenderNavHighlight({low, {low.x + wide, low.y + high}}, id);
    list.AddLine({low.x, low.y - 0.5f * gap}, {low.x + wide, low.y - 0.5f * gap},
                 ImGui::GetColorU32(ImGuiCol_Separator));
    const bool hovered = ImGui::IsItemHovered();
    const ImU32 text = ImGui::GetColorU32(ImGuiCol_Text);
    const float font = ImGui::GetFontSize(), padding = 0.5f * (high - font);
    ImGui::RenderArrow(&list, {low.x - 0.15f * font, low.y + padding + 0.1f * font},
                       hovered ? text : palette().quiet, open ? ImGuiDir_Down : ImGuiDir_Right,
                       0.8f);
    const std::string shown = label.substr(0, label.find("##"));
    ImGui::PushFont(heading_font());
    list.AddText({low.x + font, low.y + padding}, text, shortened(shown, wide - font).c_str());
    ImGui::PopFont();
    return open;
}

std::string shortened(std::string text, float width) {
    if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
    const auto is_tail = [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U; };
    while (!text.empty() && ImGui::CalcTextSize((text + "...").c_str()).x > width) {
        while (text.size() > 1 && is_tail(text.back())) text.pop_back();
        text.pop_back();
    }
    return text + "...";
}

void row_name(const std::string& text, const std::string& id, float width) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::PushItemFlag(ImGuiItemFlags_NoNav, true);  // the arrow keys pass it by
    ImGui::InvisibleButton((id + " name").c_str(), {width, ImGui::GetFrameHeight()});
    ImGui::PopItemFlag();
    ImGui::GetWindowDrawList()->AddText({low.x, low.y + ImGui::GetStyle().FramePadding.y},
                                        ImGui::GetColorU32(ImGuiCol_Text),
                                        shortened(text, width).c_str());
}

void begin_row(const std::string& name, const std::string& id, float room) {
    const float wide = ImGui::GetContentRegionAvail().x, left = ImGui::GetCursorPosX();
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    row_name(name, id + name, std::max(1.0f, label_share * wide - gap));
    ImGui::SameLine(left + label_share * wide);
    ImGui::SetNextItemWidth(std::max(1.0f, (1.0f - label_share) * wide - room));
}

namespace {

/// Draws a widget whose box would be as high as a slider with less padding, centred on the line.
bool small(const auto& widget) {
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    const float less = std::floor(0.75f * padding.y);
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + less);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(padding.x, padding.y - less));
    const bool clicked = widget();
    ImGui::PopStyleVar();
    // The line is as high as any other, and begins where it did.
    ImGuiWindowTempData& place = ImGui::GetCurrentWindow()->DC;
    place.CursorPosPrevLine.y -= less;
    place.PrevLineSize.y += 2.0f * less;
    place.CursorPos.y += less;
    return clicked;
}

}  // namespace

bool main_button(const char* label) {
    ImGui::PushStyleColor(ImGuiCol_Button, palette().fill);
    const bool clicked = ImGui::Button(label);
    ImGui::PopStyleColor();
    return clicked;
}

bool check_box(EditItems& items, const char* label, const std::string& item, bool& value) {
    const bool clicked = small([&] { return ImGui::Checkbox(label, &value); });
    items.note(item);
    return clicked;
}

bool radio_button(EditItems& items, const char* label, const std::string& item, bool on) {
    const bool clicked = small([&] { return ImGui::RadioButton(label, on); });
    items.note(item);
    return clicked;
}

bool begin_tip() {
    const ImGuiContext& context = *GImGui;
    const bool rests = ImGui::IsItemHovered() && !ImGui::IsItemActive() &&
                       !ImGui::IsAnyMouseDown() && context.HoveredIdTimer >= tip_seconds;
    if (!rests) return false;
    const ImGuiWindow& panel = *context.CurrentWindow->RootWindow;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    if (panel.Pos.x > 0.4f * display.x) {
        const float gap = 0.4f * ImGui::GetFontSize();
        ImGui::SetNextWindowPos({panel.Pos.x - gap, ImGui::GetItemRectMin().y}, ImGuiCond_Always,
                                {1.0f, 0.0f});
    }
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ImGui::GetStyle().PopupRounding);
    ImGui::BeginTooltip();
    ImGui::PopStyleVar();
    ImGui::PushTextWrapPos(tip_width * ImGui::GetFontSize());
    return true;
}

void end_tip() {
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

bool tip_is_due() {
    const ImGuiContext& context = *GImGui;
    return context.HoveredId != 0 && context.HoveredIdTimer < tip_seconds &&
           !ImGui::IsAnyMouseDown();
}

void tip(const char* sentence) {
    if (!begin_tip()) return;
    ImGui::TextUnformatted(sentence);
    end_tip();
}

namespace {

std::uint8_t code_of(float share) {
    return std::uint8_t(std::clamp(std::lround(share * 255.0f), 0L, 255L));
}

}  // namespace

bool edit_color(const char* label, Rgb8& color) {
    float rgb[3] = {float(color.r) / 255.0f, float(color.g) / 255.0f, float(color.b) / 255.0f};
    if (!ImGui::ColorEdit3(label, rgb, ImGuiColorEditFlags_DisplayHex)) return false;
    color = {code_of(rgb[0]), code_of(rgb[1]), code_of(rgb[2])};
    return true;
}

bool edit_color(const char* label, Rgb8& color, std::uint8_t& alpha) {
    float rgba[4] = {float(color.r) / 255.0f, float(color.g) / 255.0f, float(color.b) / 255.0f,
                     float(alpha) / 255.0f};
    if (!ImGui::ColorEdit4(label, rgba,
                           ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_AlphaPreviewHalf))
        return false;
    color = {code_of(rgba[0]), code_of(rgba[1]), code_of(rgba[2])};
    alpha = code_of(rgba[3]);
    return true;
}

void follow_gesture(EditHistory& history) {
    if (ImGui::IsItemActivated()) history.begin_gesture();
    if (ImGui::IsItemDeactivated()) history.end_gesture();
}

}  // namespace burl
