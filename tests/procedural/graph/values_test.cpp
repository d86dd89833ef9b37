// Nodes at points where their values are known in closed form.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "atlas/base/json.h"
#include "procedural/color/srgb.h"
#include "procedural/graph/box_means.h"
#include "procedural/model/texture_json.h"
#include "procedural/noise/names.h"
#include "procedural/noise/noise.h"
#include "tests/procedural/graph/cases.h"

namespace burl {
namespace {

constexpr double pi = std::numbers::pi;

TEST(GraphValues, Arithmetic) {
    const Vec3d p(0.75, -1.25, 2.5);
    EXPECT_EQ(value_of(R"({"node": "coordinate", "direction": [1, 2, 4], "offset": -1})", p), 7.25);
    const auto unary = [](const std::string& node, const std::string& x,
                          const std::string& more = "") {
        return value_of("{\"node\": \"" + node + "\", \"input\": " + x + more + "}", Vec3d(0.0));
    };
    const auto binary = [](const std::string& node, const std::string& a, const std::string& b) {
        return value_of("{\"node\": \"" + node + "\", \"a\": " + a + ", \"b\": " + b + "}",
                        Vec3d(0.0));
    };
    EXPECT_EQ(binary("add", "2", "-5"), -3.0);
    EXPECT_EQ(binary("multiply", "2", "-5"), -10.0);
    EXPECT_EQ(binary("min", "2", "-5"), -5.0);
    EXPECT_EQ(binary("max", "2", "-5"), 2.0);
    EXPECT_EQ(binary("scale", "3", "0.5"), 1.5);
    EXPECT_EQ(unary("abs", "-4"), 4.0);
    EXPECT_EQ(unary("floor", "-0.25"), -1.0);
    EXPECT_EQ(unary("fract", "-0.25"), 0.75);
    EXPECT_EQ(unary("sin", "0.5"), std::sin(0.5));
    EXPECT_EQ(unary("power", "-3"), 9.0);
    EXPECT_EQ(unary("power", "16", ", \"exponent\": 0.5"), 4.0);
    EXPECT_EQ(unary("power", "-16", ", \"exponent\": 0.5"), 0.0);
    EXPECT_EQ(unary("smoothstep", "-1"), 0.0);
    EXPECT_EQ(unary("smoothstep", "0.25"), 3 * 0.0625 - 2 * 0.015625);
    EXPECT_EQ(unary("smoothstep", "7"), 1.0);
}

TEST(GraphValues, WeightedSums) {
    EXPECT_DOUBLE_EQ(value_of(R"({"node": "mix", "a": 2, "b": 10, "amount": 0.25})", Vec3d(0.0)),
                     4.0);
    const std::string bilerp = R"({"node": "bilerp", "v00": 1, "v01": 2, "v10": 4, "v11": 8})";
    EXPECT_EQ(value_of(bilerp, {0, 0, 9}), 1.0);
    EXPECT_EQ(value_of(bilerp, {0, 1, 9}), 2.0);
    EXPECT_EQ(value_of(bilerp, {1, 0, 9}), 4.0);
    EXPECT_EQ(value_of(bilerp, {1, 1, 9}), 8.0);
    EXPECT_EQ(value_of(bilerp, {0.5, 0.25, 9}), 0.5 * (0.75 * 5 + 0.25 * 10));
}

TEST(GraphValues, ColoursAreLinearLightTimesAlpha) {
    const GraphSample c =
        GraphEvaluator(graph_of(R"({"node": "constant", "value": "#ff804033"})"))({});
    EXPECT_EQ(c.wire, Wire::color);
    EXPECT_DOUBLE_EQ(c.channels[3].value, 0.2);
    EXPECT_DOUBLE_EQ(c.channels[0].value, 0.2);
    EXPECT_DOUBLE_EQ(c.channels[1].value, 0.2 * srgb_decode(128 / 255.0));
    // A number next to a colour is an opaque grey.
    const GraphSample mixed =
        GraphEvaluator(graph_of(R"({"node": "mix", "a": 0.5, "b": "#ff000000"})"))({});
    EXPECT_DOUBLE_EQ(mixed.channels[0].value, 0.25);
    EXPECT_DOUBLE_EQ(mixed.channels[3].value, 0.5);
}

TEST(GraphValues, ImagesAreLookedUpByTheFootprint) {
    const MipImage image(case_image(""), ImageWrap::clamp);
    const std::string node =
        R"({"node": "image", "file": "image.png", "wrap": "clamp", "lookup": )";
    const TextureGraph trilinear = graph_of(node + "\"trilinear\"}");
    const TextureGraph ewa = graph_of(node + "\"ewa\", \"anisotropy\": 3}");
    const Footprint footprint{{0.1, 0.02, 5}, {-0.03, 0.2, 7}};
    for (const Vec3d& p : random_points(50, 1.2, 21)) {
        EXPECT_EQ(GraphEvaluator(trilinear)(p).color(), image.bilinear(0, p.x, p.y).color);
        EXPECT_EQ(GraphEvaluator(trilinear)(p, footprint).color(),
                  image.trilinear(p.x, p.y, 0.4).color);
        EXPECT_EQ(GraphEvaluator(ewa)(p, footprint).color(),
                  image.ewa(p.x, p.y, {0.1, 0.02}, {-0.03, 0.2}, 3).color);
    }
}

TEST(GraphValues, LayersFollowPorterAndDuff) {
    const auto over = [](const char* opacity) {
        return GraphEvaluator(graph_of(std::string(R"({"node": "layer_over", "top": "#ffffff80",
            "base": "#ff000040", "opacity": )") +
                                       opacity + "}"))({});
    };
    const double top = 128 / 255.0, base = 64 / 255.0;
    EXPECT_DOUBLE_EQ(over("1").channels[0].value, top + (1 - top) * base);
    EXPECT_DOUBLE_EQ(over("1").channels[1].value, top);
    EXPECT_DOUBLE_EQ(over("1").channels[3].value, top + (1 - top) * base);
    EXPECT_DOUBLE_EQ(over("0.5").channels[1].value, 0.5 * top);
    EXPECT_EQ(over("-3").channels[1].value, 0.0);
    EXPECT_DOUBLE_EQ(over("9").channels[1].value, top);
}

TEST(GraphValues, FieldAndColourMapAreTheModelOf1999) {
    const auto json = nlohmann::ordered_json::parse(R"({"node": "color_map", "wrap": "repeat",
        "stops": [[0, "#102030"], [0.4, "#f0e0d0"], [0.4, "#ff0000"], [1, "#102030"]],
        "input": {"node": "field", "quadric": {"A": 1, "I": 0.5}, "noise": [
            {"octaves": 4, "frequency": [2, 3, 4]}, {"kind": "perlin", "amplitude": 0.3}]}})");
    const Texture texture = texture_from_json(json);
    const TextureGraph graph = graph_from_json(json);
    EXPECT_FALSE(is_graph(json));
    for (const Vec3d& p : random_points(200, 20.0, 3)) {
        const double f = evaluate_field(texture, p);
        const Vec3d color = evaluate_color(texture.colors, f);
        EXPECT_NEAR(glm::length(GraphEvaluator(graph)(p).color() - color), 0.0, 1e-12);
    }
}

TEST(GraphValues, StripesRampsAndSines) {
    const char* stripes = R"({"node": "stripes", "period": 0.5})";
    EXPECT_EQ(value_of(stripes, {0.1, 9, 9}), 0.0);
    EXPECT_EQ(value_of(stripes, {0.6, 9, 9}), 1.0);
    EXPECT_EQ(value_of(stripes, {-0.1, 9, 9}), 1.0);
    const char* ramp = R"({"node": "ramp", "direction": [0, 1, 0], "period": 2})";
    EXPECT_EQ(value_of(ramp, {9, 0.5, 9}), 0.25);
    EXPECT_EQ(value_of(ramp, {9, -0.5, 9}), 0.75);
    const char* sine = R"({"node": "sine", "direction": [0, 0, 1], "period": 4})";
    EXPECT_NEAR(value_of(sine, {9, 9, 1}), 1.0, 1e-15);
    EXPECT_NEAR(value_of(sine, {9, 9, 3}), 0.0, 1e-15);
    const GraphSample uv = GraphEvaluator(graph_of(R"({"node": "uv"})"))({-0.25, 3.5, 1});
    EXPECT_EQ(uv.color(), Vec3d(0.75, 0.5, 0));
    EXPECT_EQ(uv.channels[3].value, 1.0);
}

TEST(GraphValues, RingsAndGrainFollowTheDistance) {
    const char* rings = R"({"node": "rings", "spacing": 0.5})";
    EXPECT_EQ(value_of(rings, {0.3, 0.3, 7}), 0.0);
    EXPECT_EQ(value_of(rings, {0.6, 0.3, -7}), 1.0);
    EXPECT_EQ(value_of(rings, {0, -1.1, 0}), 0.0);
    // The slides' ring(r / M + k sin(theta / N)), with N = 1/3.
    for (const Vec3d& p : random_points(200, 2.0, 11)) {
        const double turn = std::atan2(p.y, p.x), r = std::hypot(p.x, p.y);
        const double x = r / 0.4 + 0.3 * std::sin(3 * turn + 2 * p.z);
        const std::string grain = R"({"node": "wood_grain", "spacing": 0.4, "wobble": 0.3,
            "wobbles": 3, "twist": 2, "profile": )";
        EXPECT_EQ(value_of(grain + "\"hard\"}", p), std::fmod(std::floor(x) + 10, 2.0));
        EXPECT_NEAR(value_of(grain + "\"ramp\"}", p), x - std::floor(x), 1e-12);
    }
}

TEST(GraphValues, MappingsHaveTheSlidesCoordinates) {
    const auto at = [](const std::string& mapping, const Vec3d& p) {
        Vec3d result(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            const char* direction[] = {"[1,0,0]", "[0,1,0]", "[0,0,1]"};
            result[axis] =
                value_of("{" + mapping + R"(, "input": {"node": "coordinate", "direction": )" +
                             direction[axis] + "}}",
                         p);
        }
        return result;
    };
    for (const Vec3d& p : random_points(100, 2.0, 19)) {
        const double r = glm::length(p), phi = std::atan2(p.y, p.x);
        const Vec3d sphere = at(R"("node": "map_spherical")", p);
        EXPECT_NEAR(sphere.x, std::acos(p.z / r) / pi, 1e-12);
        EXPECT_NEAR(sphere.y, (phi < 0 ? phi + 2 * pi : phi) / (2 * pi), 1e-12);
        EXPECT_NEAR(sphere.z, r, 1e-12);
        const Vec3d tube = at(R"("node": "map_cylindrical", "height": "normalized")", p);
        EXPECT_NEAR(tube.x, (pi + phi) / (2 * pi), 1e-12);
        EXPECT_NEAR(tube.y, p.z / r, 1e-12);
        EXPECT_EQ(at(R"("node": "map_cylindrical")", p).y, p.z);
        const Vec3d plane =
            at(R"("node": "map_planar", "vs": [1,2,3], "vt": [0,1,-1], "offset": [5,6])", p);
        EXPECT_NEAR(plane.x, p.x + 2 * p.y + 3 * p.z + 5, 1e-12);
        EXPECT_NEAR(plane.y, p.y - p.z + 6, 1e-12);
        EXPECT_EQ(plane.z, 0.0);
        EXPECT_EQ(at(R"("node": "map_uv", "scale": [2,3], "offset": [1,-1])", p),
                  Vec3d(2 * p.x + 1, 3 * p.y - 1, p.z));
    }
    // A quarter turn about each axis takes the next axis to the one after it.
    const auto turned = [&](const char* degrees, const Vec3d& p) {
        return at(std::string(R"("node": "transform", "rotate": )") + degrees, p);
    };
    EXPECT_NEAR(glm::distance(turned("[90,0,0]", {0, 1, 0}), {0, 0, 1}), 0.0, 1e-15);
    EXPECT_NEAR(glm::distance(turned("[0,90,0]", {0, 0, 1}), {1, 0, 0}), 0.0, 1e-15);
    EXPECT_NEAR(glm::distance(turned("[0,0,90]", {1, 0, 0}), {0, 1, 0}), 0.0, 1e-15);
    const Vec3d all = at(R"("node": "transform", "scale": [2,3,4], "rotate": [0,0,90],
        "translate": [1,0,0], "matrix": [1,0,0,10, 0,2,0,20, 0,0,3,30])",
                         {1, 1, 1});
    EXPECT_NEAR(glm::distance(all, Vec3d(-3 + 1 + 10, 2 * 2 + 20, 3 * 4 + 30)), 0.0, 1e-14);
}

/// Mean of f over [x - w/2, x + w/2] by the midpoint rule.
template <class Function>
double mean_over(double x, double w, Function&& f) {
    constexpr int steps = 20000;
    double sum = 0.0;
    for (int k = 0; k < steps; ++k) sum += f(x + w * ((k + 0.5) / steps - 0.5));
    return sum / steps;
}

TEST(BoxMeans, AreIntegrals) {
    std::mt19937 random(23);
    std::uniform_real_distribution<double> place(-8.0, 8.0), width(0.001, 6.0);
    for (int i = 0; i < 60; ++i) {
        const double x = place(random), w = width(random);
        EXPECT_NEAR(box_odd(x, w).value, mean_over(x, w, odd_cell), 5e-4);
        EXPECT_NEAR(box_fract(x, w).value,
                    mean_over(x, w, [](double y) { return y - std::floor(y); }), 5e-4);
        EXPECT_NEAR(box_step(x, w).value,
                    mean_over(x, w, [](double y) { return y >= 0 ? 1.0 : 0.0; }), 1e-4);
        EXPECT_NEAR(box_sin(x, w).value, mean_over(x, w, [](double y) { return std::sin(y); }),
                    1e-6);
    }
    EXPECT_EQ(box_odd(0.25, 1e300).value, 0.5);
    EXPECT_EQ(box_fract(0.25, INFINITY).value, 0.5);
    EXPECT_EQ(box_sin(0.25, INFINITY).value, 0.0);
}

TEST(GraphNoise, OctavesFadeToTheirMean) {
    for (const char* node : {"fbm", "wrinkled", "windy"}) {
        const TextureGraph graph =
            graph_of(std::string(R"({"node": ")") + node + R"(", "octaves": 6, "kind": "value"})");
        const double mean = std::string(node) == "wrinkled"
                                ? mean_absolute(NoiseKind::value) * (2 - std::pow(0.5, 5))
                                : 0.0;
        for (const Vec3d& p : random_points(20, 5.0, 29)) {
            const double full = sample_of(graph, p).value;
            const auto with = [&](double step) {
                return sample_of(graph, p, {{step, 0, 0}, {0, 0, 0.5 * step}}).value;
            };
            EXPECT_EQ(with(1e-4), full) << node;
            EXPECT_NE(with(0.05), full) << node;
            EXPECT_DOUBLE_EQ(with(100.0), mean) << node;
        }
    }
}

TEST(GraphNoise, MeansAreThoseOfTheNoise) {
    for (std::size_t kind = 0; kind < noise_kinds.size(); ++kind)
        for (const bool timed : {false, true}) {
            NoiseSpec noise;
            noise.kind = NoiseKind(kind);
            if (timed && !has_dimensions(noise.kind, 4)) continue;
            double sum = 0.0, absolute = 0.0;
            const auto points = random_points(40000, 2000.0, 31);
            for (std::size_t i = 0; i < points.size(); ++i) {
                noise.seed = std::uint32_t(i % 251);
                if (timed) noise.time = 0.6180339887 * double(i);
                const double n = evaluate_noise(noise, points[i]);
                sum += n;
                absolute += std::abs(n);
            }
            const double count = double(points.size());
            EXPECT_NEAR(sum / count, mean_value(noise.kind, timed), 0.013) << kind << timed;
            EXPECT_NEAR(absolute / count, mean_absolute(noise.kind, timed), 0.007) << kind << timed;
        }
}

TEST(GraphNoise, TimeIsTheFourthCoordinate) {
    const TextureGraph graph = graph_of(
        R"({"node": "fbm", "octaves": 2, "time": 2.25, "time_period": 4, "kind": "value"})");
    const TextureGraph later = graph_of(
        R"({"node": "fbm", "octaves": 2, "time": 6.25, "time_period": 4, "kind": "value"})");
    const TextureGraph elsewhen = graph_of(
        R"({"node": "fbm", "octaves": 2, "time": 2.75, "time_period": 4, "kind": "value"})");
    NoiseSpec noise;
    noise.period[3] = 4;
    for (const Vec3d& p : random_points(50, 5.0, 37)) {
        noise.seed = 0;
        const double first = sample_noise<double, 4>(noise, {p.x, p.y, p.z, 2.25}).value;
        noise.seed = 1;
        const double second =
            sample_noise<double, 4>(noise, {2.0 * p.x, 2.0 * p.y, 2.0 * p.z, 2.25}).value;
        EXPECT_DOUBLE_EQ(sample_of(graph, p).value, first + 0.5 * second);
        EXPECT_EQ(sample_of(later, p).value, sample_of(graph, p).value) << "one period on";
        EXPECT_NE(sample_of(elsewhen, p).value, sample_of(graph, p).value);
    }
}

TEST(GraphNoise, EveryNodeOfNoiseMovesWithTime) {
    for (const char* node : {R"("fbm")", R"("wrinkled")", R"("windy")", R"("marble")",
                             R"("bumps", "threshold": 0.5, "frequency": [3, 3, 3])",
                             R"("warp", "input": {"node": "coordinate"})"}) {
        const auto at = [&](const char* time) {
            return graph_of(std::string(R"({"node": )") + node + R"(, "time": )" + time + "}");
        };
        const TextureGraph still = at("null"), now = at("0.5"), then = at("1.25");
        EXPECT_EQ(still, graph_of(std::string(R"({"node": )") + node + "}"));
        int moved = 0;
        for (const Vec3d& p : random_points(200, 5.0, 41)) {
            moved += sample_of(now, p).value != sample_of(then, p).value;
            moved += sample_of(now, p).value != sample_of(still, p).value;
        }
        EXPECT_GT(moved, 40) << node;
    }
}

TEST(GraphNoise, SumsAreThoseOfTheLibrary) {
    const TextureGraph fbm = graph_of(R"({"node": "fbm", "octaves": 5, "seed": 7, "gain": 0.6})");
    const TextureGraph wrinkled = graph_of(R"({"node": "wrinkled", "octaves": 4})");
    const TextureGraph windy = graph_of(R"({"node": "windy"})");
    const auto sum = [](OctaveShape shape, std::uint32_t octaves, double gain, std::uint32_t seed,
                        const Vec3d& p) {
        const FractalSum fractal{shape, octaves, 2.0, gain, false};
        return fractal_sum<double, 3>(fractal, {p.x, p.y, p.z},
                                      [seed](std::uint32_t k, auto q) {
                                          NoiseSpec noise;
                                          noise.kind = NoiseKind::perlin;
                                          noise.seed = seed + k;
                                          return sample_noise<double, 3>(noise, q);
                                      })
            .value;
    };
    for (const Vec3d& p : random_points(50, 9.0, 37)) {
        EXPECT_NEAR(sample_of(fbm, p).value, sum(OctaveShape::plain, 5, 0.6, 7, p), 1e-13);
        EXPECT_NEAR(sample_of(wrinkled, p).value, sum(OctaveShape::absolute, 4, 0.5, 0, p), 1e-13);
        const double wind = std::abs(sum(OctaveShape::plain, 3, 0.5, 0, 0.1 * p));
        EXPECT_NEAR(sample_of(windy, p).value, wind * sum(OctaveShape::plain, 6, 0.5, 0, p), 1e-13);
    }
}

TEST(GraphNoise, MarbleRunsThroughItsColours) {
    // Without noise the veins are planes of t; at sin = -1 the spline begins, at 1 it ends.
    const auto at = [](const char* spline, double t) {
        return GraphEvaluator(graph_of(std::string(R"({"node": "marble", "variation": 0,
            "spline": ")") + spline + "\"}"))({0.3, t, 0.8})
            .color();
    };
    EXPECT_NEAR(glm::distance(at("bezier", -pi / 2), 1.5 * Vec3d(.58, .58, .6)), 0.0, 1e-12);
    EXPECT_NEAR(glm::distance(at("bezier", pi / 2), 1.5 * Vec3d(.58, .58, .6)), 0.0, 1e-12);
    EXPECT_NEAR(glm::distance(at("bspline", pi / 2),
                              1.5 * (Vec3d(.58, .58, .6) * 2.0 + 4.0 * Vec3d(.2, .2, .33)) / 6.0),
                0.0, 1e-12);
    // The end of the first four colours: 0.5 for pbrt, and then the next four begin.
    EXPECT_NEAR(at("bezier", std::asin(-2.0 / 3.0) - 1e-9).x, 1.5 * 0.5, 1e-6);
    EXPECT_NEAR(at("bezier", std::asin(-2.0 / 3.0) + 1e-9).x, 1.5 * 0.58, 1e-6);
    EXPECT_NEAR(at("bspline", std::asin(-2.0 / 3.0) - 1e-9).x,
                at("bspline", std::asin(-2.0 / 3.0) + 1e-9).x, 1e-6);
}

TEST(GraphNoise, DotsFillHalfOfTheCells) {
    const GraphEvaluator evaluate(graph_of(R"({"node": "dots", "radius": 0.3})"));
    int cells = 0;
    double area = 0.0;
    for (int s = 0; s < 20; ++s)
        for (int t = 0; t < 20; ++t) {
            double cell = 0.0;
            for (int k = 0; k < 400; ++k)
                cell += evaluate({s - 0.475 + 0.05 * (k % 20), t - 0.475 + 0.05 * (k / 20), 0.5})
                            .channels[0]
                            .value /
                        400;
            cells += cell > 0.0;
            if (cell > 0.0) {
                EXPECT_NEAR(cell, pi * 0.09, 0.03);
            }
            area += cell / 400;
        }
    EXPECT_NEAR(cells, 200, 50);
    EXPECT_NEAR(area, cells / 400.0 * pi * 0.09, 0.005);
}

TEST(GraphNoise, DotsRepeat) {
    const TextureGraph graph =
        graph_of(R"({"node": "dots", "radius": 0.3, "period_u": 5, "period_v": 7})");
    double sum = 0.0;
    for (const Vec3d& p : random_points(300, 9.0, 43)) {
        EXPECT_EQ(sample_of(graph, p).value, sample_of(graph, {p.x + 5, p.y - 7, 0}).value);
        sum += sample_of(graph, p).value;
    }
    EXPECT_GT(sum, 20.0);
}

TEST(GraphNoise, BumpsAreNoiseAboveAThreshold) {
    NoiseSpec noise;
    noise.kind = NoiseKind::perlin;
    const TextureGraph graph = graph_of(R"({"node": "bumps", "frequency": [5, 5, 2]})");
    int high = 0;
    for (const Vec3d& p : random_points(400, 5.0, 41)) {
        const double n = evaluate_noise(noise, {5 * p.x, 5 * p.y, 2 * p.z});
        EXPECT_EQ(sample_of(graph, p).value, n >= 0.0 ? 1.0 : 0.0);
        high += n >= 0.0;
        // A footprint as wide as a thousand cells sees a bit of both.
        const double blurred = sample_of(graph, p, {{200, 0, 0}, {0, 200, 0}}).value;
        EXPECT_NEAR(blurred, 0.5, 0.45);
    }
    EXPECT_NEAR(high, 200, 60);
}

}  // namespace
}  // namespace burl
