#pragma once
// What a person does to the editor's window, as plain values: a window makes them, a script records
// and replays them, and the user interface is driven by nothing else.
#include <string>
#include <vector>

#include "app/base/json_text.h"
#include "atlas/base/vec.h"

namespace burl {

enum class InputKind {
    move,    ///< the pointer to `at`
    button,  ///< `button` goes `down` or up: 0 left, 1 right, 2 middle
    wheel,   ///< by `at`, in notches
    key,     ///< the key named `text` ("A", "Left", "F1", "Ctrl") goes `down` or up
    text,    ///< `text` was typed, UTF-8
    drop,    ///< `files` were dropped
    resize,  ///< the window is `at` large, in screen coordinates
    close    ///< the window was asked to close
};

struct InputEvent {
    InputKind kind = InputKind::move;
    glm::dvec2 at{0.0};  ///< screen coordinates of the window, y down
    int button = 0;
    bool down = false;
    std::string text{};
    std::vector<std::string> files{};
    bool operator==(const InputEvent&) const = default;
};

/// {"move": [x, y]}, {"button": 0, "down": true}, {"wheel": [x, y]}, {"key": "A", "down": true},
/// {"text": "a"}, {"drop": ["f"]}, {"resize": [w, h]}, {"close": true}.
Json to_json(const InputEvent& event);
/// Throws Error(invalid_file) naming `place` ("file: steps.3") and what is wrong.
InputEvent input_from_json(const Json& json, const std::string& place);

/// The value of `key` at `place` of an input file as text or as two numbers. Throws
/// Error(invalid_file) if it is something else.
std::string input_text(const Json& json, const std::string& place, const std::string& key);
glm::dvec2 input_pair(const Json& json, const std::string& place, const std::string& key);
/// Throws Error(invalid_file): `key` at `place` must be `wanted`.
[[noreturn]] void refuse_input(const std::string& place, const std::string& key,
                               const char* wanted);

}  // namespace burl
