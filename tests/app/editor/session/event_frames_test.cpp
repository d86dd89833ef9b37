// Events as frames: none is lost, their order stays, and what must be seen apart is.
#include "app/editor/session/input.h"

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

/// Quick hands let Ctrl go first, or a slow frame takes all of it.
TEST(EventFrames, AModifierIsHeldWhileItsKeyIsPressed) {
    EXPECT_EQ(in_frames({key("Ctrl", true), key("O", true), key("Ctrl", false), key("O", false)}),
              (Frames{{key("Ctrl", true), key("O", true)}, {key("Ctrl", false), key("O", false)}}));
    EXPECT_EQ(in_frames({key("A", true), key("Shift", true), key("B", true)}),
              (Frames{{key("A", true)}, {key("Shift", true), key("B", true)}}));
    EXPECT_EQ(in_frames({key("Ctrl", true), key("Shift", true), key("Z", true)}).size(), 1u);
}

TEST(EventFrames, MovesAloneAreOneFrameAndNothingIsOneWithoutEvents) {
    EXPECT_EQ(in_frames({move(1), move(2), move(3)}).size(), 1u);
    EXPECT_EQ(in_frames({}), Frames(1));
}

}  // namespace
}  // namespace burl
