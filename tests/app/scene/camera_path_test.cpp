// Cameras that move, view by view.
#include "app/scene/camera_path.h"

#include <gtest/gtest.h>

#include "atlas/base/error.h"

namespace burl {
namespace {

std::vector<View> views_of(AnimationOptions animation, int turntable = 0, const View& start = {}) {
    return views(take_camera_moves(animation, turntable, start), start);
}

TEST(CameraPath, WithoutFramesIsTheView) {
    const View start{1.0, 2.0, 3.0};
    EXPECT_EQ(views_of({}, 0, start), std::vector<View>{start});
}

TEST(CameraPath, TurntableGoesRoundOnceAndStopsBeforeItsBeginning) {
    const std::vector<View> turn = views_of({}, 8, {30.0, 20.0, 3.5});
    ASSERT_EQ(turn.size(), 8u);
    for (int k = 0; k < 8; ++k)
        EXPECT_EQ(turn[std::size_t(k)], (View{30.0 + 45.0 * k, 20.0, 3.5})) << k;
}

TEST(CameraPath, TurntableIsALoopOfTheRecipesToo) {
    AnimationOptions animation{{"solid.scale=1:2"}};
    const CameraMoves camera = take_camera_moves(animation, 6, {});
    EXPECT_EQ(animation.frames, 6);
    EXPECT_TRUE(animation.loop);
    EXPECT_TRUE(animation.recipes_may_rest);
    EXPECT_EQ(animation.keys, std::vector<std::string>{"solid.scale=1:2"});
    EXPECT_EQ(camera.moves.size(), 1u);
}

TEST(CameraPath, MovesGoFromOneEndToTheOther) {
    const std::vector<View> path =
        views_of({{"camera.elevation=-10:50", "solid.scale=1:2", "camera.distance=4:2"}, 5, false});
    ASSERT_EQ(path.size(), 5u);
    for (int k = 0; k < 5; ++k)
        EXPECT_EQ(path[std::size_t(k)], (View{30.0, -10.0 + 15.0 * k, 4.0 - 0.5 * k})) << k;
    EXPECT_EQ(views_of({{"camera.azimuth=0:360"}, 4, true})[3].azimuth_degrees, 270.0);
    EXPECT_EQ(views_of({{"camera.azimuth=0:360"}, 4, false})[3].azimuth_degrees, 360.0);
}

TEST(CameraPath, WithoutMovesLeavesRecipesToMove) {
    AnimationOptions animation{{"solid.scale=1:2"}, 3};
    take_camera_moves(animation, 0, {});
    EXPECT_FALSE(animation.recipes_may_rest);
}

TEST(CameraPath, RefusesWhatNoCameraDoes) {
    for (const char* bad :
         {"camera.roll=0:1", "camera.=0:1", "camera.elevation=0:91", "camera.elevation=-90.5:0",
          "camera.distance=0:1", "camera.distance=1:-1", "camera.azimuth=0", "camera.azimuth=x:1"})
        EXPECT_THROW(views_of({{bad}, 3}), Error) << bad;
    EXPECT_THROW(views_of({{"camera.azimuth=0:1"}}, 3), Error);
    EXPECT_THROW(views_of({{"camera.azimuth=0:1", "camera.azimuth=0:2"}, 3}), Error);
    EXPECT_NO_THROW(views_of({{"camera.elevation=0:1"}}, 3));
}

}  // namespace
}  // namespace burl
