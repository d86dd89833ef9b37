#include "app/editor/session/event_frames.h"

#include <algorithm>

namespace burl {

namespace {

bool is_modifier(const std::string& key) {
    return key == "Ctrl" || key == "Shift" || key == "Alt";
}

/// Whether `next` may be in the same frame as `first`, an earlier event.
bool go_together(const InputEvent& first, const InputEvent& next) {
    switch (next.kind) {
        case InputKind::move:
        case InputKind::wheel:
            return first.kind != InputKind::button;
        case InputKind::button:
            return first.kind != InputKind::button && first.kind != InputKind::move;
        case InputKind::key:
            return first.kind != InputKind::button &&
                   !(first.kind == InputKind::key &&
                     (first.text == next.text ||
                      (is_modifier(next.text) && first.down && !is_modifier(first.text))));
        case InputKind::text:
        case InputKind::drop:
        case InputKind::resize:
        case InputKind::close:
            break;
    }
    return true;
}

}  // namespace

std::vector<std::vector<InputEvent>> in_frames(const std::vector<InputEvent>& events) {
    std::vector<std::vector<InputEvent>> frames(1);
    for (const InputEvent& event : events) {
        const auto fits = [&](const InputEvent& first) { return go_together(first, event); };
        if (!std::ranges::all_of(frames.back(), fits)) frames.emplace_back();
        frames.back().push_back(event);
    }
    return frames;
}

}  // namespace burl
