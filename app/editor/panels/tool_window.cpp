#include "app/editor/panels/tool_window.h"

namespace burl {

bool begin_tool_window(const char* name, bool& on, const ImVec2& low) {
    constexpr float margin = 8.0f;
    ImGui::SetNextWindowPos({low.x + margin, low.y + margin});
    ImGui::SetNextWindowBgAlpha(0.8f);
    return ImGui::Begin(name, &on,
                        ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                            ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoFocusOnAppearing);
}

}  // namespace burl
