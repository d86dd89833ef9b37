// A recipe's channels at points against recipes whose base colour is that channel.
#include "app/direct/point_material.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "atlas/base/error.h"
#include "procedural/color/srgb.h"

namespace burl {
namespace {

constexpr const char* grain_node = R"({"node": "fbm", "octaves": 3, "seed": 7})";
constexpr const char* hue_node = R"({"node": "color_map", "input": {"node": "fbm", "seed": 2},
    "stops": [[0, "#102030"], [1, "#ffe0a0"]]})";

const Vec3d shaded_places[] = {{0.1, 0.2, 0.3}, {3.4, -1.2, 0.7}, {-8.25, 2.5, 4.125}};

PointMaterial point_material_of(const std::string& json) {
    const Recipe recipe = parse_recipe(json, "test");
    return point_material(recipe, FilterKind::none, shown_color(recipe, FilterKind::none), false);
}

Vec3d colour_at(const std::string& node, const Vec3d& s) {
    const Recipe recipe = parse_recipe(R"({"texture": )" + node + "}", "test");
    return Vec3d(filtered_color(recipe, FilterKind::none)(s, {}));
}

TEST(PointMaterial, NumbersAndColoursFollowTheirNodes) {
    for (const char* name : {"metallic", "roughness", "occlusion", "specular", "clearcoat",
                             "clearcoat_roughness", "sheen_roughness", "transmission"}) {
        const PointMaterial at =
            point_material_of(R"({"material": {"base_color": )" + std::string(hue_node) + R"(, ")" +
                              name + R"(": )" + grain_node + R"(, "emissive": )" + hue_node +
                              R"(, "emissive_strength": 3, "sheen": )" + hue_node + "}}");
        for (const Vec3d& s : shaded_places) {
            const MaterialSample sample = at(s, {});
            const std::vector<std::pair<std::string, double>> numbers{
                {"metallic", sample.point.metallic},
                {"roughness", sample.point.roughness},
                {"occlusion", sample.point.occlusion},
                {"specular", sample.point.specular},
                {"clearcoat", sample.point.clearcoat},
                {"clearcoat_roughness", sample.point.clearcoat_roughness},
                {"sheen_roughness", sample.point.sheen_roughness},
                {"transmission", sample.point.transmission}};
            for (const auto& [channel, number] : numbers) {
                const double expected = std::clamp(colour_at(grain_node, s).x, 0.0, 1.0);
                EXPECT_NEAR(channel == name ? number : expected, expected, 1e-12);
            }
            const Vec3d hue = colour_at(hue_node, s);
            EXPECT_LT(glm::length(sample.point.base - hue), 1e-12);
            EXPECT_LT(glm::length(sample.point.sheen - hue), 1e-12);
            EXPECT_LT(glm::length(sample.point.emissive - 3.0 * hue), 1e-12);
            EXPECT_EQ(sample.alpha, 1.0);
        }
    }
}

TEST(PointMaterial, NumbersThatDoNotVaryAreTheMaterials) {
    const PointMaterial at = point_material_of(
        R"({"material": {"base_color": "#ff8000", "roughness": 0.25, "metallic": 1, "ior": 1.7,
            "clearcoat": 0.5, "emissive": "#ff0000", "emissive_strength": 2, "sheen": "#00ff00"}})");
    const MaterialSample sample = at({1.0, 2.0, 3.0}, {});
    EXPECT_EQ(sample.point.roughness, 0.25);
    EXPECT_EQ(sample.point.metallic, 1.0);
    EXPECT_EQ(sample.point.ior, 1.7);
    EXPECT_EQ(sample.point.clearcoat, 0.5);
    EXPECT_EQ(sample.point.emissive, Vec3d(2.0, 0.0, 0.0));
    EXPECT_EQ(sample.point.sheen, Vec3d(0.0, 1.0, 0.0));
    EXPECT_LT(glm::length(sample.point.base - linear_light({255, 128, 0})), 1e-12);
}

TEST(PointMaterial, ColoursAreNotMultipliedByTheirAlpha) {
    const PointMaterial at =
        point_material_of(R"({"material": {"base_color": "#ff000080", "opacity": )" +
                          std::string(grain_node) + R"(, "roughness": 0.5}})");
    for (const Vec3d& s : shaded_places) {
        const MaterialSample sample = at(s, {});
        const double opacity = std::clamp(colour_at(grain_node, s).x, 0.0, 1.0);
        EXPECT_NEAR(sample.alpha, opacity * 128.0 / 255.0, 1e-12);
        const Vec3d base = sample.alpha > 0.0 ? sample.point.base : Vec3d(1, 0, 0);
        EXPECT_LT(glm::length(base - Vec3d(1, 0, 0)), 1e-12);
    }
}

TEST(PointMaterial, RefusesMasks) {
    try {
        point_material_of(
            R"({"texture": {"node": "fbm"}, "material": {"roughness": {"node": "facing"}}})");
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ExitCode::unsupported);
        EXPECT_THAT(e.what(), testing::HasSubstr("--lazy"));
    }
}

}  // namespace
}  // namespace burl
