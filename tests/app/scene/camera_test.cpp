#include "app/scene/camera.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "atlas/base/error.h"
#include "tests/app/support/sample_scene.h"

namespace burl {
namespace {

const double tan_half_field = 0.31529878887898360;  // tan(17.5 degrees)

void expect_near(const Vec3d& a, const Vec3d& b, double tolerance = 1e-12) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], tolerance) << "component " << k;
}

TEST(Camera, AzimuthZeroLooksFromPlusZ) {
    const Camera camera = orbit_camera({0, 0, 4}, {{1, 2, 3}, 0.5}, {200, 100});
    expect_near(camera.eye, {1, 2, 5});
    expect_near(camera.right, {1, 0, 0});
    expect_near(camera.up, {0, 1, 0});
}

TEST(Camera, AzimuthNinetyLooksFromPlusX) {
    const Camera camera = orbit_camera({90, 0, 2}, {{0, 0, 0}, 1}, {100, 100});
    expect_near(camera.eye, {2, 0, 0});
    expect_near(camera.right, {0, 0, -1});
}

TEST(Camera, StraightDownHasNoSingularity) {
    const Camera camera = orbit_camera({0, 90, 2}, {{0, 0, 0}, 1}, {100, 100});
    expect_near(camera.eye, {0, 2, 0});
    expect_near(camera.right, {1, 0, 0});
    expect_near(camera.up, {0, 0, -1});
}

TEST(Camera, ThirtyTwentyByHand) {
    // back = (sin 30 cos 20, sin 20, cos 30 cos 20)
    const Camera camera = orbit_camera({30, 20, 10}, {{0, 0, 0}, 1}, {100, 100});
    expect_near(camera.eye, {4.6984631039295421, 3.4202014332566873, 8.1379768134937369}, 1e-12);
}

TEST(Camera, FieldOfViewIsVertical) {
    const PictureSize size{200, 100};
    const Camera camera = orbit_camera({0, 0, 2}, {{0, 0, 0}, 1}, size);
    expect_near(project(camera, size, {0, 0, 0}), {100, 50, 2});
    expect_near(project(camera, size, {0, 2 * tan_half_field, 0}), {100, 0, 2});
    expect_near(project(camera, size, {0, -2 * tan_half_field, 0}), {100, 100, 2});
    // Twice as wide as high: the right border is at twice the tangent.
    expect_near(project(camera, size, {4 * tan_half_field, 0, 0}), {200, 50, 2});
    // Half the depth doubles the offset from the middle.
    expect_near(project(camera, size, {0.1, 0, 1}),
                {100 + 2 * (project(camera, size, {0.1, 0, 0}).x - 100), 50, 1});
}

TEST(Camera, MatricesAgreeWithProject) {
    const PictureSize size{320, 200};
    const Camera camera = orbit_camera({-77, 41, 3}, {{5, -6, 7}, 2.5}, size);
    for (const Vec3d p : {Vec3d(5, -6, 7), Vec3d(6, -5, 8), Vec3d(4.5, -7, 5.5)}) {
        const Vec4d clip = camera.clip_from_eye() * camera.eye_from_scene() * Vec4d(p, 1.0);
        const Vec3d pixel = project(camera, size, p);
        EXPECT_NEAR(clip.w, pixel.z, 1e-12);
        EXPECT_NEAR(0.5 * size.width * (1 + clip.x / clip.w), pixel.x, 1e-9);
        EXPECT_NEAR(0.5 * size.height * (1 - clip.y / clip.w), pixel.y, 1e-9);
        EXPECT_LT(std::abs(clip.z), clip.w);
    }
}

TEST(Camera, DepthRangeHoldsTheSphere) {
    for (const double distance : {0.5, 1.0, 1.5, 3.5, 100.0}) {
        const Camera camera = orbit_camera({10, 10, distance}, {{0, 0, 0}, 3}, {10, 10});
        EXPECT_GT(camera.near_distance, 0.0);
        EXPECT_GT(camera.far_distance, 3 * (distance + 1));
        EXPECT_LE(camera.near_distance, std::max(3 * (distance - 1), 0.03));
    }
}

TEST(Camera, PointMeshStillHasACamera) {
    const Camera camera = orbit_camera({}, {{7, 7, 7}, 0.0}, {10, 10});
    EXPECT_NEAR(glm::distance(camera.eye, Vec3d(7)), 3.5, 1e-12);
}

TEST(BoundingSphere, IsAroundTheBoxOfAllPlacements) {
    Mesh mesh = cube_mesh({1, 1, 1});
    Sphere sphere = bounding_sphere(mesh);
    expect_near(sphere.centre, {1, 1, 1});
    EXPECT_NEAR(sphere.radius, std::sqrt(3.0), 1e-12);

    Mat4d moved(1.0);
    moved[3] = {10, 0, 0, 1};
    mesh.parts[0].instances.push_back(moved);
    sphere = bounding_sphere(mesh);
    expect_near(sphere.centre, {6, 1, 1});
    EXPECT_NEAR(sphere.radius, std::sqrt(36.0 + 1.0 + 1.0), 1e-12);
    EXPECT_EQ(bounding_sphere(Mesh{}).radius, 0.0);
}

TEST(ParseView, ReadsThreeNumbers) {
    EXPECT_EQ(parse_view("30,20,3.5"), (View{30, 20, 3.5}));
    EXPECT_EQ(parse_view("-400.5,-90,1e-2"), (View{-400.5, -90, 0.01}));
}

TEST(ParseView, RefusesTheRest) {
    for (const char* text : {"", "30", "30,20", "30,20,", "30,20,3,4", "30, 20,3", "a,b,c",
                             "30,91,3", "30,20,0", "30,20,-1", "nan,0,1", "0,inf,1", "0,0,inf"}) {
        try {
            parse_view(text);
            ADD_FAILURE() << text;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::usage) << text;
            EXPECT_THAT(error.what(), testing::HasSubstr(text));
        }
    }
}

TEST(ParsePictureSize, ReadsAndRefuses) {
    EXPECT_EQ(parse_picture_size("640x480"), (PictureSize{640, 480}));
    EXPECT_EQ(parse_picture_size("1x16384"), (PictureSize{1, 16384}));
    for (const char* text : {"", "640", "640x", "x480", "0x480", "640x0", "-1x5", "640x480x2",
                             "640*480", "16385x1", "99999999999x1", "1.5x2"}) {
        EXPECT_THROW(parse_picture_size(text), Error) << text;
    }
}

}  // namespace
}  // namespace burl
