// How often frames are drawn while a mesh is opened.
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

}  // namespace
}  // namespace burl
