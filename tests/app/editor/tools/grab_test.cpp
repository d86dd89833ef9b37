// Taking hold of the texture on scenes with instances and in the object's own coordinates, against
// where the pointer is and what the texture's map says.
#include "app/editor/tools/grab.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace burl {
namespace {

/// Two squares of side 2, the second one an instance aside that is turned about x.
ObjectView two_squares(SolidSpace space) {
    Surface square;
    square.positions = {{9, 9, 5}, {11, 9, 5}, {11, 11, 5}, {9, 11, 5}};
    square.triangles = {{0, 1, 2}, {0, 2, 3}};
    square.uvs.resize(4);
    const Mat4d aside = glm::translate(Mat4d(1.0), Vec3d(13, 10, 5)) *
                        glm::rotate(Mat4d(1.0), 0.4, Vec3d(1, 0, 0)) *
                        glm::translate(Mat4d(1.0), Vec3d(-10, -10, -5));
    square.placements.push_back(aside);
    auto scene = std::make_shared<Scene>();
    scene->surfaces = {square};
    ObjectView view;
    view.pick = std::make_shared<const SurfacePick>(scene);
    view.sphere = bounding_sphere(*scene);
    view.unit_from_mesh = {Mat3d(0.5), -0.5 * Vec3d(10, 10, 5)};
    if (space == SolidSpace::unit) view.solid_from_mesh = view.unit_from_mesh;
    view.camera.view = {10.0, 15.0, 3.5};
    view.low = {100, 20};
    view.size = {640, 480};
    return view;
}

const SolidOptions start{SolidSpace::unit, 2.0, {10, 20, 30}, {1, 2, 3}};

Affine3 grabbed_map(const SolidOptions& solid) {
    Recipe recipe;
    recipe.solid = solid;
    return texture_from_solid(recipe);
}

Vec2d seen(const ObjectView& view, const Vec3d& point) {
    return Vec2d(on_screen(view, point));
}

/// The point of the solid that the pointer is at.
Vec3d solid_at(const ObjectView& view, const Vec2d& pointer) {
    return view.solid_from_mesh(hit_at(view, pointer).value().mesh_point);
}

TEST(SolidGrab, IsOfTheSurfaceAlone) {
    const ObjectView view = two_squares(SolidSpace::unit);
    EXPECT_FALSE(SolidGrab::surface(view, start, SolidDrag::move, view.low + Vec2d(5, 5)));
    EXPECT_TRUE(SolidGrab::surface(view, start, SolidDrag::move, seen(view, {10, 10, 5})));
    EXPECT_FALSE(SolidGrab::surface({}, start, SolidDrag::move, {10, 10}));
}

TEST(SolidGrab, MovesOnInstancesAndBesideThem) {
    const ObjectView view = two_squares(SolidSpace::unit);
    const Mat4d& aside = view.pick->scene().surfaces[0].placements[1];
    const auto on_second = [&](const Vec3d& p) { return Vec3d(aside * Vec4d(p, 1.0)); };
    const Vec2d a = seen(view, on_second({9.6, 10.2, 5})),
                b = seen(view, on_second({10.5, 9.7, 5})), beside = view.low + Vec2d(600, 30);
    ASSERT_FALSE(hit_at(view, beside));
    auto grab = SolidGrab::surface(view, start, SolidDrag::move, a);
    ASSERT_TRUE(grab);
    const Vec3d taken = grabbed_map(start)(solid_at(view, a));
    const Affine3 there = grabbed_map(grab->to(view, b).value());
    EXPECT_LT(glm::distance(there(solid_at(view, b)), taken), 1e-8);
    // Beside both: on the second one's plane, as if it went on there.
    const double depth = on_screen(view, grab->held()).z;
    const Affine3 away = grabbed_map(grab->to(view, beside).value());
    const Vec3d solid = glm::inverse(away.linear) * (taken - away.offset);
    const Vec3d mesh = 2.0 * solid + Vec3d(10, 10, 5);
    EXPECT_LT(glm::distance(seen(view, on_second(mesh)), beside), 1e-6);
    EXPECT_NEAR(on_screen(view, on_second(mesh)).z, depth, 1e-7);
    // Back where it was taken nothing has changed.
    EXPECT_EQ(grab->to(view, a), start);
}

TEST(SolidGrab, TurnsAndSizesAboutTheMiddleOfTheObjectsOwnCoordinates) {
    const ObjectView view = two_squares(SolidSpace::object);
    const Vec3d middle(10, 10, 5);
    EXPECT_LT(glm::distance(middle_of(view), middle), 1e-12);
    // The square is flat: seen from its middle the pointer's ways stay in its plane.
    const Vec3d p(9.3, 10.5, 5), q(10.6, 10.7, 5);
    auto turn = SolidGrab::surface(view, start, SolidDrag::turn, seen(view, p));
    const Affine3 turned = grabbed_map(turn.value().to(view, seen(view, q)).value());
    const Vec3d way = glm::normalize(q - middle) * glm::distance(p, middle);
    EXPECT_LT(glm::distance(turned(middle + way), grabbed_map(start)(p)), 1e-7);
    EXPECT_LT(glm::distance(turned(middle), grabbed_map(start)(middle)), 1e-7);
    // Twice as far from the middle's place on the screen.
    const Vec2d centre = seen(view, middle), from = centre + Vec2d(30, 20);
    auto size = SolidGrab::surface(view, start, SolidDrag::size, from);
    const SolidOptions sized = size.value().to(view, centre + Vec2d(60, 40)).value();
    EXPECT_NEAR(sized.scale, 0.5 * start.scale, 1e-8);
    EXPECT_LT(glm::distance(grabbed_map(sized)(middle), grabbed_map(start)(middle)), 1e-7);
}

}  // namespace
}  // namespace burl
