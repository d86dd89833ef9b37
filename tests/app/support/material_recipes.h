#pragma once
// A material of which every channel varies, with bumps.

namespace burl::test {

/// The recipe's JSON; `share` runs from 0 to 1 and has both.
inline constexpr const char* all_channels = R"({
  "burl": 1,
  "define": {
    "noise": {"node": "transform", "scale": [3, 3, 3], "input": {"node": "fbm", "octaves": 1, "seed": 1}},
    "share": {"node": "smoothstep", "low": -0.3, "high": 0.3, "input": "noise"},
    "hue": {"node": "color_map", "wrap": "clamp", "stops": [[0, "#a47747"], [1, "#5b3e24"]], "input": "share"}
  },
  "material": {
    "base_color": "hue",
    "roughness": {"node": "multiply", "a": 0.7, "b": "share"},
    "metallic": {"node": "subtract", "a": 1, "b": "share"},
    "occlusion": {"node": "multiply", "a": 0.5, "b": "share"},
    "specular": {"node": "multiply", "a": 0.9, "b": "share"},
    "clearcoat": {"node": "multiply", "a": 0.8, "b": "share"},
    "clearcoat_roughness": {"node": "multiply", "a": 0.3, "b": "share"},
    "sheen": "hue",
    "sheen_roughness": {"node": "multiply", "a": 0.6, "b": "share"},
    "transmission": {"node": "multiply", "a": 0.4, "b": "share"},
    "emissive": "hue",
    "height": "share"
  },
  "bump": {"height": 0.01}
})";

}  // namespace burl::test
