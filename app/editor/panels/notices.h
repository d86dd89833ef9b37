#pragma once
// What is going on beside the user interface, and questions that can wait: lines in the lower left
// corner of the object.
#include <string>
#include <vector>

#include "app/editor/panels/items.h"

namespace burl {

struct Notice {
    std::string text{};
    std::vector<std::string> answers{};
    bool problem = false;
};

/// Nothing at all without notices. `bottom`: where the object's view ends. The answer that was
/// clicked in this frame; empty: none.
std::string notices_panel(EditItems& items, const std::vector<Notice>& notices, float bottom);

}  // namespace burl
