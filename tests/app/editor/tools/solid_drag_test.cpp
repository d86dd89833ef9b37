// A texture dragged on its object: against its own map, by which what was at one point must be at
// another, and rotations against GLM's.
#include "app/editor/tools/solid_drag.h"
#include "app/recipe/edit/recipe_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <random>

#include "app/base/rotation_angles.h"
#include "procedural/numbers/rotation.h"
#include "tests/app/support/solid_map.h"

namespace burl {
namespace {

double difference(const Mat3d& a, const Mat3d& b) {
    double most = 0.0;
    for (int column = 0; column < 3; ++column)
        most = std::max(most, glm::length(a[column] - b[column]));
    return most;
}

class SolidDragRandom {
  public:
    double number(double low, double high) {
        return std::uniform_real_distribution(low, high)(engine_);
    }
    Vec3d vector(double low, double high) {
        const double x = number(low, high), y = number(low, high);
        return {x, y, number(low, high)};
    }
    Mat3d rotation() {
        const Vec3d v = vector(-1, 1);
        return glm::mat3_cast(glm::normalize(glm::dquat(number(-1, 1), v.x, v.y, v.z)));
    }
    SolidOptions solid() {
        return {SolidSpace::unit, std::exp(number(-3, 3)), vector(-360, 360), vector(-9, 9)};
    }

  private:
    std::mt19937 engine_{7};
};

TEST(RotationAngles, GiveTheRotationBack) {
    SolidDragRandom random;
    for (int i = 0; i < 1000; ++i) {
        const Mat3d rotation = random.rotation();
        const Vec3d angles = angles_of(rotation, random.vector(-360, 360));
        EXPECT_LT(difference(rotation_about_axes(angles), rotation), 1e-14);
        for (int axis = 0; axis < 3; ++axis) EXPECT_LE(std::abs(angles[axis]), 360.0);
    }
}

TEST(RotationAngles, AreTheOnesThatWereThere) {
    SolidDragRandom random;
    for (int i = 0; i < 1000; ++i) {
        const Vec3d angles = random.vector(-360, 360);
        EXPECT_LT(glm::distance(angles_of(rotation_about_axes(angles), angles), angles), 1e-9);
    }
    for (const double y : {90.0, -90.0, 270.0, -270.0}) {
        const Vec3d pole(33, y, -140);
        EXPECT_LT(glm::distance(angles_of(rotation_about_axes(pole), pole), pole), 1e-9);
    }
}

TEST(RotationAngles, NearThePolesAreAsExactAsElsewhere) {
    for (const double off : {0.0, 1e-14, 1e-11, 1e-9, 1e-6, 1e-3})
        for (const double y : {90.0 + off, -90.0 - off, 90.0 - off}) {
            const Mat3d rotation = rotation_about_axes({12, y, 77});
            EXPECT_LT(difference(rotation_about_axes(angles_of(rotation)), rotation), 2e-14) << y;
        }
}

TEST(TurnBetween, TakesOneDirectionToTheOtherAboutTheLineAcrossBoth) {
    SolidDragRandom random;
    for (int i = 0; i < 1000; ++i) {
        const Vec3d from = random.vector(-2, 2), to = random.vector(-2, 2);
        const Mat3d turn = turn_between(from, to);
        const Vec3d axis = glm::cross(from, to);
        EXPECT_LT(glm::distance(glm::normalize(turn * from), glm::normalize(to)), 1e-14);
        EXPECT_LT(glm::distance(turn * axis, axis), 1e-13);
        EXPECT_NEAR(glm::determinant(turn), 1.0, 1e-14);
    }
}

TEST(TurnBetween, StandsTheSameTheOppositeAndNothing) {
    const Vec3d d(1, -2, 0.5);
    EXPECT_LT(difference(turn_between(d, 3.0 * d), Mat3d(1.0)), 1e-15);
    EXPECT_EQ(turn_between(Vec3d(0.0), d), Mat3d(1.0));
    for (const Vec3d& nudge : {Vec3d(0.0), Vec3d(1e-12, 0, 0), Vec3d(1e-7, 2e-7, 0)}) {
        const Mat3d turn = turn_between(d, -d + nudge);
        EXPECT_LT(difference(turn * glm::transpose(turn), Mat3d(1.0)), 1e-14);
        EXPECT_LT(glm::distance(turn * d, -d), 1e-6);
    }
}

TEST(TurnAbout, IsGlms) {
    SolidDragRandom random;
    for (int i = 0; i < 100; ++i) {
        const Vec3d axis = random.vector(-2, 2);
        const double angle = random.number(-7, 7);
        const Mat3d expected = glm::mat3_cast(glm::angleAxis(angle, glm::normalize(axis)));
        EXPECT_LT(difference(turn_about(axis, angle), expected), 1e-14);
    }
}

TEST(SolidDrag, MovesTurnsAndSizesWhatWasThere) {
    SolidDragRandom random;
    for (int i = 0; i < 300; ++i) {
        const SolidOptions start = random.solid();
        const Affine3 before = map_of(start);
        const Vec3d pivot = random.vector(-1, 1), d = random.vector(-1, 1);
        const double close = 1e-8 * start.scale + 1e-8;
        const Vec3d offset = random.vector(-1, 1);
        EXPECT_LT(glm::distance(map_of(moved(start, offset))(d + offset), before(d)), close);
        const Mat3d turn = random.rotation();
        const Affine3 after = map_of(turned(start, pivot, turn));
        EXPECT_LT(glm::distance(after(pivot + turn * d), before(pivot + d)), close);
        EXPECT_LT(glm::distance(after(pivot), before(pivot)), close);
        const double factor = std::exp(random.number(-1, 1));
        const Affine3 larger = map_of(enlarged(start, pivot, factor));
        EXPECT_LT(glm::distance(larger(pivot + factor * d), before(pivot + d)), close);
    }
}

TEST(SolidDrag, APointTakenIsWhereThePointerHasIt) {
    SolidDragRandom random;
    for (int i = 0; i < 300; ++i) {
        const SolidOptions start = random.solid();
        const Affine3 before = map_of(start);
        const DragPivot pivot{random.vector(-1, 1), 0.01};
        const Vec3d from = random.vector(-1, 1), to = random.vector(-1, 1);
        const auto after = [&](SolidDrag drag) {
            return map_of(dragged(start, drag, pivot, from, to));
        };
        const double close = 1e-8 * start.scale + 1e-8;
        EXPECT_LT(glm::distance(after(SolidDrag::move)(to), before(from)), close);
        // As far from the pivot as it was, in the direction of the pointer.
        const double r = glm::distance(from, pivot.point);
        const Vec3d way = glm::normalize(to - pivot.point);
        EXPECT_LT(glm::distance(after(SolidDrag::turn)(pivot.point + r * way), before(from)),
                  close);
        const double factor = glm::distance(to, pivot.point) / r;
        const Vec3d grown = pivot.point + factor * (from - pivot.point);
        EXPECT_LT(glm::distance(after(SolidDrag::size)(grown), before(from)), close);
    }
}

TEST(SolidDrag, NoWayIsNoChange) {
    const SolidOptions start = SolidDragRandom().solid();
    for (const SolidDrag drag : {SolidDrag::move, SolidDrag::turn, SolidDrag::size})
        EXPECT_EQ(dragged(start, drag, {}, {0.1, 0.2, 0.3}, {0.1, 0.2, 0.3}), start);
}

TEST(SolidDrag, ATurnOfAnUntouchedSolidIsItsAngles) {
    const Mat3d quarter = turn_between({0, 0, 1}, {1, 0, 0});
    const SolidOptions turned_once = turned({}, Vec3d(0.0), quarter);
    // The texture has turned by a quarter about y: its map undoes that.
    EXPECT_EQ(turned_once.rotate, Vec3d(0, -90, 0));
    EXPECT_EQ(turned_once.translate, Vec3d(0.0));
    EXPECT_EQ(turned_once.scale, 1.0);
}

TEST(SolidDrag, AtThePivotNothingBreaks) {
    const DragPivot pivot{{0.5, 0, 0}, 0.1, {0, 0, 1}};
    const SolidOptions start{SolidSpace::unit, 2.0, {10, 90, 20}, {1, 2, 3}};
    // From the pivot itself: as if taken in front of it.
    const Vec3d to(0.6, 0, 0);
    const Affine3 after = map_of(dragged(start, SolidDrag::turn, pivot, pivot.point, to));
    EXPECT_LT(glm::distance(after(to), map_of(start)({0.5, 0, 0.1})), 1e-8);
    EXPECT_NEAR(dragged(start, SolidDrag::size, pivot, pivot.point, {0.7, 0, 0}).scale, 1.0, 1e-12);
    const DragPivot point{{0.5, 0, 0}, 0.0};
    for (const SolidDrag drag : {SolidDrag::turn, SolidDrag::size}) {
        const SolidOptions same = dragged(start, drag, point, point.point, to);
        EXPECT_LT(glm::distance(map_of(same)({1, 2, 3}), map_of(start)({1, 2, 3})), 1e-8);
    }
}

TEST(SolidDrag, StaysWithinWhatRecipesHold) {
    SolidOptions solid;
    for (int i = 0; i < 100; ++i) solid = enlarged(solid, {0.1, 0, 0}, 0.5);
    EXPECT_EQ(solid.scale, 1e6);
    for (int i = 0; i < 100; ++i) solid = enlarged(solid, {0.1, 0, 0}, 2.0);
    EXPECT_EQ(solid.scale, 1e-6);
    solid.scale = 1e6;
    EXPECT_EQ(moved(solid, {9, 0, 0}).translate.x, -1e6);
    Recipe recipe = load_recipe("marble");
    SolidDragRandom random;
    for (int i = 0; i < 500; ++i) {
        recipe.solid = turned(recipe.solid, random.vector(-1, 1), random.rotation());
        ASSERT_EQ(parse_recipe(to_json(recipe), "test"), recipe);
    }
}

TEST(SolidDrag, KeysStepInThePicture) {
    const SolidOptions start = SolidDragRandom().solid();
    const Affine3 before = map_of(start);
    const Camera camera = orbit_camera({40, 25, 3.0}, {}, {200, 100});
    const Vec3d pivot(0.1, 0.2, 0.3), right = camera.right, up = camera.up, front = camera.back;
    const auto after = [&](SolidDrag drag, const Vec2d& way) {
        return map_of(stepped(start, drag, camera, pivot, way, 0.25));
    };
    const double close = 1e-8 * start.scale + 1e-8, angle = glm::radians(5.0);
    EXPECT_LT(glm::distance(after(SolidDrag::move, {-1, 0})(-0.25 * right), before(Vec3d(0.0))),
              close);
    EXPECT_LT(glm::distance(after(SolidDrag::move, {0, 1})(0.25 * up), before(Vec3d(0.0))), close);
    // What faces the viewer goes the key's way.
    for (const auto& [way, side] : {std::pair(Vec2d(1, 0), right), std::pair(Vec2d(0, -1), -up)}) {
        const Vec3d there = pivot + std::cos(angle) * front + std::sin(angle) * side;
        EXPECT_LT(glm::distance(after(SolidDrag::turn, way)(there), before(pivot + front)), close);
    }
    EXPECT_LT(glm::distance(after(SolidDrag::size, {0, 1})(pivot + 1.05 * up), before(pivot + up)),
              close);
}

TEST(SolidDrag, BesideTheObjectIsOnThePlaneOfThePicture) {
    const Camera camera = orbit_camera({40, 25, 3.0}, {{1, 2, 3}, 2.0}, {200, 100});
    const Vec3d through(1.5, 1.0, 3.5);
    for (const Vec2d& pixel : {Vec2d(10, 20), Vec2d(100, 50), Vec2d(199, 3)}) {
        const Vec3d at = beside(camera, ray_through(camera, {200, 100}, pixel), through);
        EXPECT_NEAR(glm::dot(at - through, camera.back), 0.0, 1e-12);
        const Vec3d seen = project(camera, {200, 100}, at);
        EXPECT_LT(glm::distance(Vec2d(seen), pixel), 1e-9);
    }
}

}  // namespace
}  // namespace burl
