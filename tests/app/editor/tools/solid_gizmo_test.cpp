// The handles on a texture's frame, against what the texture's own map says.
#include "app/editor/tools/solid_gizmo.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/scene/camera.h"
#include "tests/app/support/solid_map.h"

namespace burl {
namespace {

class SolidGizmoTest : public ::testing::Test {
  protected:
    const Sphere sphere{{4, 5, 6}, 2.0};
    const SolidOptions start{SolidSpace::unit, 3.0, {20, 40, 150}, {0.2, -0.1, 0.3}};
    GizmoView view = seen_from(30, 20);

    GizmoView seen_from(double azimuth, double elevation) const {
        GizmoView result;
        result.size = {640, 480};
        result.camera = orbit_camera({azimuth, elevation, 3.5}, sphere, result.size);
        result.solid_from_scene = {Mat3d(0.25), -0.25 * sphere.centre};
        return result;
    }
    SolidGizmo gizmo() const { return gizmo_of(view, start, Vec3d(0.0), 90.0); }
    Vec2d seen(const Vec3d& point) const { return Vec2d(project(view.camera, view.size, point)); }
    /// The texture's point at a point of the scene.
    Vec3d shown(const SolidOptions& solid, const Vec3d& point) const {
        return map_of(solid)(view.solid_from_scene(point));
    }
};

TEST_F(SolidGizmoTest, StandsAtItsPointWithItsAxesAndItsSize) {
    for (const Vec3d& anchor : {Vec3d(0.0), Vec3d(0.5, 1, -1)}) {
        const SolidGizmo g = gizmo_of(view, start, anchor, 90.0);
        EXPECT_LT(glm::distance(shown(start, g.centre), anchor), 1e-12);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Vec3d way(0.0);
            way[int(axis)] = 0.25 * 3.0;  // solid units of a scene's, times the scale
            EXPECT_NEAR(glm::length(g.axes[axis]), 1.0, 1e-12);
            EXPECT_LT(glm::distance(shown(start, g.centre + g.axes[axis]), anchor + way), 1e-12);
        }
        const Vec3d aside = g.centre + g.length * view.camera.right;
        EXPECT_NEAR(glm::distance(seen(aside), seen(g.centre)), 90.0, 1e-9);
    }
}

TEST_F(SolidGizmoTest, KeepsItsPlaceWhileThatIsOnTheObject) {
    const Vec3d held(0.3, 0.2, 0.1), far(50, 0, 0);
    EXPECT_EQ(gizmo_anchor(view, start, held, sphere, sphere.centre), held);
    EXPECT_EQ(gizmo_anchor(view, start, far, sphere, sphere.centre), Vec3d(0.0));
    EXPECT_EQ(gizmo_anchor(view, start, {}, sphere, sphere.centre), Vec3d(0.0));
    SolidOptions away = start;
    away.translate = {40, 0, 0};
    const Vec3d centre = gizmo_anchor(view, away, {}, sphere, sphere.centre);
    EXPECT_LT(glm::distance(gizmo_of(view, away, centre, 90.0).centre, sphere.centre), 1e-12);
}

TEST_F(SolidGizmoTest, EveryHandleHasAPlaceWhereItIsFound) {
    const SolidGizmo g = gizmo();
    for (const GizmoHandle& handle : gizmo_handles) {
        const auto place = place_of(g, view, handle);
        ASSERT_TRUE(place) << int(handle.part) << handle.axis;
        EXPECT_EQ(handle_at(g, view, *place), handle);
    }
    EXPECT_EQ(handle_at(g, view, seen(g.centre)), (GizmoHandle{GizmoPart::square, 0}));
    EXPECT_FALSE(handle_at(g, view, seen(g.centre) + Vec2d(150, 0)));
}

TEST_F(SolidGizmoTest, AnArrowSeenEndOnCannotBePulled) {
    SolidOptions upright;
    view = seen_from(0, 0);
    const SolidGizmo g = gizmo_of(view, upright, Vec3d(0.0), 90.0);
    EXPECT_FALSE(can_be_held(g, view, {GizmoPart::arrow, 2}));
    EXPECT_TRUE(can_be_held(g, view, {GizmoPart::arrow, 0}));
    EXPECT_FALSE(place_of(g, view, {GizmoPart::arrow, 2}));
}

TEST_F(SolidGizmoTest, AnArrowMovesAlongItsAxisUnderThePointer) {
    const SolidGizmo g = gizmo();
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3d a = g.centre + 0.6 * g.length * g.axes[std::size_t(axis)];
        const Vec3d b = g.centre + 1.7 * g.length * g.axes[std::size_t(axis)];
        const auto after = pulled(start, g, view, {GizmoPart::arrow, axis}, seen(a), seen(b));
        ASSERT_TRUE(after);
        EXPECT_LT(glm::distance(shown(*after, b), shown(start, a)), 1e-8);
        EXPECT_EQ(after->rotate, start.rotate);
        EXPECT_EQ(after->scale, start.scale);
        // Only the axis' own coordinate changes, wherever the pointer goes.
        const auto astray =
            pulled(start, g, view, {GizmoPart::arrow, axis}, seen(a), seen(b) + Vec2d(9, -13));
        ASSERT_TRUE(astray);
        for (const int other : {(axis + 1) % 3, (axis + 2) % 3})
            EXPECT_NEAR(astray->translate[other], start.translate[other], 1e-8);
    }
}

TEST_F(SolidGizmoTest, ARingTurnsWithThePointer) {
    const SolidGizmo g = gizmo();
    for (int axis = 0; axis < 3; ++axis) {
        const std::vector<Vec3d> ring = ring_points(g, axis);
        const Vec3d &a = ring[3], &b = ring[27];
        const auto after = pulled(start, g, view, {GizmoPart::ring, axis}, seen(a), seen(b));
        ASSERT_TRUE(after);
        EXPECT_LT(glm::distance(shown(*after, b), shown(start, a)), 1e-8);
        const Vec3d& line = g.axes[std::size_t(axis)];
        for (const double t : {0.0, 1.0})
            EXPECT_LT(glm::distance(shown(*after, g.centre + t * line),
                                    shown(start, g.centre + t * line)),
                      1e-8);
        EXPECT_EQ(after->scale, start.scale);
    }
}

TEST_F(SolidGizmoTest, ARingSeenFromItsEdgeTurnsAsItsNearHalfMoves) {
    view = seen_from(0, 0);
    const SolidGizmo g = gizmo_of(view, {}, Vec3d(0.0), 90.0);  // y's ring is a line
    const double radius = gizmo_ring * 90.0, step = 0.3;
    const Vec2d from = seen(g.centre), to = from + Vec2d(step * radius, 5.0);
    const auto after = pulled({}, g, view, {GizmoPart::ring, 1}, from, to);
    ASSERT_TRUE(after);
    const Vec3d front(0, 0, 1), turned(std::sin(step), 0, std::cos(step));
    EXPECT_LT(glm::distance(map_of(*after)(turned), front), 1e-8);
}

TEST_F(SolidGizmoTest, TheSquareDoublesWithAHundredPixels) {
    const SolidGizmo g = gizmo_of(view, start, {0.1, 0.2, 0.3}, 90.0);
    const Vec2d at = seen(g.centre);
    const auto after = pulled(start, g, view, gizmo_handles[0], at, at + Vec2d(60, -40));
    ASSERT_TRUE(after);
    EXPECT_NEAR(after->scale, 0.5 * start.scale, 1e-9);
    EXPECT_LT(glm::distance(shown(*after, g.centre), Vec3d(0.1, 0.2, 0.3)), 1e-8);
    const auto back = pulled(start, g, view, gizmo_handles[0], at, at + Vec2d(-100, 0));
    EXPECT_NEAR(back->scale, 2.0 * start.scale, 1e-9);
}

TEST_F(SolidGizmoTest, APointerThatHasNotMovedChangesNothing) {
    for (const GizmoHandle& handle : gizmo_handles)
        EXPECT_EQ(pulled(start, gizmo(), view, handle, {300, 200}, {300, 200}), start);
}

}  // namespace
}  // namespace burl
