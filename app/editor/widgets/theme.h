#pragma once
// The look of the user interface: colours of the dark and the light theme, spacing and rounding.

#include <imgui.h>

#include "app/editor/session/preferences.h"

namespace burl {

/// Sets colours, spacing and rounding of a style for interface scale 1.
void set_theme(ImGuiStyle& style, Theme theme);

/// Colours of what the panels draw themselves, beside ImGui's own.
struct Palette {
    ImU32 accent;         ///< what is chosen, and icons that are on
    ImU32 fill;           ///< the part of a slider below its value
    ImU32 handle;         ///< a slider's value
    ImU32 keyed;          ///< background of numbers that have keys
    ImU32 key, chosen;    ///< a key of the timeline, and a chosen one
    ImU32 edge;           ///< outline of keys and handles
    ImU32 lane, tick;     ///< the timeline's lanes and its ruler
    ImU32 head;           ///< the present time
    ImU32 problem, hint;  ///< text of problems, and of remarks that ask for attention
    ImU32 quiet;          ///< text that explains
    ImU32 screen;         ///< what is behind all windows
    ImU32 star;           ///< favourites
};

/// The palette of the theme that ImGui's current style has.
const Palette& palette();

/// A colour of the palette as ImGui's style colours are given.
inline ImVec4 style_color(ImU32 color) {
    return ImGui::ColorConvertU32ToFloat4(color);
}

/// Lets corners of any radius be drawn in the frame that has just begun. ImGui 1.86 divides by the
/// number of a circle's segments, which is 0 for a radius below a millionth of a pixel; corners
/// have such a radius where a rectangle is hardly wider than one or two pixels.
void allow_tiny_corners();

}  // namespace burl
