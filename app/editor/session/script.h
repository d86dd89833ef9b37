#pragma once
// Scripts of input for the editor: steps that name the widget they act on ("drag this slider by 40
// pixels") or replay recorded events, one frame at a time on a simulated clock, so that runs repeat
// to the last pixel.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/session/input.h"

namespace burl {

/// A rectangle on screen, y down.
struct ItemRect {
    glm::dvec2 low{0.0}, high{0.0};
    glm::dvec2 middle() const { return 0.5 * (low + high); }
};

/// A step of a script; `kind` says which members count.
struct ScriptStep {
    enum class Kind {
        events,        ///< plays one frame with `events`
        click,         ///< clicks `item`; `text` "right" or "middle" names another button
        double_click,  ///< double-clicks `item`
        drag,       ///< drags `item` by `by` pixels, or onto the item `to`, within `frames` frames
        wheel,      ///< turns the wheel over `item` by `by` notches
        key,        ///< presses and releases the keys of `text`, such as "Ctrl+Z"
        type,       ///< types `text`, then waits a frame
        drop,       ///< drops `files` on the window
        resize,     ///< resizes the window to `by`
        wait,       ///< plays `frames` frames without events
        settle,     ///< plays frames until no background work is left
        screenshot  ///< writes the frame as NAME.png, NAME being `text`
    };
    Kind kind = Kind::wait;
    std::string item{}, to{}, text{};
    glm::dvec2 by{0.0};
    int frames = 1;
    std::vector<InputEvent> events{};
    std::vector<std::string> files{};
    bool operator==(const ScriptStep&) const = default;
};

struct InputScript {
    glm::ivec2 size{1280, 800};  ///< window size in screen coordinates, 64 to 8192
    std::vector<ScriptStep> steps{};
    bool operator==(const InputScript&) const = default;
};

/// Appends one frame's events to a recording as a step; frames without any become one "settle".
void append_frame(InputScript& script, const std::vector<InputEvent>& events);

/// Returns {"burl_input": 1, "size": [w, h], "steps": [{"click": "undo"}, ...]} as text.
std::string script_text(const InputScript& script);
/// Parses a script. Throws Error(invalid_file) that names `origin`, the step and the fault.
InputScript parse_script(const std::string& text, const std::string& origin);

/// Plays a script frame by frame.
class ScriptPlayer {
  public:
    /// Returns a widget's rectangle on screen in the present frame; empty: the widget is not
    /// visible.
    using FindItem = std::function<std::optional<ItemRect>(const std::string& item)>;

    explicit ScriptPlayer(InputScript script);

    /// The input of one frame.
    struct Frame {
        std::vector<InputEvent> events{};
        std::string screenshot{};  ///< file name for a picture of this frame; empty: none
        bool settle = false;       ///< whether next() must wait until no background work is left
    };
    bool done() const { return next_ >= script_.steps.size() && pending_.empty(); }
    /// Returns the input of the next frame. Throws Error(invalid_file) when a step's widget is not
    /// visible.
    Frame next(const FindItem& find);

  private:
    std::vector<Frame> frames_of(const ScriptStep& step, const FindItem& find) const;
    std::vector<Frame> frames_of_drag(const ScriptStep& step, const FindItem& find) const;
    glm::dvec2 middle_of(const std::string& item, const FindItem& find) const;

    InputScript script_;
    std::size_t next_ = 0;
    std::vector<Frame> pending_;  ///< frames of the current step still to come, last first
};

}  // namespace burl
