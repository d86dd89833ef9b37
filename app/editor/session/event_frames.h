#pragma once
// Events that came while one frame was drawn, as the frames that must see them one after another: a
// click whose press and release fell into one slow frame would else be none. (Dear ImGui does so
// itself from 1.87 on, by io.ConfigInputTrickleEventQueue; Debian 12 packages 1.86.)
#include <vector>

#include "app/editor/session/input.h"

namespace burl {

/// In their order, at least one frame. No frame has two changes of a key or button, moves beside a
/// change of a button, a key's change after a button's, or a modifier's after another key's press.
std::vector<std::vector<InputEvent>> in_frames(const std::vector<InputEvent>& events);

}  // namespace burl
