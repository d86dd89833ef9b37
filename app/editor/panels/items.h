#pragma once
// Where the user interface's items are on screen, by name, so that scripts can name what they act
// on and tests need no coordinates.
#include <imgui.h>

#include <map>
#include <optional>
#include <string>

#include "app/editor/session/script.h"

namespace burl {

class EditItems {
  public:
    /// A new frame begins.
    void clear() { rects_.clear(); }
    /// ImGui's last item is `name`; one that is scrolled out of sight is left out.
    void note(const std::string& name) {
        if (!ImGui::IsItemVisible()) return;
        const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
        note(name, {{low.x, low.y}, {high.x, high.y}});
    }
    void note(const std::string& name, const ItemRect& rect) { rects_[name] = rect; }
    /// All rectangles of the last frame, by name.
    const std::map<std::string, ItemRect>& all() const { return rects_; }
    /// Of the last frame; empty where there was none of that name.
    std::optional<ItemRect> find(const std::string& name) const {
        const auto found = rects_.find(name);
        if (found == rects_.end()) return {};
        return found->second;
    }

  private:
    std::map<std::string, ItemRect> rects_;
};

}  // namespace burl
