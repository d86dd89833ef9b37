#pragma once
// What a newcomer may try first: three things, each ticked once it was done.
#include <cstdint>
#include <optional>

#include <imgui.h>

#include "app/editor/session/history.h"
#include "app/editor/tools/view.h"
#include "app/editor/widgets/items.h"

namespace burl {

/// Which of the first steps were done since the start.
struct FirstSteps {
    bool turned = false, chosen = false, changed = false;
    std::optional<EditCamera> camera{};       ///< the first camera
    std::optional<std::uint64_t> document{};  ///< the first document's number
};

/// Notes what was done: the object turned, another recipe opened, a recipe changed.
void follow(FirstSteps& steps, const EditHistory& history, const EditCamera& camera);

/// Draws the window in the upper right corner of the object's view; returns false once it was
/// closed. The item of its button is "close first steps".
bool first_steps_window(EditItems& items, const FirstSteps& steps, const ImVec2& corner);

}  // namespace burl
