// Events as frames: none is lost, their order stays, and what must be seen apart is.
#include "app/edit_event_frames.h"

#include <gtest/gtest.h>

namespace burl {
namespace {

InputEvent move(double x) {
    return {InputKind::move, {x, 0.0}};
}
InputEvent button(bool down) {
    InputEvent event{InputKind::button};
    event.down = down;
    return event;
}
InputEvent key(const char* name, bool down) {
    InputEvent event{InputKind::key};
    event.text = name;
    event.down = down;
    return event;
}

using Frames = std::vector<std::vector<InputEvent>>;

TEST(EventFrames, AQuickClickIsSeenDownAndUp) {
    EXPECT_EQ(in_frames({move(1), button(true), button(false)}),
              (Frames{{move(1)}, {button(true)}, {button(false)}}));
}

TEST(EventFrames, AQuickDragIsSeenAtItsEnd) {
    EXPECT_EQ(
        in_frames({move(1), move(2), button(true), move(3), move(4), button(false), move(9)}),
        (Frames{
            {move(1), move(2)}, {button(true)}, {move(3), move(4)}, {button(false)}, {move(9)}}));
}

TEST(EventFrames, AShortcutIsPressedBeforeItIsLetGo) {
    EXPECT_EQ(in_frames({key("Ctrl", true), key("Z", true), key("Z", false), key("Ctrl", false)}),
              (Frames{{key("Ctrl", true), key("Z", true)}, {key("Z", false), key("Ctrl", false)}}));
    EXPECT_EQ(in_frames({key("Ctrl", true), button(true), key("Ctrl", false)}),
              (Frames{{key("Ctrl", true), button(true)}, {key("Ctrl", false)}}));
}

TEST(EventFrames, MovesAloneAreOneFrameAndNothingIsOneWithoutEvents) {
    EXPECT_EQ(in_frames({move(1), move(2), move(3)}).size(), 1u);
    EXPECT_EQ(in_frames({}), Frames(1));
}

}  // namespace
}  // namespace burl
