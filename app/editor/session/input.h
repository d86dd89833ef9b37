#pragma once
// Input events of the editor's window as plain values: a window makes them, a script records and
// replays them, and nothing else drives the user interface.
#include <string>
#include <vector>

#include "app/base/json_text.h"
#include "atlas/base/vec.h"

namespace burl {

enum class InputKind {
    move,    ///< the pointer moves to `at`
    button,  ///< `button` goes `down` or up: 0 left, 1 right, 2 middle
    wheel,   ///< the wheel turns by `at`, in notches
    key,     ///< the key named `text` ("A", "Left", "F1", "Ctrl") goes `down` or up
    text,    ///< `text` was typed, UTF-8
    drop,    ///< `files` were dropped
    resize,  ///< the window's size becomes `at`, in screen coordinates
    close    ///< the window was asked to close
};

/// An input event; `kind` says which members count.
struct InputEvent {
    InputKind kind = InputKind::move;
    glm::dvec2 at{0.0};  ///< screen coordinates relative to the window, y down
    int button = 0;
    bool down = false;
    std::string text{};
    std::vector<std::string> files{};
    bool operator==(const InputEvent&) const = default;
};

/// Returns {"move": [x, y]}, {"button": 0, "down": true}, {"wheel": [x, y]}, {"key": "A", "down":
/// true}, {"text": "a"}, {"drop": ["f"]}, {"resize": [w, h]} or {"close": true}.
Json to_json(const InputEvent& event);
/// Parses an event. Throws Error(invalid_file) that names `place` ("file: steps.3") and the fault.
InputEvent input_from_json(const Json& json, const std::string& place);

/// Returns a JSON value as text or as two numbers; `place` and `key` name it in messages. Throws
/// Error(invalid_file) where it has another type.
std::string input_text(const Json& json, const std::string& place, const std::string& key);
glm::dvec2 input_pair(const Json& json, const std::string& place, const std::string& key);
/// Throws Error(invalid_file): `key` at `place` must be `wanted`.
[[noreturn]] void refuse_input(const std::string& place, const std::string& key,
                               const char* wanted);

/// Splits the events that arrived while one frame was drawn into at least one frame that processes
/// them one after another: a click whose press and release arrive during one slow frame would
/// otherwise be lost. No frame has two changes of one key or of buttons, a pointer's move and a
/// change of a button, a wheel or key event after a change of a button, or a modifier's change
/// after another key's press. (Dear ImGui does so itself from 1.87 on, by
/// io.ConfigInputTrickleEventQueue; Debian 12 packages 1.86.)
std::vector<std::vector<InputEvent>> in_frames(const std::vector<InputEvent>& events);

}  // namespace burl
