#include "app/editor/widgets/icons.h"

#include <string>

#include <imgui.h>

#include "app/editor/widgets/fonts.h"
#include "app/editor/widgets/theme.h"
#include "app/editor/widgets/widgets.h"

namespace burl {

const char* icon_or(const char* icon, const char* word) {
    unsigned code = 0;
    for (const unsigned char c : std::string_view(icon))  // the icons are of three bytes each
        code = (code << 6U) | (c & (code == 0 ? 0x0fU : 0x3fU));
    return has_glyph(ImWchar(code)) ? icon : word;
}

bool icon_button(EditItems& items, const IconButton& button) {
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0.0f, 0.0f, 0.0f, 0.0f));
    if (button.on) ImGui::PushStyleColor(ImGuiCol_Text, palette().accent);
    ImGui::BeginDisabled(!button.enabled);
    const std::string label = std::string(icon_or(button.icon, button.word)) + "##" + button.word;
    const bool clicked = ImGui::Button(label.c_str());
    ImGui::EndDisabled();
    if (button.on) ImGui::PopStyleColor();
    ImGui::PopStyleColor();
    items.note(std::string("tool:") + button.word);
    tip(button.tip);
    return clicked;
}

}  // namespace burl
