#pragma once
// Input events that arrived while one frame was drawn, split into frames that process them one
// after another: a click whose press and release arrive during one slow frame would otherwise be
// lost. (Dear ImGui does so itself from 1.87 on, by io.ConfigInputTrickleEventQueue; Debian 12
// packages 1.86.)
#include <vector>

#include "app/editor/session/input.h"

namespace burl {

/// The events in their order, split into at least one frame. No frame has two changes of one key or
/// of buttons, a pointer's move and a change of a button, a wheel or key event after a change of a
/// button, or a modifier's change after another key's press.
std::vector<std::vector<InputEvent>> in_frames(const std::vector<InputEvent>& events);

}  // namespace burl
