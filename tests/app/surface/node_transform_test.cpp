// Decomposed placements put together again, by the definition of a unit quaternion.
#include "app/surface/node_transform.h"

#include <gtest/gtest.h>

#include "tests/app/support/sample_scene.h"

namespace burl {
namespace {

Vec3d rotated(const std::array<double, 4>& q, const Vec3d& v) {
    const Vec3d u(q[0], q[1], q[2]);
    return v + 2.0 * glm::cross(u, glm::cross(u, v) + q[3] * v);
}

void expect_same_map(const Mat4d& matrix) {
    const auto place = decompose(matrix);
    ASSERT_TRUE(place);
    for (const Vec3d& p : {Vec3d(0), Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0.3, -2, 5)}) {
        const Vec3d expected(matrix * Vec4d(p, 1.0));
        const Vec3d got = rotated(place->rotation, place->scale * p) + place->translation;
        EXPECT_LT(glm::distance(expected, got), 1e-12 * (1 + glm::length(expected)));
    }
}

Mat4d turn(int axis, double degrees) {
    const Mat4d z = placement(degrees, Vec3d(1), Vec3d(0));
    Mat4d cycle(0.0);  // axis z becomes `axis`
    for (int i = 0; i < 3; ++i) cycle[i][(i + axis + 1) % 3] = 1.0;
    cycle[3][3] = 1.0;
    return cycle * z * glm::transpose(cycle);
}

TEST(NodeTransform, RotationsScalesAndMirrorsComeBack) {
    for (const double degrees : {0.0, 1e-3, 45.0, 90.0, 179.999, 180.0, 270.0}) {
        for (int axis = 0; axis < 3; ++axis) {
            for (const Vec3d& scale : {Vec3d(1), Vec3d(2, 3, 4), Vec3d(-1, 1, 1), Vec3d(1, 2, -3),
                                       Vec3d(-1), Vec3d(-2, -2, 5), Vec3d(1e-5, 1e5, 1)}) {
                Mat4d diagonal(1.0);
                for (int i = 0; i < 3; ++i) diagonal[i][i] = scale[i];
                Mat4d move(1.0);
                move[3] = Vec4d(1e6, -2, 3, 1);
                expect_same_map(move * turn(axis, degrees) * turn((axis + 1) % 3, 33.0) * diagonal);
            }
        }
    }
}

TEST(NodeTransform, ShearFlatteningAndInfinityAreRefused) {
    Mat4d shear(1.0);
    shear[1][0] = 1e-3;
    EXPECT_FALSE(decompose(shear));
    Mat4d flat(1.0);
    flat[2][2] = 0.0;
    EXPECT_FALSE(decompose(flat));
    Mat4d infinite(1.0);
    infinite[3][0] = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(decompose(infinite));
}

TEST(NormalTransform, StaysPerpendicularToThePlacedSurface) {
    Mat4d matrix = placement(20, Vec3d(1, 3, -2), {4, 5, 6});
    matrix[1][0] += 0.7;  // shear
    const NormalTransform transform(matrix);
    EXPECT_TRUE(transform.mirrors());
    const Vec3d u(1, 2, -1), v(0.5, -1, 3);
    const Vec3d normal = glm::normalize(glm::cross(u, v));
    const Vec3d moved(transform(Vec3f(normal)));
    const Mat3d linear(matrix);
    EXPECT_NEAR(glm::dot(moved, glm::normalize(linear * u)), 0.0, 1e-6);
    EXPECT_NEAR(glm::dot(moved, glm::normalize(linear * v)), 0.0, 1e-6);
    EXPECT_GT(glm::dot(moved, linear * normal), 0.0) << "it stays on the outside";
    EXPECT_NEAR(glm::length(moved), 1.0, 1e-6);
}

}  // namespace
}  // namespace burl
