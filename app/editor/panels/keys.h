#pragma once
// Hands input to Dear ImGui, and says which shortcuts were pressed.
#include <imgui.h>

#include <string_view>

#include "app/editor/session/input.h"

namespace burl {

/// Tells ImGui where its keys are; once per context.
void map_keys(ImGuiIO& io);

/// One event of kinds move, button, wheel, key and text; nothing happens for others.
void feed(ImGuiIO& io, const InputEvent& event);

/// Before every frame: forgets popups that were opened and not shown yet where Escape is down, at
/// which Dear ImGui would look for their windows.
void forget_unseen_popups();

/// Whether the last letter of "Ctrl+Shift+Z" went down since the last frame with just these
/// modifiers held.
bool pressed(std::string_view shortcut);

/// Where the pointer is on the screen, y down.
Vec2d pointer_now();

}  // namespace burl
