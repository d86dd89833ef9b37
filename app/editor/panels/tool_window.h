#pragma once
// The small window of a tool, in the upper left corner of the object's view.
#include <imgui.h>

namespace burl {

/// Calls ImGui::Begin for a tool's window, which ImGui::End must follow. `low`: the view's corner.
/// The window's close button clears `on`. The window does not take the keyboard's focus.
bool begin_tool_window(const char* name, bool& on, const ImVec2& low);

}  // namespace burl
