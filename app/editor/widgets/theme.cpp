#include "app/editor/widgets/theme.h"

#include <array>

#include <imgui_internal.h>

namespace burl {

namespace {

/// The greys and the accent of a theme, from which all of ImGui's colours follow.
struct Tones {
    ImU32 window, popup, bar;      ///< backgrounds
    ImU32 field, hovered, active;  ///< fields, buttons and headings
    ImU32 line, text, dim;
    ImU32 accent, grab;
    ImU32 shade;  ///< over everything behind a question
};

constexpr ImU32 rgb(unsigned code, unsigned alpha = 255) {
    return IM_COL32((code >> 16) & 255U, (code >> 8) & 255U, code & 255U, alpha);
}

constexpr Tones dark_tones{rgb(0x202226), rgb(0x282b30), rgb(0x191b1e), rgb(0x2e3238),
                           rgb(0x383d45), rgb(0x434a54), rgb(0x3a3f47), rgb(0xe4e6e9),
                           rgb(0x8f969f), rgb(0x6aa5e8), rgb(0x59606b), rgb(0x000000, 110)};
constexpr Tones light_tones{rgb(0xf3f3f1), rgb(0xfcfcfb), rgb(0xe7e7e4), rgb(0xe0e1e1),
                            rgb(0xd3d6d9), rgb(0xc3c9d0), rgb(0xcdcfd1), rgb(0x23262a),
                            rgb(0x686e76), rgb(0x1f69bd), rgb(0xa9afb7), rgb(0x40454c, 90)};

constexpr Palette dark_palette{
    .accent = rgb(0x6aa5e8),
    .fill = rgb(0x3d5878),
    .handle = rgb(0x8ab8ec),
    .keyed = rgb(0x4d4022),
    .key = rgb(0xd6b048),
    .chosen = rgb(0xffe896),
    .edge = rgb(0x141517),
    .lane = rgb(0x2a2d33),
    .tick = rgb(0x7b828d),
    .head = rgb(0xf0624a),
    .problem = rgb(0xff9a76),
    .hint = rgb(0xf2c069),
    .quiet = rgb(0x8f969f),
    .screen = rgb(0x191b1e),
    .star = rgb(0xf2c84b),
};
constexpr Palette light_palette{
    .accent = rgb(0x1f69bd),
    .fill = rgb(0xa9c8ea),
    .handle = rgb(0x1f69bd),
    .keyed = rgb(0xf2dfae),
    .key = rgb(0xc08f1c),
    .chosen = rgb(0x7a5300),
    .edge = rgb(0xffffff),
    .lane = rgb(0xdcdddf),
    .tick = rgb(0x7d838b),
    .head = rgb(0xc9371f),
    .problem = rgb(0xb43212),
    .hint = rgb(0x925f00),
    .quiet = rgb(0x686e76),
    .screen = rgb(0xd9d9d6),
    .star = rgb(0xd49a00),
};

ImVec4 with_alpha(ImU32 color, float alpha) {
    ImVec4 result = style_color(color);
    result.w = alpha;
    return result;
}

void set_colors(ImGuiStyle& style, const Tones& tones) {
    const auto set = [&](ImU32 color, std::initializer_list<ImGuiCol> places) {
        for (const ImGuiCol place : places) style.Colors[place] = style_color(color);
    };
    set(tones.text, {ImGuiCol_Text});
    set(tones.dim, {ImGuiCol_TextDisabled, ImGuiCol_PlotLines, ImGuiCol_PlotHistogram});
    set(tones.window, {ImGuiCol_WindowBg, ImGuiCol_TableRowBg, ImGuiCol_TitleBgCollapsed});
    set(tones.popup, {ImGuiCol_PopupBg, ImGuiCol_TitleBg, ImGuiCol_TitleBgActive});
    set(tones.bar, {ImGuiCol_MenuBarBg});
    set(tones.line, {ImGuiCol_Border, ImGuiCol_Separator, ImGuiCol_TableBorderLight,
                     ImGuiCol_TableBorderStrong});
    set(tones.field, {ImGuiCol_FrameBg, ImGuiCol_Button, ImGuiCol_TableHeaderBg});
    set(tones.hovered, {ImGuiCol_FrameBgHovered, ImGuiCol_ButtonHovered, ImGuiCol_HeaderHovered,
                        ImGuiCol_TabHovered, ImGuiCol_Header});
    set(tones.active, {ImGuiCol_FrameBgActive, ImGuiCol_ButtonActive, ImGuiCol_HeaderActive});
    set(tones.accent, {ImGuiCol_CheckMark, ImGuiCol_SeparatorHovered, ImGuiCol_SeparatorActive,
                       ImGuiCol_DragDropTarget, ImGuiCol_NavHighlight, ImGuiCol_SliderGrabActive,
                       ImGuiCol_PlotLinesHovered, ImGuiCol_PlotHistogramHovered});
    set(tones.grab, {ImGuiCol_SliderGrab, ImGuiCol_ScrollbarGrab, ImGuiCol_ResizeGrip});
    set(tones.active, {ImGuiCol_ScrollbarGrabHovered, ImGuiCol_ScrollbarGrabActive,
                       ImGuiCol_ResizeGripHovered, ImGuiCol_ResizeGripActive});
    style.Colors[ImGuiCol_ChildBg] = with_alpha(tones.window, 0.0f);
    style.Colors[ImGuiCol_ScrollbarBg] = with_alpha(tones.window, 0.0f);
    style.Colors[ImGuiCol_BorderShadow] = with_alpha(tones.window, 0.0f);
    style.Colors[ImGuiCol_Tab] = with_alpha(tones.window, 0.0f);
    style.Colors[ImGuiCol_TabUnfocused] = with_alpha(tones.window, 0.0f);
    set(tones.field, {ImGuiCol_TabActive, ImGuiCol_TabUnfocusedActive});
    style.Colors[ImGuiCol_TableRowBgAlt] = with_alpha(tones.field, 0.5f);
    style.Colors[ImGuiCol_TextSelectedBg] = with_alpha(tones.accent, 0.4f);
    set(tones.shade, {ImGuiCol_ModalWindowDimBg, ImGuiCol_NavWindowingDimBg});
}

void set_spacing(ImGuiStyle& style) {
    style.WindowPadding = {12.0f, 10.0f};
    style.FramePadding = {8.0f, 4.0f};
    style.CellPadding = {6.0f, 3.0f};
    style.ItemSpacing = {8.0f, 6.0f};
    style.ItemInnerSpacing = {8.0f, 4.0f};
    style.IndentSpacing = 14.0f;
    style.ScrollbarSize = 10.0f;
    style.GrabMinSize = 10.0f;
    style.WindowRounding = 8.0f;
    style.ChildRounding = 5.0f;
    style.FrameRounding = 5.0f;
    style.PopupRounding = 6.0f;
    style.ScrollbarRounding = 5.0f;
    style.GrabRounding = 4.0f;
    style.TabRounding = 5.0f;
    style.WindowBorderSize = 1.0f;
    style.PopupBorderSize = 1.0f;
    style.FrameBorderSize = 0.0f;
    style.WindowTitleAlign = {0.0f, 0.5f};
    style.WindowMenuButtonPosition = ImGuiDir_None;
}

}  // namespace

void set_theme(ImGuiStyle& style, Theme theme) {
    set_colors(style, theme == Theme::light ? light_tones : dark_tones);
    set_spacing(style);
}

const Palette& palette() {
    const bool light = ImGui::GetStyle().Colors[ImGuiCol_WindowBg].x > 0.5f;
    return light ? light_palette : dark_palette;
}

void allow_tiny_corners() {
    ImU8* const segments = ImGui::GetDrawListSharedData()->CircleSegmentCounts;
    segments[0] = segments[1];
}

}  // namespace burl
