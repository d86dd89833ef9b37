#pragma once
// Small graphs for every node of MaterialX's functions, as graph/cases.h has for the others: no
// shader is written of these.
#include "tests/procedural/graph/cases.h"

namespace burl {

// Inputs vary over the solid, so that every product and chain rule counts.
inline constexpr std::array materialx_cases{
    GraphCase{"materialx_noise", R"({"node": "materialx_noise"})"},
    GraphCase{"materialx_noise", R"({"node": "materialx_noise", "dimensions": "2"})"},
    GraphCase{"materialx_noise_color", R"({"node": "materialx_noise_color", "position":
        {"node": "materialx_vector_math", "operation": "add", "a": {"node": "point"},
        "b": {"node": "materialx_noise"}}})"},
    GraphCase{"materialx_fractal", R"({"node": "materialx_fractal", "octaves": 3,
        "lacunarity": {"node": "remap", "input": {"node": "coordinate"}, "out_low": 1.9,
        "out_high": 2.3}, "diminish": {"node": "fbm", "octaves": 2}})"},
    GraphCase{"materialx_fractal_color", R"({"node": "materialx_fractal_color",
        "dimensions": "2", "octaves": 2.7})"},
    GraphCase{"materialx_cellnoise", R"({"node": "materialx_cellnoise"})"},
    GraphCase{"materialx_cellnoise_color", R"({"node": "materialx_cellnoise_color"})"},
    GraphCase{"materialx_worley", R"({"node": "materialx_worley",
        "jitter": {"node": "fbm", "octaves": 2}})"},
    GraphCase{"materialx_worley", R"({"node": "materialx_worley", "style": "solid"})"},
    GraphCase{"materialx_worley_color", R"({"node": "materialx_worley_color", "jitter": 0.8})"},
    GraphCase{"materialx_worley_color", R"({"node": "materialx_worley_color", "dimensions": "2"})"},
    GraphCase{"materialx_math", R"({"node": "materialx_math", "operation": "smoothstep",
        "a": {"node": "coordinate"}, "b": {"node": "fbm", "octaves": 2}, "c": 1.5})"},
    GraphCase{"materialx_math", R"({"node": "materialx_math", "operation": "safepower",
        "a": {"node": "coordinate"}, "b": {"node": "materialx_noise"}})"},
    GraphCase{"materialx_math", R"({"node": "materialx_math", "operation": "modulo",
        "a": {"node": "coordinate"}, "b": {"node": "coordinate", "direction": [0, 1, 0]}})"},
    GraphCase{"materialx_math", R"({"node": "materialx_math", "operation": "acos",
        "a": {"node": "materialx_noise"}})"},
    GraphCase{"materialx_math", R"({"node": "materialx_math", "operation": "overlay",
        "a": {"node": "materialx_worley"}, "b": {"node": "materialx_noise"}, "c": 0.7})"},
    GraphCase{"materialx_vector_math", R"({"node": "materialx_vector_math", "operation":
        "rotate3d", "a": {"node": "point"}, "b": {"node": "combine", "red":
        {"node": "fbm", "octaves": 2}, "green": 0.7, "blue": -0.4},
        "c": {"node": "coordinate", "direction": [30, 0, 0]}})"},
    GraphCase{"materialx_vector_math", R"({"node": "materialx_vector_math", "operation":
        "refract", "a": {"node": "point"}, "b": {"node": "materialx_noise_color"}, "c": 0.4})"},
    GraphCase{"materialx_vector_math", R"({"node": "materialx_vector_math", "operation":
        "hsvtorgb", "a": {"node": "point"}})"},
};

}  // namespace burl
