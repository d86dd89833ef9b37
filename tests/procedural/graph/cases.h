#pragma once
// A small graph for every node of the table, and helpers shared by the tests of graphs.
#include <array>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "atlas/base/json.h"
#include "procedural/graph/evaluator.h"
#include "procedural/graph/json.h"
#include "procedural/graph/table.h"

namespace burl {

/// A graph as JSON that uses one node.
struct GraphCase {
    std::string_view node, json;
};

/// Whether a node is a function that another program defines, of which no shader is written.
inline bool on_the_host_alone(const NodeType& type) {
    return type.name.starts_with("blender_") || type.name.starts_with("materialx_");
}

// Inputs vary over the solid, so that every product and chain rule counts.
inline constexpr std::array graph_cases{
    GraphCase{"constant", R"({"node": "constant", "value": "#8040c0a0"})"},
    GraphCase{"coordinate",
              R"({"node": "coordinate", "direction": [0.5, -2, 1.5], "offset": 0.3})"},
    GraphCase{"point", R"({"node": "point"})"},
    GraphCase{"add", R"({"node": "add", "a": {"node": "fbm"}, "b": {"node": "coordinate"}})"},
    GraphCase{"subtract",
              R"({"node": "subtract", "a": {"node": "fbm"}, "b": {"node": "coordinate"}})"},
    GraphCase{"multiply",
              R"({"node": "multiply", "a": {"node": "fbm"}, "b": {"node": "coordinate"}})"},
    GraphCase{"divide", R"({"node": "divide", "a": {"node": "coordinate"},
        "b": {"node": "subtract", "a": {"node": "fbm"}, "b": 3}})"},
    GraphCase{"min", R"({"node": "min", "a": {"node": "fbm"}, "b": {"node": "fbm", "seed": 9}})"},
    GraphCase{"max", R"({"node": "max", "a": {"node": "fbm"}, "b": {"node": "fbm", "seed": 9}})"},
    GraphCase{"clamp", R"({"node": "clamp", "low": -0.2, "high": 0.1, "input": {"node": "fbm"}})"},
    GraphCase{"remap", R"({"node": "remap", "in_low": -0.5, "in_high": 0.5, "out_low": 1.5,
        "out_high": -0.5, "input": {"node": "fbm"}})"},
    GraphCase{"abs", R"({"node": "abs", "input": {"node": "fbm"}})"},
    GraphCase{"power", R"({"node": "power", "exponent": 2.5,
        "input": {"node": "add", "a": 0.5, "b": {"node": "fbm"}}})"},
    GraphCase{"sin", R"({"node": "sin", "input": {"node": "multiply", "a": 5,
        "b": {"node": "fbm", "octaves": 2}}})"},
    // The slope of a plane is constant, so the gradient 0, which is all that the node gives, is
    // right.
    GraphCase{"slope", R"({"node": "slope", "direction": [1, -2, 3],
        "input": {"node": "coordinate", "direction": [0.5, 4, 2]}})"},
    GraphCase{"floor", R"({"node": "floor", "input": {"node": "coordinate"}})"},
    GraphCase{"fract", R"({"node": "fract", "input": {"node": "coordinate"}})"},
    GraphCase{"smoothstep", R"({"node": "smoothstep", "low": -0.4, "high": 0.6,
        "input": {"node": "fbm"}})"},
    GraphCase{"length", R"({"node": "length", "x": {"node": "fbm"},
        "y": {"node": "fbm", "seed": 9}, "z": {"node": "coordinate"}})"},
    GraphCase{"distance",
              R"({"node": "distance", "point": [0.3, -0.2, 0.5], "weights": [1, 2, -0.5]})"},
    GraphCase{"dot", R"({"node": "dot", "x": {"node": "fbm"}, "y": {"node": "fbm", "seed": 9},
        "z": {"node": "coordinate"}, "direction": [1, -2, 0.5]})"},
    GraphCase{"scale", R"({"node": "scale", "a": "#ff804020", "b": {"node": "fbm"}})"},
    GraphCase{"mix", R"({"node": "mix", "a": {"node": "marble", "spline": "bspline"},
        "b": "#20408060", "amount": {"node": "fbm"}})"},
    GraphCase{"bilerp", R"({"node": "bilerp", "v00": 0.1, "v01": {"node": "fbm"}, "v10": "#ff0080",
        "v11": 2})"},
    GraphCase{"color_map", R"({"node": "color_map", "wrap": "repeat",
        "stops": [[0, "#102030"], [0.3, "#f0e0d0"], [0.7, "#4080c060"], [1, "#102030"]],
        "input": {"node": "fbm"}})"},
    GraphCase{"layer_over", R"({"node": "layer_over", "top": {"node": "color_map",
        "stops": [[0, "#80ff4010"], [0.6, "#80ff40c0"], [1, "#20408080"]],
        "input": {"node": "coordinate", "direction": [0.3, 0.1, -0.2]}},
        "base": {"node": "scale", "a": "#ff0000c0", "b": {"node": "fbm"}},
        "opacity": {"node": "smoothstep", "input": {"node": "coordinate"}}})"},
    GraphCase{"blend", R"({"node": "blend", "mode": "soft_light",
        "top": {"node": "scale", "a": "#ff8040c0", "b": {"node": "ramp", "period": 3}},
        "base": {"node": "mix", "a": "#ffe0c0", "b": "#203040a0", "amount": {"node": "fbm"}},
        "opacity": 0.8, "mask": {"node": "smoothstep", "input": {"node": "coordinate"}}})"},
    GraphCase{"image", R"({"node": "map_uv", "scale": [0.3, 0.2],
        "input": {"node": "image", "file": "image.png", "lookup": "ewa"}})"},
    GraphCase{"combine", R"({"node": "combine", "red": {"node": "fbm"},
        "green": {"node": "coordinate"}, "blue": 0.3,
        "alpha": {"node": "remap", "in_low": -1, "input": {"node": "fbm", "seed": 9}}})"},
    GraphCase{"split", R"({"node": "split", "input": {"node": "combine", "red": {"node": "fbm"},
        "green": {"node": "coordinate"}, "blue": 0.3, "alpha": {"node": "remap", "in_low": -1,
        "out_low": 0.2, "input": {"node": "fbm", "seed": 9}}}})"},
    GraphCase{"hsv", R"({"node": "hsv", "hue": {"node": "coordinate"}, "saturation": 1.3,
        "value": {"node": "add", "a": 1, "b": {"node": "fbm", "seed": 9}},
        "input": {"node": "mix", "a": "#ff8040", "b": "#2040c0a0", "amount": {"node": "fbm"}}})"},
    GraphCase{"levels", R"({"node": "levels", "in_black": 0.05, "in_white": 0.7, "gamma": 0.8,
        "out_black": 0.9, "out_white": 0.1,
        "input": {"node": "mix", "a": "#ff8040", "b": "#2040c0a0", "amount": {"node": "fbm"}}})"},
    GraphCase{"uv", R"({"node": "uv"})"},
    GraphCase{"checkerboard", R"({"node": "checkerboard", "a": {"node": "fbm"}, "b": "#ff8000"})"},
    GraphCase{"checkerboard_3d",
              R"({"node": "checkerboard_3d", "a": {"node": "fbm"}, "b": "#ff8000"})"},
    GraphCase{"stripes", R"({"node": "stripes", "direction": [1, 2, -1], "period": 0.7,
        "a": {"node": "fbm"}})"},
    GraphCase{"ramp", R"({"node": "ramp", "direction": [1, 2, -1], "period": 0.7, "a": "#ff8000",
        "b": {"node": "fbm"}})"},
    GraphCase{"sine", R"({"node": "sine", "direction": [1, 2, -1], "period": 0.7})"},
    GraphCase{"rings", R"({"node": "rings", "spacing": 0.4, "a": {"node": "fbm"}})"},
    GraphCase{"wood_grain", R"({"node": "wood_grain", "spacing": 0.4, "wobble": 0.3, "wobbles": 4,
        "twist": 1.5, "profile": "ramp"})"},
    GraphCase{"tiles", R"({"node": "tiles", "gives": "u", "a": {"node": "fbm"}, "b": "#ff8000",
        "width": 0.7, "height": 1.3})"},
    GraphCase{"bricks", R"({"node": "bricks", "a": {"node": "fbm"}, "b": "#ff8000", "depth": 0.8,
        "offset": 0.3, "joint": 0.1})"},
    GraphCase{"planks", R"({"node": "planks", "gives": "id", "a": {"node": "fbm"}, "seed": 3})"},
    GraphCase{"hexagons",
              R"({"node": "hexagons", "width": 0.7, "joint": 0.1, "a": {"node": "fbm"}})"},
    GraphCase{"herringbone", R"({"node": "herringbone", "gives": "edge", "ratio": 3})"},
    GraphCase{"cells", R"({"node": "cells", "gives": "edge", "jitter": 0.9, "seed": 7})"},
    GraphCase{"scatter", R"({"node": "scatter", "shape": "star", "gives": "edge", "a": 0.1,
        "chance": 0.9, "largest": 0.6})"},
    GraphCase{"field", R"({"node": "field", "quadric": {"A": 1, "F": -0.5, "I": 2}, "noise": [
        {"kind": "perlin", "octaves": 3, "matrix": [1, 2, 0, 0.1, 0, 1, -1, 0.2, 0.5, 0, 3, 0.3]},
        {"kind": "value", "fade": "quintic", "frequency": [2, 3, 1]}]})"},
    GraphCase{"fbm", R"({"node": "fbm", "octaves": 5, "lacunarity": 1.9, "gain": 0.6})"},
    GraphCase{"wrinkled", R"({"node": "wrinkled", "octaves": 3, "seed": 5})"},
    GraphCase{"windy", R"({"node": "windy", "octaves": 4})"},
    GraphCase{"simplex_nd", R"({"node": "simplex_nd", "dimensions": 6, "signal": "wave",
        "waves": 1.5, "octaves": 3, "x4": {"node": "fbm", "octaves": 2}, "x5": 0.3,
        "x6": {"node": "coordinate", "direction": [0.5, -2, 1.5]}})"},
    GraphCase{"fibre", R"({"node": "fibre", "direction": [1, 2, -1], "length": 1.5, "width": 0.3,
        "wave": 0.2, "octaves": 2})"},
    GraphCase{"marble", R"({"node": "marble", "variation": 2, "octaves": 3})"},
    GraphCase{"bumps", R"({"node": "bumps", "frequency": [3, 2, 1], "a": {"node": "fbm"},
        "b": "#ffffff"})"},
    GraphCase{"dots", R"({"node": "dots", "a": {"node": "fbm"}, "b": "#ff0000"})"},
    GraphCase{"transform", R"({"node": "transform", "scale": [2, 0.5, 1], "rotate": [30, 40, -50],
        "translate": [1, 2, 3], "matrix": [1, 0.5, 0, 1, 0, 2, 0.3, 0, -0.5, 0, 1, 2],
        "input": {"node": "fbm", "octaves": 2}})"},
    GraphCase{"warp", R"({"node": "warp", "strength": 0.4, "octaves": 2,
        "input": {"node": "fbm", "octaves": 2}})"},
    GraphCase{"curl", R"({"node": "curl", "strength": 0.4, "scale": 0.8, "steps": 2, "octaves": 2,
        "time": 0.3, "input": {"node": "fbm", "octaves": 2}})"},
    GraphCase{"map_uv", R"({"node": "map_uv", "scale": [3, -2], "offset": [0.5, 0.1],
        "input": {"node": "fbm", "octaves": 2}})"},
    GraphCase{"map_spherical", R"({"node": "map_spherical", "input": {"node": "map_uv",
        "scale": [4, 8], "input": {"node": "fbm", "octaves": 2}}})"},
    GraphCase{"map_cylindrical", R"({"node": "map_cylindrical", "height": "normalized",
        "input": {"node": "map_uv", "scale": [8, 4], "input": {"node": "fbm", "octaves": 2}}})"},
    GraphCase{"map_planar", R"({"node": "map_planar", "vs": [1, 0.5, -2], "vt": [0, 1, 1],
        "offset": [0.25, 4], "input": {"node": "fbm", "octaves": 2}})"}};

inline Image<Rgb8> random_image(std::size_t width, std::size_t height) {
    std::mt19937 random(3);
    Image<Rgb8> image(width, height);
    for (std::size_t y = 0; y < image.height(); ++y)
        for (Rgb8& c : image.row(y))
            c = {std::uint8_t(random()), std::uint8_t(random()), std::uint8_t(random())};
    return image;
}

/// Returns the image that every case reads.
inline Image<Rgb8> case_image(const std::string&) {
    return random_image(12, 16);
}

inline TextureGraph graph_of(std::string_view json) {
    return graph_from_json(nlohmann::ordered_json::parse(json),
                           [](const std::string& file, ImageWrap wrap) {
                               return std::make_shared<const MipImage>(case_image(file), wrap);
                           });
}

/// Returns one channel at a point.
inline Dual sample_of(const TextureGraph& graph, const Vec3d& point,
                      const Footprint& footprint = {}, std::size_t channel = 0) {
    return GraphEvaluator(graph)(point, footprint).channels[channel];
}

inline double value_of(std::string_view json, const Vec3d& point, const Footprint& footprint = {}) {
    return sample_of(graph_of(json), point, footprint).value;
}

inline std::vector<Vec3d> random_points(std::size_t count, double reach, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(-reach, reach);
    std::vector<Vec3d> points(count);
    for (Vec3d& p : points) p = {coordinate(random), coordinate(random), coordinate(random)};
    return points;
}

/// Expects that a batch of points gives, to the bit, what every point gives by itself.
inline void expect_batches_equal_points(const GraphEvaluator& evaluate,
                                        const std::vector<Vec3d>& points,
                                        const std::vector<Footprint>& footprints,
                                        std::string_view name) {
    GraphEvaluator::Scratch scratch = evaluate.make_scratch(), other = evaluate.make_scratch();
    std::vector<GraphSample> all(points.size());
    evaluate(points, footprints, scratch, all);
    for (std::size_t i = 0; i < points.size(); i += 23) {
        GraphSample one;
        evaluate({&points[i], 1}, {&footprints[i], 1}, other, {&one, 1});
        for (std::size_t c = 0; c < 4; ++c) {
            EXPECT_EQ(one.channels[c].value, all[i].channels[c].value) << name;
            EXPECT_EQ(one.channels[c].slope, all[i].channels[c].slope) << name;
        }
    }
}

}  // namespace burl
