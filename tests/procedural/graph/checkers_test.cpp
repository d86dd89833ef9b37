// Checkerboards against pbrt's formula and against counting.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/procedural/graph/cases.h"

namespace burl {
namespace {

/// pbrt's closed form as the slides print it, for the weight of the second texture.
double slides_closed_form(double s, double t, double ds, double dt) {
    const auto bump = [](double x) {
        return std::floor(x / 2) + 2 * std::max(x / 2 - std::floor(x / 2) - 0.5, 0.0);
    };
    const double s_share = (bump(s + ds) - bump(s - ds)) / (2 * ds);
    const double t_share = (bump(t + dt) - bump(t - dt)) / (2 * dt);
    return ds > 1 || dt > 1 ? 0.5 : s_share + t_share - 2 * s_share * t_share;
}

TEST(Checkers, CheckerboardsAreThoseOfPbrt) {
    const char* hard = R"({"node": "checkerboard", "aa": "none"})";
    const char* cubes = R"({"node": "checkerboard_3d", "aa": "none"})";
    const char* closed = R"({"node": "checkerboard"})";
    std::mt19937 random(5);
    std::uniform_real_distribution<double> size(0.01, 1.3);
    for (const Vec3d& p : random_points(300, 6.0, 13)) {
        const int s = int(std::floor(p.x)), t = int(std::floor(p.y)), r = int(std::floor(p.z));
        EXPECT_EQ(value_of(hard, p), (s + t) & 1);
        EXPECT_EQ(value_of(cubes, p), (s + t + r) & 1);
        const double ds = size(random), dt = size(random);
        const Footprint footprint{{ds, -0.5 * dt, 3}, {-0.4 * ds, dt, 1}};
        EXPECT_NEAR(value_of(closed, p, footprint), slides_closed_form(p.x, p.y, ds, dt), 1e-12);
    }
    // Without a footprint all are point samples.
    EXPECT_EQ(value_of(closed, {0.5, 1.5, 0}), 1.0);
}

TEST(Checkers, SupersampledCheckersApproachTheWeightedMean) {
    // A straight edge through the middle of the sample: half of it whatever the weights.
    const TextureGraph graph = graph_of(R"({"node": "checkerboard", "aa": "supersample"})");
    double sum = 0.0;
    for (const Vec3d& p : random_points(400, 0.2, 17))
        sum += sample_of(graph, {3.0, p.y + 0.5, p.z}, {{0.4, 0, 0}, {0, 0.1, 0}}).value;
    EXPECT_NEAR(sum / 400, 0.5, 0.01);
    // Inside a square it is exact, and any sample is the same every time.
    EXPECT_EQ(sample_of(graph, {3.5, 0.5, 0}, {{0.4, 0, 0}, {0, 0.4, 0}}).value, 1.0);
    const Footprint wide{{5, 1, 0}, {2, 7, 0}};
    EXPECT_EQ(sample_of(graph, {3.1, 0.2, 0}, wide).value,
              sample_of(graph, {3.1, 0.2, 0}, wide).value);
}

/// Share of odd squares in a parallelogram, n x n midpoints.
double counted_checkers(const Vec3d& p, const Footprint& footprint, int n) {
    int odd = 0;
    for (int i = 0; i < n * n; ++i) {
        const Vec3d q =
            p + ((i % n + 0.5) / n - 0.5) * footprint.u + ((i / n + 0.5) / n - 0.5) * footprint.v;
        odd += (int(std::floor(q.x)) + int(std::floor(q.y))) & 1;
    }
    return double(odd) / (n * n);
}

TEST(Checkers, TrapezoidCheckersAreTheMeanOverTheSample) {
    const char* node = R"({"node": "checkerboard", "aa": "trapezoid"})";
    const char* closed = R"({"node": "checkerboard"})";
    std::mt19937 random(5);
    std::uniform_real_distribution<double> size(-1.7, 1.7);
    double error = 0.0, error_of_closed = 0.0;
    for (const Vec3d& p : random_points(300, 6.0, 13)) {
        const double du = size(random), dv = size(random);
        const Footprint straight{{du, 0, 1}, {0, dv, 2}}, along_x{{du, 0, 0}, {dv, 0, 0}};
        EXPECT_NEAR(value_of(node, p, straight), counted_checkers(p, straight, 300), 0.01);
        EXPECT_NEAR(value_of(node, p, along_x), counted_checkers(p, along_x, 300), 0.01);
        const Footprint oblique{{0.1 * du, -0.05 * dv, 3}, {0.07 * dv, 0.1 * dv, 1}};
        const double truth = counted_checkers(p, oblique, 100);
        error += std::pow(value_of(node, p, oblique) - truth, 2);
        error_of_closed += std::pow(value_of(closed, p, oblique) - truth, 2);
    }
    EXPECT_LT(std::sqrt(error / error_of_closed), 0.3);
    // Without a footprint it is a point sample; over many squares it is grey.
    EXPECT_EQ(value_of(node, {0.5, 1.5, 0}), 1.0);
    EXPECT_NEAR(value_of(node, {0.5, 1.5, 0}, {{31.3, 0, 0}, {0, 27.1, 0}}), 0.5, 0.01);
}

}  // namespace
}  // namespace burl
