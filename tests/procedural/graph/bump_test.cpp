// Bumped normals against the exact normals of raised surfaces.
#include "procedural/graph/bump.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "procedural/graph/evaluator.h"
#include "tests/procedural/graph/cases.h"

namespace burl {
namespace {

double degrees_between(const Vec3d& a, const Vec3d& b) {
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

Vec3d gradient_at(const GraphEvaluator& graph, double height, const Affine3& map, const Vec3d& p) {
    return height_gradient(graph(map(p)).channels[0], height, map.linear);
}

/// sin(20 s) as a graph.
const GraphEvaluator& wave() {
    static const GraphEvaluator graph(graph_of(R"({"node": "sin", "input":
        {"node": "coordinate", "direction": [20, 0, 0]}})"));
    return graph;
}

TEST(Bump, PlaneRaisedBySineHasItsNormal) {
    // z = h sin(20 x): normal (-20 h cos(20 x), 0, 1), exact since a plane has no curvature.
    for (double x = -1.0; x <= 1.0; x += 0.037) {
        const Vec3d g = gradient_at(wave(), 0.05, {}, {x, 0.3, -2.0});
        const Vec3d expected = glm::normalize(Vec3d(-std::cos(20.0 * x), 0.0, 1.0));
        EXPECT_LT(glm::length(bumped_normal({0, 0, 1}, g) - expected), 1e-14) << x;
    }
}

TEST(Bump, SphereRaisedRadiallyIsMetToFirstOrderInHeightOverRadius) {
    // r = 1 + h sin(20 x) on the unit sphere has the normal n - grad_S h / (1 + h sin(20 x)).
    std::mt19937 random(3);
    std::normal_distribution<double> gauss;
    for (const double height : {0.02, 0.002}) {
        double worst = 0.0, tilt = 0.0;
        for (int i = 0; i < 500; ++i) {
            const Vec3d n = glm::normalize(Vec3d{gauss(random), gauss(random), gauss(random)});
            const Vec3d g(20.0 * height * std::cos(20.0 * n.x), 0.0, 0.0);
            const Vec3d along = g - glm::dot(g, n) * n;
            const Vec3d exact = n - along / (1.0 + height * std::sin(20.0 * n.x));
            const Vec3d bumped = bumped_normal(n, gradient_at(wave(), height, {}, n));
            EXPECT_NEAR(glm::length(bumped), 1.0, 1e-14);
            EXPECT_LT(glm::length(bumped - glm::normalize(n - along)), 1e-14);
            worst = std::max(worst, degrees_between(bumped, exact));
            tilt = std::max(tilt, degrees_between(bumped, n));
        }
        EXPECT_GT(tilt, 0.95 * glm::degrees(std::atan(20.0 * height)));
        EXPECT_LT(worst, glm::degrees(20.0 * height * height)) << height;
    }
}

TEST(Bump, FlatHeightAndGradientsAlongTheNormalLeaveItsBits) {
    const Vec3d n = glm::normalize(Vec3d(0.3, -0.5, 0.7));
    EXPECT_EQ(bumped_normal(n, Vec3d(0.0)), n);
    EXPECT_EQ(bumped_normal({0, 0, 1}, {0, 0, 123.0}), Vec3d(0, 0, 1));
    EXPECT_EQ(bumped_normal(Vec3d(0.0), {1, 2, 3}), Vec3d(0.0));
    const GraphEvaluator constant(graph_of(R"({"node": "constant", "value": 0.7})"));
    EXPECT_EQ(gradient_at(constant, 5.0, {}, {1, 2, 3}), Vec3d(0.0));
}

TEST(Bump, SteepestGradientsStayOnTheOutside) {
    const Vec3d n = glm::normalize(Vec3d(1, 2, 3));
    const Vec3d bumped = bumped_normal(n, {1e30, -1e30, 0});
    EXPECT_NEAR(glm::length(bumped), 1.0, 1e-12);
    EXPECT_GE(glm::dot(bumped, n), -1e-12);
}

/// Height of a node over points of the object, differentiated numerically.
Vec3d differences(const GraphEvaluator& graph, double height, const Affine3& map, const Vec3d& p) {
    Vec3d g;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3d step(0.0);
        step[axis] = 1e-5;
        g[axis] =
            height *
            (graph(map(p + step)).channels[0].value - graph(map(p - step)).channels[0].value) /
            2e-5;
    }
    return g;
}

TEST(Bump, GradientsFollowTurnsShearsAndUnevenScales) {
    const GraphEvaluator fbm(graph_of(R"({"node": "transform", "scale": [3, 1, 0.5],
        "rotate": [20, 0, 70], "input": {"node": "fbm", "octaves": 3}})"));
    const Mat3d turn(glm::rotate(Mat4d(1.0), 0.8, Vec3d(1, 2, -1)));
    const Mat3d scale(2, 0, 0, 0, 0.3, 0, 0, 0, -1.2), shear(1, 0, 0, 0.7, 1, 0, -0.4, 0.2, 1);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-2.0, 2.0);
    for (const Mat3d& linear : {turn, scale, shear, turn * scale * shear}) {
        const Affine3 map{linear, {0.3, 5.0, -1.0}};
        for (int i = 0; i < 20; ++i) {
            const Vec3d p{uniform(random), uniform(random), uniform(random)};
            const Vec3d exact = gradient_at(fbm, 0.4, map, p);
            EXPECT_LT(glm::length(exact - differences(fbm, 0.4, map, p)),
                      1e-6 * (1.0 + glm::length(exact)));
        }
    }
}

TEST(Bump, TurningTheObjectTurnsItsNormals) {
    // The same solid on a turned object: texture_from_object undoes the turn.
    const Mat3d turn(glm::rotate(Mat4d(1.0), 1.1, Vec3d(2, -1, 0.5)));
    const Vec3d p(0.2, 0.4, -0.3), n = glm::normalize(Vec3d(0.6, 0.1, 0.9));
    const Affine3 turned_back{glm::transpose(turn), Vec3d(0.0)};
    const Vec3d upright = bumped_normal(n, gradient_at(wave(), 0.05, {}, p));
    const Vec3d turned = bumped_normal(turn * n, gradient_at(wave(), 0.05, turned_back, turn * p));
    EXPECT_LT(glm::length(turned - turn * upright), 1e-13);
    EXPECT_GT(degrees_between(upright, n), 5.0);
}

}  // namespace
}  // namespace burl
