#pragma once
// Scripts for the editor: steps that name what they act on ("drag this slider by 40 pixels") or
// repeat recorded events, played a frame at a time on a clock of their own, so that a run repeats
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

struct ScriptStep {
    enum class Kind {
        events,        ///< one frame with these events
        click,         ///< on `item`; with `text` "right" or "middle" by that button
        double_click,  ///< on `item`
        drag,          ///< from `item` by `by` pixels in `frames` frames
        wheel,         ///< over `item` by `by` notches
        key,           ///< `text`, such as "Ctrl+Z", down and up
        type,          ///< `text`, then nothing
        drop,          ///< `files`
        resize,        ///< the window, to `by`
        wait,          ///< `frames` frames without events
        settle,        ///< frames until no work is under way
        screenshot     ///< to NAME.png, `text` being the name
    };
    Kind kind = Kind::wait;
    std::string item{}, text{};
    glm::dvec2 by{0.0};
    int frames = 1;
    std::vector<InputEvent> events{};
    std::vector<std::string> files{};
    bool operator==(const ScriptStep&) const = default;
};

struct InputScript {
    glm::ivec2 size{1280, 800};  ///< of the window
    std::vector<ScriptStep> steps{};
    bool operator==(const InputScript&) const = default;
};

/// {"burl_input": 1, "size": [w, h], "steps": [{"click": "undo"}, {"drag": "x", "by": [40, 0]}]}.
std::string script_text(const InputScript& script);
/// Throws Error(invalid_file) naming `origin`, the step and what is wrong.
InputScript parse_script(const std::string& text, const std::string& origin);

/// Plays a script: what happens before each frame.
class ScriptPlayer {
  public:
    /// Where an item is on screen now; empty: not to be seen.
    using FindItem = std::function<std::optional<ItemRect>(const std::string& item)>;

    explicit ScriptPlayer(InputScript script);

    struct Frame {
        std::vector<InputEvent> events{};
        std::string screenshot{};  ///< the picture of this frame is wanted under this name
        bool settle = false;       ///< call again only once no work is under way
    };
    bool done() const { return next_ >= script_.steps.size() && pending_.empty(); }
    /// The next frame. Throws Error(invalid_file) when a step's item is not on screen.
    Frame next(const FindItem& find);

  private:
    std::vector<Frame> frames_of(const ScriptStep& step, const FindItem& find) const;
    glm::dvec2 middle_of(const std::string& item, const FindItem& find) const;

    InputScript script_;
    std::size_t next_ = 0;
    std::vector<Frame> pending_;  ///< of the current step, last first
};

}  // namespace burl
