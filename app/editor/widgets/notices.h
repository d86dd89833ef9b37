#pragma once
// Notices in the lower left corner of the object's view: background work under way, questions that
// can wait, and news.
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/editor/widgets/items.h"

namespace burl {

/// A line of text with buttons for its answers.
struct Notice {
    std::string text{};
    std::vector<std::string> answers{};
    bool problem = false;
    double share = -1.0;  ///< of work that is done, 0 to 1; below 0: none is told
};

/// Draws a sign in the lower right corner of the object's view while a coarser level of the texture
/// is shown than level 0, "coarse level" among the items.
void coarse_sign(EditItems& items, const ImVec2& low, const ImVec2& size, std::uint32_t level);

/// Draws notices, and keeps the newest message for some seconds.
class EditNotices {
  public:
    /// `seconds` returns the time on a steady clock.
    explicit EditNotices(std::function<double()> seconds) : seconds_(std::move(seconds)) {}

    /// Shows a message for 12 seconds, or until it is dismissed.
    void tell(std::string text, bool problem = false);
    /// Draws `notices` and the message below them, their lower edge at y = `bottom`, the end of the
    /// object's view; nothing where there are none. Returns the answer clicked in this frame;
    /// empty: none.
    std::string show(EditItems& items, std::vector<Notice> notices, float bottom);
    /// Whether the message that show() has drawn has had its time.
    bool outdated() const { return shown_ && seconds_() >= until_; }

  private:
    std::function<double()> seconds_;
    Notice news_;
    bool shown_ = false;  ///< whether `news_` was drawn last
    double until_ = 0.0;  ///< time on the clock until which `news_` is shown
};

}  // namespace burl
