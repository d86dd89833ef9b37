#pragma once
// Two small materials with controls of every kind, for tests.

namespace burl::test {

/// Numbers with formulas, whole numbers, array items, and a colour at two places.
inline constexpr const char* planks_json = R"({
  "name": "Planks", "group": "wood", "about": "Boards with dirt between them.",
  "solid": {"scale": 0.5},
  "controls": [
    {"name": "size", "about": "longest side in metres", "range": [0.05, 5],
      "sets": ["solid.scale", "bump.height = 0.001 / x"]},
    {"name": "width", "range": [0.01, 1], "sets": ["define.boards.spacing",
      "define.dust.scale.0 = 1 / x", "define.dust.scale.1 = 1 / x", "define.dust.scale.2 = 1 / x"]},
    {"name": "light", "sets": ["material.base_color.stops.0.1", "define.pale"]},
    {"name": "detail", "range": [1, 8], "sets": ["define.dirt.octaves", "define.dirt.seed = 2 * x"]}
  ],
  "define": {
    "boards": {"node": "rings", "spacing": 0.1},
    "dirt": {"node": "fbm", "octaves": 3, "seed": 6},
    "dust": {"node": "transform", "scale": [10, 10, 10], "input": "dirt"},
    "pale": "#c79d6a"
  },
  "material": {
    "base_color": {"node": "color_map", "wrap": "clamp", "stops": [[0, "#c79d6a"], [1, "#8a5d35"]],
      "input": "boards"},
    "roughness": "dust",
    "emissive": "pale",
    "height": "boards"
  },
  "bump": {"height": 0.002}
})";

/// Constants: as the whole base colour, as a node, as a bare number, and a channel's number.
inline constexpr const char* paint_json = R"({
  "name": "Paint", "group": "glaze", "about": "Red paint with flakes in it.",
  "controls": [
    {"name": "colour", "sets": ["material.base_color"]},
    {"name": "flake size", "range": [0, 1], "sets": ["define.flakes.value", "define.more = 3 * x"]},
    {"name": "metal", "range": [0, 1], "sets": ["material.metallic"]}
  ],
  "define": {"flakes": {"node": "constant", "value": 0.25}, "more": 0.75},
  "material": {"base_color": "#b01020", "roughness": {"node": "mix", "a": "flakes", "b": "more"},
    "metallic": 0.75}
})";

}  // namespace burl::test
