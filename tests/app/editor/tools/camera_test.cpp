// The editor's camera does what hands expect, measured in the picture.
#include "app/editor/tools/view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace burl {
namespace {

const Sphere ball{{3, 4, 5}, 2.0};
const PictureSize picture{800, 600};

TEST(EditCamera, WithoutMovesItIsTheOrbitCamera) {
    const EditCamera camera;
    const Camera ours = camera_of(camera, ball, picture);
    const Camera theirs = orbit_camera(camera.view, ball, picture);
    EXPECT_EQ(ours.eye, theirs.eye);
    EXPECT_EQ(ours.near_distance, theirs.near_distance);
    EXPECT_EQ(ours.far_distance, theirs.far_distance);
}

TEST(EditCamera, WhatIsPannedFollowsThePointer) {
    EditCamera camera;
    camera.view = {70, -35, 2.0};
    for (const PictureSize& size : {picture, PictureSize{300, 900}}) {
        const Vec3d before = project(camera_of(camera, ball, size), size, ball.centre);
        const EditCamera moved = panned(camera, {120, -45}, std::min(size.width, size.height));
        const Vec3d after = project(camera_of(moved, ball, size), size, ball.centre);
        EXPECT_NEAR(after.x - before.x, 120.0, 1e-6);
        EXPECT_NEAR(after.y - before.y, -45.0, 1e-6);
    }
}

TEST(EditCamera, NarrowPicturesShowAsMuchAsWideOnes) {
    const EditCamera camera;
    const Vec3d top = ball.centre + ball.radius * camera_of(camera, ball, picture).up,
                right = ball.centre + ball.radius * camera_of(camera, ball, picture).right;
    const PictureSize narrow{picture.height, picture.width};
    const double wide = project(camera_of(camera, ball, picture), picture, top).y;
    const Vec3d seen = project(camera_of(camera, ball, narrow), narrow, right);
    EXPECT_NEAR(seen.x, narrow.width - wide, 1e-9);
    EXPECT_NEAR(seen.y, 0.5 * narrow.height, 1e-9);
}

TEST(EditCamera, NothingOfTheSceneIsCutOff) {
    for (const glm::dvec2& pan : {glm::dvec2(0, 0), glm::dvec2(500, -300)})
        for (const double notches : {-10.0, 0.0, 8.0}) {
            const EditCamera camera = panned(zoomed({}, notches), pan, picture.height);
            const Camera c = camera_of(camera, ball, picture);
            const double depth = project(c, picture, ball.centre).z;
            EXPECT_GE(c.far_distance, depth + ball.radius);
            EXPECT_LE(c.near_distance, std::max(depth - ball.radius, 0.01 * ball.radius));
            EXPECT_GT(c.near_distance, 0.0);
        }
}

/// Where the pointer is, wherever that is and however the camera was moved before.
TEST(EditCamera, ZoomKeepsWhatIsUnderThePointer) {
    EditCamera camera;
    camera.view = {70, -35, 2.0};
    camera = panned(camera, {33, -80}, 600);
    for (const UpAxis up : {UpAxis::y, UpAxis::z, UpAxis::minus_z})
        for (const PictureSize& size : {picture, PictureSize{300, 900}})
            for (const double notches : {-4.0, 1.0, 9.0}) {
                camera.up = up;
                const double side = std::min(size.width, size.height);
                const Vec2d offset(90, -140), middle(0.5 * size.width, 0.5 * size.height);
                const Camera before = camera_of(camera, ball, size);
                const double depth = ball.radius * camera.view.distance;
                const Vec3d point = ray_through(before, size, middle + offset).at(depth);
                const EditCamera near = zoomed(camera, notches, offset, side);
                const Vec3d seen = project(camera_of(near, ball, size), size, point);
                EXPECT_NEAR(seen.x, middle.x + offset.x, 1e-6);
                EXPECT_NEAR(seen.y, middle.y + offset.y, 1e-6);
                EXPECT_NEAR(near.view.distance, 2.0 * std::pow(0.9, notches), 1e-12);
            }
    EXPECT_EQ(zoomed(camera, 3).target, camera.target) << "without a pointer to the middle";
}

/// Blender's views of what it makes: +z is up, its front -y towards the viewer, +x on the right.
TEST(EditCamera, TheUpAxisIsUpOnTheScreen) {
    for (const auto& [up, axis, front] : {std::tuple{UpAxis::y, Vec3d(0, 1, 0), Vec3d(0, 0, 1)},
                                          {UpAxis::z, Vec3d(0, 0, 1), Vec3d(0, -1, 0)},
                                          {UpAxis::minus_z, Vec3d(0, 0, -1), Vec3d(0, 1, 0)}}) {
        EditCamera camera = from_front({});
        camera.up = up;
        const Camera seen = camera_of(camera, ball, picture);
        EXPECT_NEAR(glm::distance(seen.up, axis), 0.0, 1e-12);
        EXPECT_NEAR(glm::distance(seen.right, Vec3d(1, 0, 0)), 0.0, 1e-12);
        EXPECT_NEAR(glm::distance(seen.back, front), 0.0, 1e-12);
        EXPECT_NEAR(glm::distance(seen.eye, ball.centre + 3.5 * ball.radius * front), 0.0, 1e-9);
        const EditCamera moved = panned(camera, {50, 0}, 600);
        EXPECT_LT(moved.target.x, 0.0) << "what is on the right comes into view";
        EXPECT_EQ(fitted(moved), camera);
    }
}

TEST(EditCamera, DraggingToTheRightTurnsTheNearSideToTheRight) {
    EditCamera camera;
    camera.view = {0, 0, 3.5};
    const Vec3d near_point = ball.centre + Vec3d(0, 0, ball.radius);
    const EditCamera turned = orbited(camera, {60, 0}, picture.height);
    const double x = project(camera_of(turned, ball, picture), picture, near_point).x;
    EXPECT_GT(x, 405.0);
    EXPECT_EQ(orbited(camera, {0, 1e6}, 600).view.elevation_degrees, 90.0);
    EXPECT_NEAR(orbited(camera, {600, 0}, 600).view.azimuth_degrees, -180.0, 1e-9);
    EXPECT_EQ(fitted(panned(zoomed(camera, 3), {5, 5}, 600)), camera);
}

}  // namespace
}  // namespace burl
