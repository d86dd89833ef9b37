// Nodes of arithmetic against closed forms, with gradients and without.
#include <cmath>

#include <gtest/gtest.h>

#include "procedural/graph/values.h"
#include "tests/procedural/graph/cases.h"

namespace burl {
namespace {

const std::string s_axis = R"({"node": "coordinate"})",
                  t_axis = R"({"node": "coordinate", "direction": [0, 1, 0]})",
                  r_axis = R"({"node": "coordinate", "direction": [0, 0, 1]})";

/// The node `name` with the keys `rest`.
std::string node_of(const std::string& name, const std::string& rest) {
    return "{\"node\": \"" + name + "\", " + rest + "}";
}

/// A graph's number by the evaluator with gradients, which that of values alone must agree with.
class Number {
  public:
    explicit Number(const std::string& json)
        : evaluate_(graph_of(json)),
          values_(graph_of(json)),
          scratch_(evaluate_.make_scratch()),
          value_scratch_(values_.make_scratch()) {}

    Dual operator()(const Vec3d& p) {
        GraphSample sample;
        evaluate_({&p, 1}, {}, scratch_, {&sample, 1});
        const Dual x = sample.channels[0];
        EXPECT_NEAR(values_(p, value_scratch_).x, x.value, 1e-14 * (1.0 + std::abs(x.value)));
        return x;
    }

  private:
    GraphEvaluator evaluate_;
    GraphValues values_;
    GraphEvaluator::Scratch scratch_;
    GraphValues::Scratch value_scratch_;
};

void expect_near(const Vec3d& a, const Vec3d& b, double error) {
    EXPECT_LT(glm::length(a - b), error * (1.0 + glm::length(b)));
}

TEST(GraphArithmetic, DifferencesAndRatiosHaveAnySign) {
    const std::string inputs = "\"a\": " + s_axis + ", \"b\": " + t_axis;
    Number difference(node_of("subtract", inputs)), ratio(node_of("divide", inputs));
    for (const Vec3d& p : random_points(200, 3.0, 51)) {
        EXPECT_EQ(difference(p).value, p.x - p.y);
        EXPECT_EQ(difference(p).slope, Vec3d(1, -1, 0));
        const Dual found = ratio(p);
        EXPECT_NEAR(found.value, p.x / p.y, 1e-15 * (1.0 + std::abs(p.x / p.y)));
        expect_near(found.slope, {1.0 / p.y, -p.x / (p.y * p.y), 0.0}, 1e-14);
    }
    EXPECT_EQ(ratio({3.0, -2.0, 0.0}).value, -1.5);
    EXPECT_EQ(ratio({-3.0, -2.0, 0.0}).value, 1.5);
    for (const double zero : {0.0, -0.0}) {
        EXPECT_EQ(ratio({5.0, zero, 1.0}).value, 0.0);
        EXPECT_EQ(ratio({5.0, zero, 1.0}).slope, Vec3d(0.0));
    }
}

TEST(GraphArithmetic, ClampKeepsToItsBounds) {
    Number clamp(node_of("clamp", "\"low\": -1, \"high\": 2, \"input\": " + s_axis));
    for (const Vec3d& p : random_points(200, 4.0, 52)) {
        EXPECT_EQ(clamp(p).value, std::clamp(p.x, -1.0, 2.0));
        EXPECT_EQ(clamp(p).slope, Vec3d(p.x > -1.0 && p.x < 2.0 ? 1.0 : 0.0, 0.0, 0.0));
    }
    Number crossed(node_of("clamp", "\"low\": 2, \"high\": -1, \"input\": " + s_axis));
    for (const double x : {-7.0, 0.0, 7.0}) EXPECT_EQ(crossed({x, 0, 0}).value, -1.0);
}

TEST(GraphArithmetic, RemapIsALineThroughItsEnds) {
    const auto remap = [](const std::string& more) {
        return Number(node_of("remap", more + "\"input\": " + s_axis));
    };
    const std::string ends = R"("in_low": -0.3, "in_high": 0.7, "out_low": 5, "out_high": -2, )";
    Number kept = remap(ends), free = remap(ends + R"("clamp": "off", )");
    for (const Vec3d& p : random_points(200, 2.0, 53)) {
        const double line = 5.0 - 7.0 * (p.x + 0.3);
        EXPECT_NEAR(free(p).value, line, 4e-15);
        EXPECT_NEAR(free(p).slope.x, -7.0, 1e-14);
        EXPECT_NEAR(kept(p).value, std::clamp(line, -2.0, 5.0), 4e-15);
        EXPECT_NEAR(kept(p).slope.x, p.x > -0.3 && p.x < 0.7 ? -7.0 : 0.0, 1e-14);
    }
    EXPECT_EQ(kept({-0.3, 0, 0}).value, 5.0);
    // A range of inputs that runs backwards, and one without a width.
    Number backwards = remap(R"("in_low": 4, "in_high": 2, "out_high": 10, )");
    EXPECT_EQ(backwards({3.5, 0, 0}).value, 2.5);
    EXPECT_EQ(backwards({9.0, 0, 0}).value, 0.0);
    EXPECT_EQ(backwards({1.0, 0, 0}).value, 10.0);
    for (const char* clamp : {R"("on")", R"("off")"}) {
        Number step = remap(std::string(R"("in_low": 4, "in_high": 4, "out_low": 1, "clamp": )") +
                            clamp + ", \"out_high\": 3, ");
        EXPECT_EQ(step({3.999, 0, 0}).value, 1.0);
        EXPECT_EQ(step({4.0, 0, 0}).value, 3.0);
    }
}

TEST(GraphArithmetic, LengthsDistancesAndDotsAreThoseOfVectors) {
    const std::string all = "\"x\": " + s_axis + ", \"y\": " + t_axis + ", \"z\": " + r_axis;
    Number length(node_of("length", all)), two(node_of("length", "\"y\": " + r_axis));
    Number dot(node_of("dot", all + R"(, "direction": [2, -3, 0.5])"));
    Number distance(node_of("distance", R"("point": [1, -2, 3])"));
    Number axis(node_of("distance", R"("point": [1, -2, 3], "weights": [1, 0, -2])"));
    for (const Vec3d& p : random_points(200, 3.0, 54)) {
        const double far = std::hypot(p.x, p.y, p.z);
        EXPECT_NEAR(length(p).value, far, 1e-14);
        expect_near(length(p).slope, p / far, 1e-14);
        EXPECT_EQ(two(p).value, std::abs(p.z));
        EXPECT_NEAR(dot(p).value, 2 * p.x - 3 * p.y + 0.5 * p.z, 1e-14);
        EXPECT_EQ(dot(p).slope, Vec3d(2, -3, 0.5));
        const Vec3d away = p - Vec3d(1, -2, 3);
        EXPECT_NEAR(distance(p).value, std::hypot(away.x, away.y, away.z), 1e-14);
        expect_near(distance(p).slope, glm::normalize(away), 1e-14);
        const double weighted = std::hypot(away.x, 2.0 * away.z);
        EXPECT_NEAR(axis(p).value, weighted, 1e-14);
        expect_near(axis(p).slope, Vec3d(away.x, 0.0, 4.0 * away.z) / weighted, 1e-13);
    }
    EXPECT_EQ(length(Vec3d(0.0)).value, 0.0);
    EXPECT_EQ(length(Vec3d(0.0)).slope, Vec3d(0.0));
    EXPECT_EQ(distance({1, -2, 3}).value, 0.0);
    // The distance is from where the node is evaluated: inside of a transform, from its point.
    Number moved(R"({"node": "transform", "scale": [2, 2, 2], "translate": [0, 0, 1],
        "input": {"node": "distance"}})");
    EXPECT_NEAR(moved({1, 1, 0.25}).value, std::hypot(2.0, 2.0, 1.5), 1e-15);
}

}  // namespace
}  // namespace burl
