#pragma once
// Where the parts of the editor's window lie: the tools and the object on the left, the atlas
// beside or below it, the timeline underneath, the side panel on the right.
#include <imgui.h>

#include "app/editor/panels/changes.h"
#include "app/editor/session/preferences.h"
#include "app/editor/widgets/items.h"

namespace burl {

/// The parts of the window that are to be laid out.
struct PaneWishes {
    ImVec2 size{};      ///< the window's size, in screen coordinates
    float top = 0.0f;   ///< the height of the menu
    float line = 0.0f;  ///< the height of a button: the measure of what has room
    bool atlas = false;
    float timeline = 0.0f;  ///< the height that the timeline's rows need; 0: it is not shown
    int tool_lines = 1;     ///< the lines that the tools need
};

/// The parts' rectangles; the atlas's and the timeline's are empty where they are not shown.
struct Panes {
    ScreenRect tools{}, object{}, atlas{}, timeline{}, side{};
    bool beside = true;  ///< whether the atlas is beside the object, else below
};
Panes panes_of(const PaneWishes& wishes, const PaneShares& shares);

/// Draws the bars between the parts, which drags move and a double-click puts back. Items are
/// "splitter:side", "splitter:atlas" and "splitter:timeline".
void splitters(EditItems& items, const PaneWishes& wishes, const Panes& panes, PaneShares& shares);

}  // namespace burl
