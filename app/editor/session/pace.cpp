#include "app/editor/session/pace.h"

#include <algorithm>

namespace burl {

namespace {

constexpr int rests = 4;  // pause after a frame in units of the frame's time
constexpr EditPace::Clock::duration longest_rest = std::chrono::milliseconds(125);

}  // namespace

EditPace::Clock::duration EditPace::rest_after(Clock::duration took) {
    return std::min(rests * took, longest_rest);
}

double EditPace::seconds_left() const {
    return std::max(0.0, std::chrono::duration<double>(due_ - Clock::now()).count());
}

bool passes_by(std::span<const InputEvent> events) {
    return std::ranges::all_of(
        events, [](const InputEvent& event) { return event.kind == InputKind::move; });
}

}  // namespace burl
