#pragma once
// A small graph for every node of Blender's functions, as graph/cases.h has one for the others: no
// shader is written of these.
#include "tests/procedural/graph/cases.h"

namespace burl {

// Vectors and inputs vary over the solid, so that every product and chain rule counts.
inline constexpr std::array blender_cases{
    GraphCase{"blender_noise", R"({"node": "blender_noise", "vector": {"node": "point"},
        "scale": 1.7, "detail": 2.6, "roughness": {"node": "remap", "in_low": -1,
        "input": {"node": "fbm", "octaves": 2}}, "distortion": 0.7})"},
    GraphCase{"blender_noise_color",
              R"({"node": "blender_noise_color", "vector": {"node": "point"}, "scale": 1.7})"},
    GraphCase{"blender_musgrave", R"({"node": "blender_musgrave", "vector": {"node": "point"},
        "kind": "hetero_terrain", "scale": 1.3, "detail": 2.4, "dimension": 0.8, "offset": 0.6})"},
    GraphCase{"blender_voronoi", R"({"node": "blender_voronoi", "vector": {"node": "point"},
        "feature": "smooth_f1", "metric": "minkowski", "scale": 1.3, "smoothness": 0.7,
        "exponent": 1.6, "randomness": 0.8})"},
    GraphCase{"blender_voronoi_color", R"({"node": "blender_voronoi_color", "scale": 2,
        "vector": {"node": "point"}, "gives": "position", "feature": "smooth_f1"})"},
    GraphCase{"blender_wave", R"({"node": "blender_wave", "vector": {"node": "point"},
        "kind": "rings", "scale": 0.3, "distortion": 1.5, "phase": 0.4})"},
    GraphCase{"blender_magic", R"({"node": "blender_magic", "vector": {"node": "point"},
        "scale": 0.4, "depth": 5, "distortion": 0.9})"},
    GraphCase{"blender_gradient",
              R"({"node": "blender_gradient", "vector": {"node": "point"}, "kind": "radial"})"},
    GraphCase{"blender_brick", R"({"node": "blender_brick", "vector": {"node": "point"},
        "gives": "mortar", "scale": 1.4, "mortar": 0.1, "smooth": 1})"},
    GraphCase{"blender_checker", R"({"node": "blender_checker", "vector": {"node": "point"}})"},
    GraphCase{"blender_white_noise", R"({"node": "blender_white_noise", "vector":
        {"node": "blender_vector_math", "operation": "floor", "a": {"node": "point"}}})"},
    GraphCase{"blender_white_noise_color", R"({"node": "blender_white_noise_color", "vector":
        {"node": "blender_vector_math", "operation": "floor", "a": {"node": "point"}}})"},
    GraphCase{"blender_math", R"({"node": "blender_math", "operation": "smooth_min", "c": 0.5,
        "a": {"node": "coordinate"}, "b": {"node": "fbm", "octaves": 2}})"},
    GraphCase{"blender_vector_math", R"({"node": "blender_vector_math", "operation": "project",
        "a": {"node": "point"}, "b": {"node": "combine", "red": {"node": "fbm", "octaves": 2},
        "green": 0.7, "blue": -0.4}})"},
    GraphCase{"blender_map_range", R"({"node": "blender_map_range", "curve": "smootherstep",
        "input": {"node": "coordinate"}, "from_low": -2, "from_high": 3, "to_low": 0.2})"},
    GraphCase{"blender_mix", R"({"node": "blender_mix", "mode": "soft_light", "amount": 0.7,
        "a": {"node": "blender_noise_color", "vector": {"node": "point"}, "scale": 1}, "b":
        {"node": "combine", "red": {"node": "coordinate"}, "green": 0.7, "blue": 0.1}})"},
    GraphCase{"blender_hue_saturation", R"({"node": "blender_hue_saturation", "hue": 0.6,
        "saturation": 0.8, "value": 1.2, "amount": 0.9,
        "input": {"node": "blender_noise_color", "vector": {"node": "point"}, "scale": 1}})"},
    GraphCase{"blender_to_hsv", R"({"node": "blender_to_hsv",
        "input": {"node": "blender_noise_color", "vector": {"node": "point"}, "scale": 1}})"},
    GraphCase{"blender_from_hsv", R"({"node": "blender_from_hsv", "hue": {"node": "coordinate"},
        "saturation": 0.6, "value": {"node": "fbm", "octaves": 2}})"},
    GraphCase{"blender_contrast", R"({"node": "blender_contrast", "bright": 0.1, "contrast": 0.4,
        "input": {"node": "blender_noise_color", "vector": {"node": "point"}, "scale": 1}})"},
    GraphCase{"blender_gamma", R"({"node": "blender_gamma", "gamma": 1.6,
        "input": {"node": "blender_noise_color", "vector": {"node": "point"}, "scale": 1}})"},
};

}  // namespace burl
