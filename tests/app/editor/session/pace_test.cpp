// How often frames are drawn while a mesh is opened, and while nothing happens.
#include "app/editor/session/pace.h"

#include <gtest/gtest.h>

namespace burl {
namespace {

using std::chrono::milliseconds;

TEST(EditPace, DrawingHasAFifthOfTheTimeAndIsNeverLate) {
    EXPECT_EQ(EditPace::rest_after(milliseconds(3)), milliseconds(12));
    EXPECT_EQ(EditPace::rest_after(milliseconds(20)), milliseconds(80));
    EXPECT_EQ(EditPace::rest_after(milliseconds(900)), milliseconds(125));
    EditPace pace;
    EXPECT_EQ(pace.seconds_left(), 0.0);
    pace.drew(milliseconds(900));
    EXPECT_GT(pace.seconds_left(), 0.0);
    EXPECT_LE(pace.seconds_left(), 0.125);
}

TEST(EditPace, OnlyAPointerPassesBy) {
    std::vector<InputEvent> events;
    EXPECT_TRUE(passes_by(events));
    events.push_back({InputKind::move, {1, 2}});
    EXPECT_TRUE(passes_by(events));
    events.push_back({InputKind::button});
    events.push_back({InputKind::move, {1, 3}});
    EXPECT_FALSE(passes_by(events));
}

/// Turns that draw until one does not, with waits of `waited` seconds.
int frames_until_rest(EditRest& rest, double waited) {
    for (int frames = 0; frames < 100; ++frames)
        if (!rest.ended(false, false, waited)) return frames;
    return 100;
}

TEST(EditRest, InputHasItsFramesAtOnceAndWithinASecondAndThenNone) {
    EditRest rest;
    frames_until_rest(rest, 1.0);
    EXPECT_EQ(rest.patience(), 1.0);
    EXPECT_TRUE(rest.ended(true, false, 0.0));
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(rest.patience(), 0.0) << i;
        EXPECT_TRUE(rest.ended(false, false, 0.0)) << i;
    }
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(rest.patience(), EditRest::late_seconds) << i;
        EXPECT_FALSE(rest.ended(false, false, 0.1)) << "a wait that ended early for nothing";
        EXPECT_TRUE(rest.ended(false, false, EditRest::late_seconds)) << i;
    }
    for (int i = 0; i < 5; ++i) {
        EXPECT_EQ(rest.patience(), 1.0) << i;
        EXPECT_FALSE(rest.ended(false, false, 1.0)) << i;
    }
}

TEST(EditRest, NewsHaveTwoFramesAndWhoAsksHasMore) {
    EditRest rest;
    frames_until_rest(rest, 1.0);
    EXPECT_TRUE(rest.ended(false, true, 0.3));
    EXPECT_EQ(frames_until_rest(rest, 0.0), 1);
    rest.ask(2);
    EXPECT_EQ(rest.patience(), 0.0);
    EXPECT_EQ(frames_until_rest(rest, 0.0), 2);
}

}  // namespace
}  // namespace burl
