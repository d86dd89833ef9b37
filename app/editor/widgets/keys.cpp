#include "app/editor/widgets/keys.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <utility>

namespace burl {

namespace {

/// Our numbering of ImGui's array of keys: the index into this list, then letters, digits and F1 to
/// F12.
constexpr std::array<std::string_view, 22> names{
    "Tab",   "Left",   "Right",  "Up",        "Down",  "PageUp", "PageDown", "Home",
    "End",   "Insert", "Delete", "Backspace", "Space", "Enter",  "Escape",   "Ctrl",
    "Shift", "Alt",    "Plus",   "Minus",     "Comma", "Period"};
constexpr std::array<std::pair<ImGuiKey_, std::string_view>, 21> imgui_keys{
    {{ImGuiKey_Tab, "Tab"},
     {ImGuiKey_LeftArrow, "Left"},
     {ImGuiKey_RightArrow, "Right"},
     {ImGuiKey_UpArrow, "Up"},
     {ImGuiKey_DownArrow, "Down"},
     {ImGuiKey_PageUp, "PageUp"},
     {ImGuiKey_PageDown, "PageDown"},
     {ImGuiKey_Home, "Home"},
     {ImGuiKey_End, "End"},
     {ImGuiKey_Insert, "Insert"},
     {ImGuiKey_Delete, "Delete"},
     {ImGuiKey_Backspace, "Backspace"},
     {ImGuiKey_Space, "Space"},
     {ImGuiKey_Enter, "Enter"},
     {ImGuiKey_Escape, "Escape"},
     {ImGuiKey_A, "A"},
     {ImGuiKey_C, "C"},
     {ImGuiKey_V, "V"},
     {ImGuiKey_X, "X"},
     {ImGuiKey_Y, "Y"},
     {ImGuiKey_Z, "Z"}}};

/// Returns the number of a key; -1 for an unknown name.
int number_of(std::string_view name) {
    const auto found = std::ranges::find(names, name);
    if (found != names.end()) return int(found - names.begin());
    const int rest = int(names.size());
    if (name.size() == 1 && name[0] >= 'A' && name[0] <= 'Z') return rest + (name[0] - 'A');
    if (name.size() == 1 && name[0] >= '0' && name[0] <= '9') return rest + 26 + (name[0] - '0');
    constexpr std::array<std::string_view, 12> functions{"F1", "F2", "F3", "F4",  "F5",  "F6",
                                                         "F7", "F8", "F9", "F10", "F11", "F12"};
    const auto function = std::ranges::find(functions, name);
    if (function != functions.end()) return rest + 36 + int(function - functions.begin());
    return -1;
}

}  // namespace

void map_keys(ImGuiIO& io) {
    for (const auto& [key, name] : imgui_keys) io.KeyMap[key] = number_of(name);
}

void feed(ImGuiIO& io, const InputEvent& event) {
    switch (event.kind) {
        case InputKind::move:
            io.MousePos = ImVec2(float(event.at.x), float(event.at.y));
            break;
        case InputKind::button:
            io.MouseDown[event.button] = event.down;
            break;
        case InputKind::wheel:
            io.MouseWheelH += float(event.at.x);
            io.MouseWheel += float(event.at.y);
            break;
        case InputKind::text:
            io.AddInputCharactersUTF8(event.text.c_str());
            break;
        case InputKind::key: {
            const int number = number_of(event.text);
            if (number >= 0) io.KeysDown[number] = event.down;
            if (event.text == "Ctrl") io.KeyCtrl = event.down;
            if (event.text == "Shift") io.KeyShift = event.down;
            if (event.text == "Alt") io.KeyAlt = event.down;
            break;
        }
        case InputKind::drop:
        case InputKind::resize:
        case InputKind::close:
            break;
    }
}

void release_keys(ImGuiIO& io) {
    std::ranges::fill(io.KeysDown, false);
    io.KeyCtrl = io.KeyShift = io.KeyAlt = false;
}

void forget_unseen_popups() {
    ImGuiContext& context = *ImGui::GetCurrentContext();
    if (!context.IO.KeysDown[number_of("Escape")]) return;
    while (!context.OpenPopupStack.empty() && !context.OpenPopupStack.back().Window)
        context.OpenPopupStack.pop_back();
}

bool pressed(std::string_view shortcut) {
    const ImGuiIO& io = ImGui::GetIO();
    const auto takes = [&](std::string_view modifier) {
        if (!shortcut.starts_with(modifier)) return false;
        shortcut.remove_prefix(modifier.size());
        return true;
    };
    const bool ctrl = takes("Ctrl+"), shift = takes("Shift+");
    const int number = number_of(shortcut);
    return number >= 0 && io.KeyCtrl == ctrl && io.KeyShift == shift && !io.KeyAlt &&
           ImGui::IsKeyPressed(number, false);
}

Vec2d pointer_now() {
    const ImVec2 at = ImGui::GetIO().MousePos;
    return {double(at.x), double(at.y)};
}

}  // namespace burl
