// Layers against the W3C's formulas, written for straight colours.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "procedural/color/srgb.h"
#include "procedural/model/texture_json.h"
#include "tests/procedural/graph/cases.h"

namespace burl {
namespace {

/// The blend of straight colours that the W3C's Compositing and Blending Level 1 defines.
double w3c_blend(const std::string& mode, double b, double s) {
    if (mode == "multiply") return b * s;
    if (mode == "screen") return b + s - b * s;
    if (mode == "overlay") return b <= 0.5 ? 2 * b * s : 1 - 2 * (1 - b) * (1 - s);
    if (mode == "add") return b + s;
    if (mode == "darken") return std::min(b, s);
    if (mode == "lighten") return std::max(b, s);
    if (mode == "soft_light") {
        const double d = b <= 0.25 ? ((16 * b - 12) * b + 4) * b : std::sqrt(b);
        return s <= 0.5 ? b - (1 - 2 * s) * b * (1 - b) : b + (2 * s - 1) * (d - b);
    }
    return s;
}

constexpr std::array blend_modes{"normal", "multiply", "screen",  "overlay",
                                 "add",    "darken",   "lighten", "soft_light"};

TEST(GraphBlend, IsThatOfTheWeb) {
    const double opacity = 0.7, mask = 0.9;
    for (const std::string mode : blend_modes)
        for (const auto& [top, base] :
             {std::pair("#ff8040c0", "#20c0ff80"), std::pair("#102030", "#f0e0d0"),
              std::pair("#ffffff40", "#80808000"), std::pair("#c0ffee", "#01020304")}) {
            const std::string json =
                fmt::format(R"({{"node": "blend", "mode": "{}", "top": "{}", "base": "{}",
                                 "opacity": {}, "mask": {}}})",
                            mode, top, base, opacity, mask);
            const GraphSample sample = GraphEvaluator(graph_of(json))({});
            const double as = opacity * mask * alpha_from_hex(top) / 255.0;
            const double ab = alpha_from_hex(base) / 255.0;
            const Rgb8 s8 = color_from_hex(top), b8 = color_from_hex(base);
            EXPECT_NEAR(sample.channels[3].value, as + ab * (1 - as), 1e-15) << json;
            for (const auto& [c, s, b] : {std::tuple(0u, s8.r, b8.r), std::tuple(1u, s8.g, b8.g),
                                          std::tuple(2u, s8.b, b8.b)}) {
                const double cs = srgb_decode(s / 255.0), cb = srgb_decode(b / 255.0);
                const double mixed = (1 - ab) * cs + ab * w3c_blend(mode, cb, cs);
                EXPECT_NEAR(sample.channels[c].value, as * mixed + (1 - as) * ab * cb, 1e-14)
                    << json << c;
            }
        }
}

TEST(GraphBlend, TakesNumbersForOpaqueColours) {
    for (const std::string mode : blend_modes)
        for (const double s : {0.0, 0.2, 0.5, 0.9, 1.0})
            for (const double b : {0.0, 0.1, 0.25, 0.5, 0.8, 1.0}) {
                const std::string json = fmt::format(
                    R"({{"node": "blend", "mode": "{}", "top": {}, "base": {}, "mask": 0.25}})",
                    mode, s, b);
                EXPECT_NEAR(value_of(json, Vec3d(0.0)), 0.25 * w3c_blend(mode, b, s) + 0.75 * b,
                            1e-14)
                    << json;
            }
    EXPECT_EQ(value_of(R"({"node": "blend", "mode": "add", "top": 3, "base": -2})", Vec3d(0.0)),
              1.0);
}

}  // namespace
}  // namespace burl
