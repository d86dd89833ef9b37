#pragma once
// A registry of widgets by name and rectangle on the screen, so that scripts name the widgets they
// act on and tests need no coordinates.
#include <imgui.h>

#include <map>
#include <optional>
#include <string>

#include "app/editor/session/script.h"

namespace burl {

/// The rectangles of one frame's widgets.
class EditItems {
  public:
    /// Begins a frame.
    void clear() { rects_.clear(); }
    /// Notes ImGui's last item as `name`, unless it is scrolled out of sight.
    void note(const std::string& name) {
        if (!ImGui::IsItemVisible()) return;
        const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
        note(name, {{low.x, low.y}, {high.x, high.y}});
    }
    void note(const std::string& name, const ItemRect& rect) { rects_[name] = rect; }
    /// All rectangles of the last frame, by name.
    const std::map<std::string, ItemRect>& all() const { return rects_; }
    /// The rectangle of a name in the last frame; empty: none.
    std::optional<ItemRect> find(const std::string& name) const {
        const auto found = rects_.find(name);
        if (found == rects_.end()) return {};
        return found->second;
    }

  private:
    std::map<std::string, ItemRect> rects_;
};

}  // namespace burl
