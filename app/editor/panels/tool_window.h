#pragma once
// The small window that a tool on the object has at the left upper corner of the object's view.
#include <imgui.h>

namespace burl {

/// ImGui::Begin for it; ImGui::End must follow. `low`: the view's corner; the window's cross clears
/// `on`. It takes no keys from what has them.
bool begin_tool_window(const char* name, bool& on, const ImVec2& low);

}  // namespace burl
