#include "atlas/mesh/unit_frame.h"

#include <gtest/gtest.h>

#include <random>

namespace burl {
namespace {

/// Points in single precision in a box whose sides are 2: half their coordinates lie between two
/// steps of the unit frame.
Mesh points_of_floats() {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> coordinate(-1.0f, 1.0f);
    Mesh mesh;
    mesh.positions = {Vec3d(-1.0), Vec3d(1.0)};
    for (int i = 0; i < 20000; ++i)
        mesh.positions.emplace_back(coordinate(random), coordinate(random), coordinate(random));
    return mesh;
}

TEST(UnitFrame, RoundsToTheNearestStep) {
    const Mesh mesh = points_of_floats(), framed = in_unit_frame(mesh);
    std::size_t ties = 0;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        for (int axis = 0; axis < 3; ++axis) {
            const double steps = (mesh.positions[i][axis] + 1.0) * 0x1p23;
            EXPECT_LE(std::abs(framed.positions[i][axis] * 0x1p24 - steps), 0.5 + 0x1p-17);
            ties += steps - std::floor(steps) == 0.5;
        }
    EXPECT_GT(ties, mesh.positions.size() / 2);
}

TEST(UnitFrame, NeitherScaleNorPlaceChangesABit) {
    const Mesh mesh = points_of_floats(), framed = in_unit_frame(mesh);
    for (const double scale : {3.7, 0.001, 1e-6, 7.7e5})
        for (const Vec3d& by : {Vec3d(0.0), Vec3d(3, -2, 0.25), Vec3d(1000.1, -1000.3, 5.7)}) {
            Mesh other = mesh;
            for (Vec3d& p : other.positions) p = scale * (p + by);
            EXPECT_EQ(in_unit_frame(other).positions, framed.positions) << scale << ' ' << by.x;
        }
}

}  // namespace
}  // namespace burl
