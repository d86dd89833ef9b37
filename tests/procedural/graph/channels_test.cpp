// Nodes on channels of colours against formulas that were written down elsewhere.
#include <cmath>

#include <gtest/gtest.h>

#include "procedural/graph/values.h"
#include "tests/procedural/graph/cases.h"

namespace burl {
namespace {

/// The colour whose straight channels are the point's coordinates.
const std::string point_color = R"({"node": "combine", "alpha": ALPHA,
    "red": {"node": "coordinate"}, "green": {"node": "coordinate", "direction": [0, 1, 0]},
    "blue": {"node": "coordinate", "direction": [0, 0, 1]}})";

std::string colored(const std::string& alpha) {
    std::string text = point_color;
    return text.replace(text.find("ALPHA"), 5, alpha);
}

/// A graph by the evaluator with gradients, which that of values alone must agree with.
class Colors {
  public:
    explicit Colors(const std::string& json)
        : evaluate_(graph_of(json)),
          values_(graph_of(json)),
          scratch_(evaluate_.make_scratch()),
          value_scratch_(values_.make_scratch()) {}

    GraphSample operator()(const Vec3d& p) {
        GraphSample sample;
        evaluate_({&p, 1}, {}, scratch_, {&sample, 1});
        EXPECT_LT(glm::length(values_(p, value_scratch_) - sample.color()),
                  1e-13 * (1.0 + glm::length(sample.color())));
        return sample;
    }

  private:
    GraphEvaluator evaluate_;
    GraphValues values_;
    GraphEvaluator::Scratch scratch_;
    GraphValues::Scratch value_scratch_;
};

std::vector<Vec3d> random_colors(std::size_t count) {
    std::vector<Vec3d> colors = random_points(count, 0.5, 61);
    for (Vec3d& c : colors) c += Vec3d(0.5);
    return colors;
}

void expect_color(const GraphSample& sample, const Vec3d& color, double alpha,
                  double error = 1e-14) {
    EXPECT_EQ(sample.wire, Wire::color);
    EXPECT_LT(glm::length(sample.color() - color), error * (1.0 + glm::length(color)));
    EXPECT_NEAR(sample.channels[3].value, alpha, 1e-15);
}

TEST(GraphChannels, CombineMultipliesByAlpha) {
    Colors opaque(colored("1")), half(colored("0.5")), over(colored("7")), none(colored("-1"));
    for (const Vec3d& p : random_points(50, 3.0, 60)) {
        expect_color(opaque(p), p, 1.0);
        expect_color(half(p), 0.5 * p, 0.5);
        expect_color(over(p), p, 1.0);
        expect_color(none(p), Vec3d(0.0), 0.0);
    }
}

TEST(GraphChannels, SplitGivesBackWhatWasCombined) {
    const auto channel = [](const std::string& name, const std::string& alpha) {
        return Colors("{\"node\": \"split\", \"channel\": \"" + name +
                      "\", \"input\": " + colored(alpha) + "}");
    };
    for (const char* alpha : {"1", "0.3"}) {
        Colors red = channel("red", alpha), green = channel("green", alpha),
               blue = channel("blue", alpha), opacity = channel("alpha", alpha),
               light = channel("luminance", alpha);
        for (const Vec3d& p : random_points(50, 3.0, 60)) {
            EXPECT_EQ(red(p).wire, Wire::number);
            EXPECT_NEAR(red(p).channels[0].value, p.x, 2e-15);
            EXPECT_NEAR(green(p).channels[0].value, p.y, 2e-15);
            EXPECT_NEAR(blue(p).channels[0].value, p.z, 2e-15);
            EXPECT_EQ(opacity(p).channels[0].value, std::stod(alpha));
            EXPECT_NEAR(light(p).channels[0].value, 0.2126 * p.x + 0.7152 * p.y + 0.0722 * p.z,
                        4e-15);
            EXPECT_NEAR(green(p).channels[0].slope.y, 1.0, 1e-15);
        }
    }
    EXPECT_EQ(channel("red", "0")(Vec3d(1.0)).channels[0].value, 0.0);
    EXPECT_EQ(value_of(R"({"node": "split", "channel": "alpha", "input": 0.2})", Vec3d(0.0)), 1.0);
    EXPECT_NEAR(value_of(R"({"node": "split", "input": 0.2})", Vec3d(0.0)), 0.2, 1e-16);
}

/// Smith's hexcone (1978) as his two algorithms have it, sextant by sextant: hue in [0, 6),
/// saturation and value.
Vec3d hexcone_of(const Vec3d& c) {
    const double v = std::max({c.x, c.y, c.z}), x = std::min({c.x, c.y, c.z});
    const double s = (v - x) / v;
    const double r = (v - c.x) / (v - x), g = (v - c.y) / (v - x), b = (v - c.z) / (v - x);
    const double h = c.x == v   ? (c.y == x ? 5 + b : 1 - g)
                     : c.y == v ? (c.z == x ? 1 + r : 3 - b)
                                : (c.x == x ? 3 + g : 5 - r);
    return {h, s, v};
}
Vec3d color_of(double hue, double s, double v) {
    const double h = std::fmod(std::fmod(hue, 6.0) + 6.0, 6.0), f = h - std::floor(h);
    const double m = v * (1 - s), n = v * (1 - s * f), k = v * (1 - s * (1 - f));
    const Vec3d sextants[] = {{v, k, m}, {n, v, m}, {m, v, k}, {m, n, v}, {k, m, v}, {v, m, n}};
    return sextants[std::size_t(h) % 6];
}

std::string hsv(const std::string& more, const std::string& input) {
    return "{\"node\": \"hsv\", " + more + "\"input\": " + input + "}";
}

TEST(GraphChannels, HueSaturationAndValueAreSmiths) {
    struct Correction {
        const char* text;
        double hue, saturation, value;
    };
    for (const auto& [text, hue, saturation, value] :
         {Correction{R"("hue": 0.4, )", 0.4, 1, 1}, Correction{R"("hue": -7.15, )", -7.15, 1, 1},
          Correction{R"("saturation": 0.3, )", 0, 0.3, 1},
          Correction{R"("hue": 0.7, "saturation": 1.8, "value": 2.5, )", 0.7, 1.8, 2.5}})
        for (const double alpha : {1.0, 0.6}) {
            Colors corrected(hsv(text, colored(std::to_string(alpha))));
            for (const Vec3d& p : random_colors(300)) {
                const Vec3d cone = hexcone_of(p);
                const Vec3d expected =
                    color_of(cone.x + 6 * hue, std::min(1.0, saturation * cone.y), value * cone.z);
                expect_color(corrected(p), alpha * expected, alpha, 1e-13);
            }
        }
}

TEST(GraphChannels, HueTurnsFromRedToGreenToBlue) {
    Colors third(hsv("\"hue\": {\"node\": \"divide\", \"a\": 1, \"b\": 3}, ", colored("1")));
    expect_color(third({1, 0, 0}), {0, 1, 0}, 1.0);
    expect_color(third({0, 1, 0}), {0, 0, 1}, 1.0);
    expect_color(third({0, 0, 1}), {1, 0, 0}, 1.0);
    expect_color(third({1, 1, 0}), {0, 1, 1}, 1.0);
    for (const double grey : {0.0, 0.25, 1.0}) expect_color(third(Vec3d(grey)), Vec3d(grey), 1.0);
    Colors same(hsv("", colored("0.5")));
    for (const Vec3d& p : random_points(200, 2.0, 62)) expect_color(same(p), 0.5 * p, 0.5);
    Colors faded(hsv("\"saturation\": -3, ", colored("1"))), dark(hsv("\"value\": -3, ", "0.7"));
    expect_color(faded({0.2, 0.6, 0.3}), Vec3d(0.6), 1.0);
    expect_color(dark({}), Vec3d(0.0), 1.0);
}

/// The usual correction of levels.
double leveled(double x, double in_black, double in_white, double gamma, double out_black,
               double out_white) {
    const double u = std::clamp((x - in_black) / (in_white - in_black), 0.0, 1.0);
    return out_black + (out_white - out_black) * std::pow(u, 1.0 / gamma);
}

TEST(GraphChannels, LevelsCorrectNumbersAndStraightColours) {
    const std::string numbers =
        R"("in_black": 0.1, "in_white": 0.8, "gamma": 2.2, "out_black": 0.05,
        "out_white": 0.9, "input": )";
    Colors number("{\"node\": \"levels\", " + numbers + R"({"node": "coordinate"}})"),
        half("{\"node\": \"levels\", " + numbers + colored("0.5") + "}"),
        clear("{\"node\": \"levels\", " + numbers + colored("0") + "}");
    const auto corrected = [](double x) { return leveled(x, 0.1, 0.8, 2.2, 0.05, 0.9); };
    for (const Vec3d& p : random_colors(200)) {
        EXPECT_EQ(number(p).wire, Wire::number);
        EXPECT_NEAR(number(p).channels[0].value, corrected(p.x), 1e-12);
        expect_color(half(p), 0.5 * Vec3d(corrected(p.x), corrected(p.y), corrected(p.z)), 0.5,
                     1e-12);
        expect_color(clear(p), Vec3d(0.0), 0.0);
    }
    EXPECT_EQ(number({0.1, 0, 0}).channels[0].value, 0.05);
    const auto value = [](const std::string& more, double x) {
        return value_of("{\"node\": \"levels\", " + more + R"("input": {"node": "coordinate"}})",
                        {x, 0, 0});
    };
    EXPECT_EQ(value("", 0.375), 0.375);
    EXPECT_EQ(value("", -0.375), 0.0);
    EXPECT_EQ(value(R"("out_black": 1, "out_white": 0, )", 0.25), 0.75);
    EXPECT_EQ(value(R"("gamma": 0.5, )", 0.5), 0.25);
    EXPECT_EQ(value(R"("in_black": 0.5, "in_white": 0.5, "gamma": 3, )", 0.499), 0.0);
    EXPECT_EQ(value(R"("in_black": 0.5, "in_white": 0.5, "gamma": 3, )", 0.5), 1.0);
}

}  // namespace
}  // namespace burl
