#pragma once
// Notices in the lower left corner of the object's view: background work under way, and questions
// that can wait.
#include <string>
#include <vector>

#include "app/editor/panels/items.h"

namespace burl {

/// A line of text with buttons for its answers.
struct Notice {
    std::string text{};
    std::vector<std::string> answers{};
    bool problem = false;
};

/// Draws the notices, their lower edge at y = `bottom`, the end of the object's view; nothing
/// without notices. Returns the answer clicked in this frame; empty: none.
std::string notices_panel(EditItems& items, const std::vector<Notice>& notices, float bottom);

}  // namespace burl
