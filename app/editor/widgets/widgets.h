#pragma once
// What the panels share: the scale of text and panels, windows, entries of menus, colour fields and
// gestures of Dear ImGui.
#include <imgui.h>

#include <string>

#include "app/editor/session/history.h"
#include "app/editor/widgets/fonts.h"
#include "app/editor/widgets/items.h"
#include "app/editor/widgets/theme.h"
#include "atlas/base/image.h"

namespace burl {

/// The next larger or smaller scale of a fixed list from 0.5 to 4, clamped at its ends; at scale 1
/// a line of text is 17 pixels high.
double larger_scale(double scale);
double smaller_scale(double scale);

/// Sets style and fonts of ImGui's current context, between frames; the fonts are rasterised at
/// that size, so that they stay sharp, and their texture must be uploaded again.
void set_interface(double scale, Theme theme, InterfaceFonts& fonts);

/// The scale set last; 1: none yet.
double interface_scale();

/// Flags of the windows that fill the screen.
inline constexpr ImGuiWindowFlags fixed_window =
    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
    ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoTitleBar;

/// Calls ImGui::Begin for a window in the middle of the screen, as large as its content, which
/// ImGui::End must follow. The window's close button clears `open`; null: it has none.
bool begin_centred_window(const char* name, bool* open = nullptr);

/// Calls ImGui::Begin for the small window of a tool, which ImGui::End must follow, in the upper
/// left corner `low` of the object's view. The window's close button clears `on`. The window does
/// not take the keyboard's focus.
bool begin_tool_window(const char* name, bool& on, const ImVec2& low);

/// Draws an entry of a menu, "menu:LABEL" among the items; returns whether it was chosen.
bool menu_item(EditItems& items, const char* label, const char* key, bool enabled = true);
/// Draws an entry of a menu that switches `value`, "menu:LABEL" among the items.
void menu_toggle(EditItems& items, const char* label, const char* key, bool& value);

/// Draws a heading that folds and unfolds the rows below it, `item` among the items; returns
/// whether they are shown. `label` may end in "##ID" as ImGui's labels do.
bool begin_section(EditItems& items, const std::string& label, const std::string& item,
                   bool begins_open);

/// Shortens a text to a width, ending in dots where it does not fit.
std::string shortened(std::string text, float width);

/// Draws the name of a row, `width` wide and as high as a slider. `id` is the row's for ImGui.
void row_name(const std::string& text, const std::string& id, float width);

/// Draws the name of a row and places the widget that follows beside it, in the same columns for
/// all rows of a panel; `room` is left free at the row's end.
void begin_row(const std::string& name, const std::string& id, float room = 0.0f);

/// Draws the button that does what a window is for; returns whether it was clicked.
bool main_button(const char* label);

/// Draws a check box that is no higher than its text, `item` among the items; returns whether it
/// was clicked.
bool check_box(EditItems& items, const char* label, const std::string& item, bool& value);
/// Draws a button that is one of several choices in a line; returns whether it was clicked.
bool radio_button(EditItems& items, const char* label, const std::string& item, bool on);

/// Begins a tip where the pointer has rested on ImGui's last item; returns whether it is shown:
/// then text and end_tip() must follow. Tips of a panel at the right end of the screen stand
/// beside it, so that they cover none of its items.
bool begin_tip();
void end_tip();
/// Shows a sentence as tip of ImGui's last item.
void tip(const char* sentence);
/// Whether the pointer has just come to rest, so that a tip is due soon without further input.
bool tip_is_due();

/// Draws a field that edits a colour; returns whether it was edited in this frame.
bool edit_color(const char* label, Rgb8& color);
/// Draws a field that edits a colour and its alpha; returns whether it was edited in this frame.
bool edit_color(const char* label, Rgb8& color, std::uint8_t& alpha);

/// Begins and ends a gesture of `history` with one of ImGui's last item.
void follow_gesture(EditHistory& history);

}  // namespace burl
