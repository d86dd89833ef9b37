#pragma once
// Input for Dear ImGui, and keyboard shortcuts.
#include <imgui.h>

#include <string_view>

#include "app/editor/session/input.h"

namespace burl {

/// Tells ImGui's current context the numbers of its keys; called once.
void map_keys(ImGuiIO& io);

/// Passes an event of kind move, button, wheel, key or text to ImGui; other kinds are ignored.
void feed(ImGuiIO& io, const InputEvent& event);

/// Releases all keys: their own release may never arrive, where a window manager took it.
void release_keys(ImGuiIO& io);

/// Closes popups that were opened but not drawn yet, if Escape is down: Dear ImGui would look for
/// their windows. Called before every frame.
void forget_unseen_popups();

/// Whether the last key of a shortcut such as "Ctrl+Shift+Z" went down since the last frame with
/// exactly these modifiers held.
bool pressed(std::string_view shortcut);

/// The pointer's position on the screen, y down.
Vec2d pointer_now();

}  // namespace burl
