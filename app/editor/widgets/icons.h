#pragma once
// Icons of fonts-font-awesome, and buttons that show one; words where that font is not installed.
#include "app/editor/widgets/items.h"

namespace burl {

/// Icons, as the character that the font has for each.
namespace icon {
inline constexpr const char* search = "\uf002";
inline constexpr const char* star = "\uf005";
inline constexpr const char* no_star = "\uf006";
inline constexpr const char* grid = "\uf00a";
inline constexpr const char* home = "\uf015";
inline constexpr const char* redo = "\uf01e";
inline constexpr const char* turntable = "\uf021";
inline constexpr const char* contrast = "\uf042";
inline constexpr const char* move = "\uf047";
inline constexpr const char* play = "\uf04b";
inline constexpr const char* pause = "\uf04c";
inline constexpr const char* up = "\uf062";
inline constexpr const char* fit = "\uf065";
inline constexpr const char* new_folder = "\uf067";
inline constexpr const char* folder = "\uf07b";
inline constexpr const char* undo = "\uf0e2";
inline constexpr const char* light = "\uf0eb";
inline constexpr const char* file = "\uf016";
inline constexpr const char* timeline = "\uf008";
inline constexpr const char* borders = "\uf126";
inline constexpr const char* paint = "\uf1fc";
inline constexpr const char* atlas = "\uf278";
inline constexpr const char* close = "\uf00d";
inline constexpr const char* library = "\uf02d";
inline constexpr const char* parameters = "\uf1de";
inline constexpr const char* colors = "\uf043";
inline constexpr const char* node = "\uf0e8";
inline constexpr const char* steps = "\uf1da";
inline constexpr const char* metrics = "\uf080";
inline constexpr const char* log = "\uf0f6";
inline constexpr const char* done = "\uf058";
inline constexpr const char* not_done = "\uf10c";
}  // namespace icon

/// Returns the icon where ImGui's font has it, else `word`.
const char* icon_or(const char* icon, const char* word);

/// A button with an icon: its tip, key and state.
struct IconButton {
    const char* icon;
    const char* word;  ///< stands in for the icon, and names the item: "tool:WORD"
    const char* tip;
    bool on = false;
    bool enabled = true;
};
/// Draws the button on the line of the one before; returns whether it was clicked.
bool icon_button(EditItems& items, const IconButton& button);

}  // namespace burl
