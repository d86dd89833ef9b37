// Thickness of slabs and balls, whose mean chords are known.
#include "atlas/shape/thickness.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "tests/atlas/support/made_shapes.h"

namespace burl {
namespace {

std::vector<float> depths(const ShapeScene& shape, const std::vector<ShapePoint>& points,
                          const ThicknessOptions& options = {}) {
    std::vector<float> values(points.size(), -1.0f);
    thickness(shape, points, options, values);
    return values;
}

TEST(Thickness, OfASlab) {
    for (const double height : {1.0, 0.01}) {
        const Mesh slab = made::cuboid({-100, -100, 0}, {100, 100, height});
        const ShapeScene shape(slab);
        const ShapePoint top = made::point_at(shape, 2, {5.0, -7.0, height});
        ASSERT_EQ(top.normal, Vec3d(0, 0, 1));
        for (const double cap : {1.0, 2.0, 20.0}) {
            const double expected =
                cap * height > height * height ? 2.0 * height - height * height / cap : cap;
            EXPECT_NEAR(depths(shape, {top}, {4096, cap})[0], expected, 0.01 * expected);
        }
    }
}

TEST(Thickness, OfABall) {
    for (const double scale : {1e-30, 3.0, 1e20}) {
        const Mesh ball = made::placed(made::ball(5), scale, scale * Vec3d(7, 8, 9));
        const ShapeScene shape(ball);
        double mean = 0.0;
        const auto values = depths(shape, made::middles(shape));
        for (const float v : values) mean += double(v) / double(values.size());
        const double radius = 0.5 * bounding_box(ball).longest_side();
        EXPECT_NEAR(mean / radius, 4.0 / 3.0, 0.005);
        for (const float v : values) EXPECT_NEAR(v / radius, 4.0 / 3.0, 0.05);
    }
}

TEST(Thickness, OfAnOpenMeshIsTheCap) {
    const ShapeScene shape(made::sheet({0, 0, 0}, {3, 0, 0}, {0, 4, 0}));
    EXPECT_FLOAT_EQ(depths(shape, made::middles(shape))[0], 5.0f);
    EXPECT_FLOAT_EQ(depths(shape, made::middles(shape), {64, 0.25})[0], 0.25f);
}

TEST(Thickness, ThreadsAndLinesDoNotMatter) {
    const auto with_threads = [&](const Mesh& mesh, std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        const ShapeScene shape(mesh);
        return depths(shape, made::middles(shape));
    };
    const Mesh torus = made::torus(1.0, 0.45, 60, 30);
    EXPECT_EQ(with_threads(torus, 1), with_threads(torus, 4));
    for (const float v : with_threads(made::nasty(), 2)) EXPECT_GE(v, 0.0f);
    const Mesh line = made::mesh_of({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}});
    EXPECT_EQ(with_threads(line, 2), std::vector<float>{0.0f});
}

}  // namespace
}  // namespace burl
